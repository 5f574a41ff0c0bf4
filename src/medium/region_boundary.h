/* The boundary of a refractive region in the form that rays are intersected
 * with. For use inside src/medium only. */
#ifndef MURK_MEDIUM_REGION_BOUNDARY_H
#define MURK_MEDIUM_REGION_BOUNDARY_H

#include "medium/media.h"

typedef struct murk_region_boundary {
    size_t region;
    murk_region_shape shape;
    double ior;
    double mean_square_slope; /* of the waves on a half space; 0: flat */
    bool is_moved;            /* to_local is not the identity */
    bool spans[2]; /* reaches both sides of the domain along x, along y; also
                      true for a mesh, whatever its extent */
    murk_affine to_local;
    murk_box box; /* in the frame of the region. Faces on a side of the domain
                     or beyond are moved to infinity, so that no ray hits them.
                     Half spaces: up to the surface */
    murk_vec3 center; /* spheres, in the frame of the region */
    double radius;
} murk_region_boundary;

/* Tolerance for faces in the domain [m]: MURK_INTERFACE_NEAR times the
 * largest coordinate of the domain. */
double murk_region_boundary_near(const murk_box *domain);

/* Computes the boundary of a region with an index. False if the placement
 * cannot be inverted. */
bool murk_region_boundary_make(murk_region_boundary *boundary, size_t number,
                               const murk_region *region,
                               const murk_box *domain);

/* True if p is inside. A box contains its faces at the low end of each axis and
 * not those at the high end. False for meshes, whose triangles src/medium
 * does not know. */
bool murk_region_boundary_holds(const murk_region_boundary *boundary,
                                murk_vec3 p);

/* Checks that no two boundaries intersect: of two regions one must contain the
 * other, or both must be separate, with the tolerance of
 * murk_region_boundary_near(). Meshes are left out. Fails with MURK_BAD_VALUE
 * at the `where` of the later region. Warns of regions inside of a region that
 * is listed later. regions: those of the scene, by number. */
murk_status murk_region_boundaries_check(const murk_region_boundary *boundaries,
                                         size_t n, const murk_region *regions,
                                         const murk_box *domain,
                                         murk_error *err);

#endif
