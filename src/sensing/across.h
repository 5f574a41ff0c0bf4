/* Sightlines from a sensor to a photon on the other side of a boundary between
 * two refractive indices (through: refract). For use inside src/sensing only.
 *
 * Range and field of view refer to the apparent position of the photon: the
 * direction from which the light arrives, at the apparent distance of
 * sensing/snell.h. The normal of a surface photon must face the crossing of the
 * boundary, and a type that detects only light that travels toward the sensor
 * (`toward`) compares the photon's direction with the part of the path between
 * crossing and photon. */
#ifndef MURK_SENSING_ACROSS_H
#define MURK_SENSING_ACROSS_H

#include "sensing/facing.h"
#include "sensing/sight_parts.h"

typedef struct murk_across {
    const murk_sight *sight; /* settings */
    murk_row_counts *counts; /* tests and losses are added */
    const murk_path_viewpoint *sensor;
    const murk_field *field;
    double range_m;
} murk_across;

/* Writes the open sightlines from the sensor to the photon to line[] and
 * returns their number. `from` is the end of the sightlines: the place of the
 * photon, for a surface photon moved off the surface (murk_side_start() in
 * sensing/facing.h). `index` is the refractive index at `from`. `facing` is the
 * side of the surface, NULL for volume photons. */
size_t murk_across_sightlines(const murk_across *across,
                              const murk_photon *photon,
                              const murk_side *facing, murk_vec3 from,
                              double index,
                              murk_sightline line[MURK_REFRACTED_PATHS_MAX]);

#endif
