/* Boundaries of regions that have an index of refraction: where a ray meets
 * the next one, and whose index holds.
 *
 * A ray carries the set of refractive regions that it is in. The set, not the
 * position, says on which side of a boundary the ray is, so it may stand on
 * the boundary that it has just crossed or was reflected at: rounding puts it
 * on neither side, and nothing is ever nudged.
 *
 * The index that holds is that of the region listed last among those that the
 * ray is in, and 1 outside all: a boundary hidden under a later region changes
 * nothing. Boundaries that lie within MURK_INTERFACE_NEAR of each other are one
 * and are crossed in one step, as where slabs are stacked. A box's face in a
 * side of the domain, or beyond it, is no boundary: the region goes on there.
 *
 * Boundaries here are those of half spaces, boxes and spheres. Of meshes this
 * room knows the index alone: their bits of the set are the caller's. */
#ifndef MURK_MEDIUM_INTERFACES_H
#define MURK_MEDIUM_INTERFACES_H

#include "medium/media.h"

/* Times the domain's largest coordinate: far above rounding (some 1e-15), far
 * below any film that rays could describe. */
#define MURK_INTERFACE_NEAR 1e-12

typedef struct murk_boundary {
    double distance_m;
    murk_inside crossed; /* regions that begin or end here; beyond the boundary
                            the set is inside ^ crossed */
    size_t region;       /* the last listed of them */
    murk_vec3 normal; /* unit, that region's, faces where the ray came from */
    double mean_square_slope; /* that region's; 0: level */
} murk_boundary;

/* A flat boundary: a face of a box, or the level of a half space. It ends where
 * the region does, which the plane alone does not say. */
typedef struct murk_flat {
    size_t region;
    murk_vec3 point, normal; /* unit, out of the region */
} murk_flat;

#define MURK_FLATS_MAX (6 * (size_t)MURK_REGIONS_MAX)

/* Writes all there are, in the order of regions; returns how many. */
size_t murk_media_flats(const murk_media *media,
                        murk_flat flat[MURK_FLATS_MAX]);

/* Writes the indices that regions have, equal ones as often as there are, and 1
 * for outside of them; returns how many. */
size_t murk_media_indices(const murk_media *media,
                          double index[MURK_REGIONS_MAX + 1]);

/* Whether any region has an index of refraction. */
bool murk_media_bends(const murk_media *media);

/* The refractive regions around a point, but for meshes: lower faces belong to
 * a region and upper faces do not, as for all regions. */
murk_inside murk_media_inside(const murk_media *media, murk_vec3 point);

/* The index of refraction in these regions. */
double murk_media_index(const murk_media *media, murk_inside inside);

/* The nearest boundary ahead and nearer than max_m. False when there is none,
 * also where a number is NaN. Distances are >= 0. */
bool murk_media_boundary(const murk_media *media, murk_inside inside,
                         murk_vec3 origin, murk_vec3 direction, double max_m,
                         murk_boundary *boundary);

/* The set of a ray that has left a periodic domain across an axis (0 x, 1 y)
 * and goes on at `point` of the opposite side: only regions that reach both
 * sides go on, too. */
murk_inside murk_media_wrapped(const murk_media *media, murk_inside inside,
                               murk_vec3 point, int axis);

#endif
