/* Sightlines from a sensor to a photon on the other side of a boundary between
 * two refractive indices (through: refract). Internal to the room.
 *
 * Range and field of view refer to the apparent position of the photon: the
 * direction from which the light arrives, at the apparent distance of
 * sensing/snell.h. The tests of the photon's own side, and of light that
 * travels toward the sensor, refer to the part of the path at the photon. */
#ifndef MURK_SENSING_ACROSS_H
#define MURK_SENSING_ACROSS_H

#include "base/tally.h"
#include "photonmap/map.h"
#include "sensing/facing.h"
#include "sensing/refract.h"
#include "sensing/sensor.h"

typedef struct murk_across {
    const murk_interfaces *interfaces;
    const murk_path_viewpoint *sensor;
    const murk_surfaces *surfaces;
    const murk_field *field;
    bool through_sheets;
    double range_m, position_error_m;
    murk_tally *shadow_rays; /* paths tested against surfaces */
    murk_tally *blocked;     /* photons without a path, lost to boundaries */
    murk_tally
        *reflected; /* photons without a path, lost to total reflection */
} murk_across;

/* A path of light from photon to sensor. */
typedef struct murk_sightline {
    double transmittance;
    murk_vec3 way; /* from the sensor to the apparent position of the photon */
    murk_vec3 leaving; /* unit direction in which light leaves the photon */
    double gain;       /* factor on radiance across the boundary: (n sensor / n
                          photon)^2 */
} murk_sightline;

/* Writes the open sightlines and returns their number. `from` is the photon's
 * position, moved off the surface, in a medium of index `index`; facing is NULL
 * for volume photons. */
size_t murk_across_sightlines(const murk_across *across,
                              const murk_photon *photon,
                              const murk_side *facing, murk_vec3 from,
                              double index,
                              murk_sightline line[MURK_REFRACTED_PATHS_MAX]);

#endif
