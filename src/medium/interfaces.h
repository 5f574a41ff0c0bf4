/* Interfaces: boundaries of regions with an index of refraction. The functions
 * find the next interface along a ray and the index in a set of regions.
 *
 * A ray carries the set of refractive regions that it is in. The set, not the
 * position, tells on which side of a boundary the ray is. A ray may therefore
 * start exactly on the boundary that it has just crossed or was reflected at:
 * rounding cannot put it on the wrong side, and no position is ever shifted.
 *
 * The index on a ray is that of the last listed region of the set, and 1 if the
 * set is empty: a boundary inside a region that is listed later has no effect.
 * Boundaries at most MURK_INTERFACE_NEAR, times the largest coordinate of the
 * domain, behind the nearest one are crossed together with it in one step, as
 * for stacked slabs. A face of a box or half space on a side of the domain, or
 * beyond it, is no boundary: the region continues there.
 *
 * This file handles half spaces, boxes and spheres. Of meshes src/medium knows
 * the index only: the caller maintains their bits of the set. */
#ifndef MURK_MEDIUM_INTERFACES_H
#define MURK_MEDIUM_INTERFACES_H

#include "medium/media.h"

typedef struct murk_boundary {
    double distance_m;
    murk_inside
        crossed;   /* regions entered or left; with `inside` the set before the
                      boundary, the set beyond is inside ^ crossed */
    size_t region; /* the last listed of these regions */
    murk_vec3 normal; /* unit normal of that region's boundary, on the side of
                         the ray's origin */
    double mean_square_slope; /* mean square slope of that region's waves; 0:
                                 flat */
} murk_boundary;

/* A flat boundary: the whole plane of a face of a box or of the surface of a
 * half space. Of a box, only a part of the plane bounds the region. */
typedef struct murk_flat {
    size_t region;
    murk_vec3 point, normal; /* unit normal, out of the region */
} murk_flat;

/* A box has six faces. */
#define MURK_FLATS_MAX (6 * (size_t)MURK_REGIONS_MAX)

/* Writes all flat boundaries in the order of regions and returns the number. */
size_t murk_media_flats(const murk_media *media,
                        murk_flat flat[MURK_FLATS_MAX]);

/* Writes 1 for the outside, then the index of each region that has one,
 * repeated indices too; returns the number of entries. */
size_t murk_media_indices(const murk_media *media,
                          double index[MURK_REGIONS_MAX + 1]);

/* True if any region has an index of refraction. */
bool murk_media_bends(const murk_media *media);

/* The refractive regions that contain a point, meshes left out. A box contains
 * its faces at the low end of each axis and not those at the high end; a half
 * space or sphere does not contain its boundary. */
murk_inside murk_media_inside(const murk_media *media, murk_vec3 point);

/* The index of refraction inside a set of regions: that of the last listed one
 * that has an index; 1 if there is none. */
double murk_media_index(const murk_media *media, murk_inside inside);

/* Finds the nearest boundary ahead and closer than max_m. False, with *boundary
 * unchanged, if there is none or a number is NaN. Distances are >= 0. */
bool murk_media_boundary(const murk_media *media, murk_inside inside,
                         murk_vec3 origin, murk_vec3 direction, double max_m,
                         murk_boundary *boundary);

/* The set of regions of a ray that has left a periodic domain across an axis (0
 * x, 1 y) and continues at `point` on the opposite side. A region that reaches
 * both sides of the domain along the axis, and any mesh, stays as it was; any
 * other region is in the result if it contains `point`. */
murk_inside murk_media_wrapped(const murk_media *media, murk_inside inside,
                               murk_vec3 point, int axis);

#endif
