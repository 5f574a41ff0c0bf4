/* Ways from a sensor to a photon across one flat boundary between two indices
 * of refraction, by Snell's law. Internal to the room.
 *
 * A way goes straight to a flat face (a half space's level, a face of a box,
 * and of meshes the face that the straight line first meets), is bent there as
 * sensing/snell.h says, and goes straight on to the photon; the index changes
 * nowhere else. There may be several, through different faces of a box: the
 * photon is then seen as often, and its clearest way counts. Where a sensor and
 * a photon have one index about them the straight line alone is a way. */
#ifndef MURK_SENSING_REFRACT_H
#define MURK_SENSING_REFRACT_H

#include "medium/interfaces.h"
#include "path/viewpoint.h"
#include "sensing/snell.h"

/* What bends in a world, made ready once. */
typedef struct murk_interfaces {
    double near_m; /* faces within this of each other are one */
    bool any_mesh; /* some mesh is a region with an index */
    size_t n, indices;
    murk_flat flat[MURK_FLATS_MAX];
    double index[MURK_REGIONS_MAX + 1];
} murk_interfaces;

void murk_interfaces_find(murk_interfaces *out, const murk_path_space *space);

typedef struct murk_way {
    murk_snell snell;
    murk_vec3 photon; /* the image of it that the crossing is next to */
} murk_way;

/* A point sees at most three faces of a box. */
#define MURK_WAYS_MAX 4

/* Writes the ways to a photon where the index is another than about the sensor
 * (photon_index); returns how many. Where there is none, *is_reflected says
 * whether the straight line meets the first boundary from the denser side
 * beyond the critical angle. */
size_t murk_ways_across(const murk_interfaces *interfaces,
                        const murk_path_viewpoint *sensor, murk_vec3 photon,
                        double photon_index, murk_way way[MURK_WAYS_MAX],
                        bool *is_reflected);

/* Nothing that appears nearer than range_m through a face is farther from the
 * sensor than this [m]; may be infinite. */
double murk_ways_reach(const murk_interfaces *interfaces,
                       const murk_path_viewpoint *sensor, double range_m);

/* Both legs: what media let through, whether surfaces block, what thin sheets
 * let through. What lies in the boundary counts once. */
double murk_way_transmittance(const murk_way *way,
                              const murk_path_viewpoint *sensor, int band);
bool murk_way_blocked(const murk_way *way, const murk_path_viewpoint *sensor,
                      const murk_surfaces *surfaces, bool through_sheets);
double murk_way_sheets(const murk_way *way, const murk_path_viewpoint *sensor,
                       const murk_surfaces *surfaces, int band);

#endif
