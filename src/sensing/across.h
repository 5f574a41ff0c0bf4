/* What a sensor sees of a photon on the other side of a boundary where the
 * index of refraction changes (through: refract). Internal to the room.
 *
 * Range and view are those of where it appears: in the direction in which its
 * light comes in, at the distance of sensing/snell.h. Its own side, and light
 * that travels toward the sensor, are those of the leg at its end. */
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
    murk_tally *shadow_rays; /* ways tested against surfaces */
    murk_tally *blocked;     /* photons without a way: by boundaries */
    murk_tally *reflected;   /* and by total reflection */
} murk_across;

/* One way by which light comes from photon to sensor. */
typedef struct murk_sightline {
    double transmittance;
    murk_vec3 way;     /* from the sensor to where the photon appears */
    murk_vec3 leaving; /* unit, from the photon on */
    double gain; /* of radiance for what boundaries let through: (n sensor / n
                    photon)^2 */
} murk_sightline;

/* Writes the ways that are open; returns how many. `from` is the photon's place
 * moved off its surface, of index `index`; facing NULL in the volume. */
size_t murk_across_look(const murk_across *across, const murk_photon *photon,
                        const murk_side *facing, murk_vec3 from, double index,
                        murk_sightline line[MURK_WAYS_MAX]);

#endif
