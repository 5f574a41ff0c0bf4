/* The solids that contain a point of a ray, one inside the other: they tell
 * which index of refraction holds, and whether the ray enters or leaves a solid
 * at a boundary. */
#ifndef MURK_PATH_SOLIDS_H
#define MURK_PATH_SOLIDS_H

#include "geometry/surfaces.h"

/* The largest number of solids around a point, far more than glass in water in
 * glass. A photon that enters a further solid is counted as lost. */
#define MURK_PATH_SOLIDS_MAX 8

/* The innermost, whose index holds, comes last. */
typedef struct murk_path_solids {
    int n;
    uint16_t solid[MURK_PATH_SOLIDS_MAX];
    double ior[MURK_PATH_SOLIDS_MAX];
} murk_path_solids;

/* Index of refraction of the innermost solid: 1 outside all. */
double murk_path_solids_index(const murk_path_solids *solids);

/* Goes through the boundary of a solid: removes the solid if it is in the list,
 * else appends it with its index of refraction. False, with nothing changed, if
 * the solid would have to be appended to a full list. */
bool murk_path_solids_cross(murk_path_solids *solids, uint16_t solid,
                            double ior);

/* The solids that contain a point, found along a ray from the point in the unit
 * direction. If solids overlap, the one that this ray leaves first counts as
 * the innermost. */
murk_path_solids murk_path_solids_around(const murk_surfaces *surfaces,
                                         murk_vec3 point, murk_vec3 direction);

#endif
