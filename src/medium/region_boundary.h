/* The boundary of one refractive region, as rays look at it. Inside this room
 * only. */
#ifndef MURK_MEDIUM_REGION_BOUNDARY_H
#define MURK_MEDIUM_REGION_BOUNDARY_H

#include "medium/media.h"

typedef struct murk_region_boundary {
    size_t region;
    murk_region_shape shape;
    double ior;
    double mean_square_slope; /* of a half space; 0: level */
    bool is_moved;            /* to_local is not the identity */
    bool spans[2];            /* reaches both sides of the domain, in x, in y */
    murk_affine to_local;
    murk_box box;     /* in its own frame; faces that no ray is to meet, since
                         they lie in a side of the domain or beyond, are moved
                         away to infinity. Half spaces: up to the level */
    murk_vec3 center; /* spheres, in their own frame */
    double radius;
} murk_region_boundary;

/* Tolerance for faces in such a domain [m]: medium/interfaces.h. */
double murk_region_boundary_near(const murk_box *domain);

/* Fills the shell of a placed region with an index. False when its placement
 * cannot be inverted. */
bool murk_region_boundary_make(murk_region_boundary *boundary, size_t number,
                               const murk_region *region,
                               const murk_box *domain);

/* Whether p lies in it: lower faces belong to it, upper ones do not. */
bool murk_region_boundary_holds(const murk_region_boundary *boundary,
                                murk_vec3 p);

/* Refuses, with MURK_BAD_VALUE at the later one's `where`, two shells that
 * cross: of two, one must lie in the other or both apart, but for near_m.
 * Warns of what lies wholly in a region listed after it. regions: of the
 * scene, by number. */
murk_status murk_region_boundaries_check(const murk_region_boundary *boundaries,
                                         size_t n, const murk_region *regions,
                                         const murk_box *domain,
                                         murk_error *err);

#endif
