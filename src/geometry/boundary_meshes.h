/* Closed meshes that bound regions of media: where a ray enters and leaves
 * them.
 *
 * Boundary meshes are not surfaces: they have no material, and murk_surfaces
 * does not contain them. Regions have numbers 0..63; a set of regions is a
 * 64-bit mask. Each mesh must be closed: every edge belongs to an even number
 * of triangles, after vertices at equal places are merged. Triangles listed
 * twice count once, and the winding of triangles is ignored. A point is inside
 * if a ray from the point to infinity crosses the mesh an odd number of times,
 * so an inner closed surface encloses a cavity. Parts of one mesh that overlap
 * therefore leave a hole in their intersection; a warning reports this.
 *
 * Boundaries closer together along a ray than tolerance_m are one crossing:
 * regions that share a face change together, and the two sides of a sliver
 * thinner than the tolerance cancel. tolerance_m is 16 float steps (1.9e-6) of
 * the largest coordinate of all meshes (relative to the middle of a mesh that
 * is far from the origin).
 *
 * Each triangle of a mesh that does not cross itself and is orientable has a
 * known outer side. The nearest boundary ahead therefore decides whether a
 * point is inside, and a ray that grazes an edge cannot leave a wrong state
 * behind. Immutable after creation: any number of threads may use it. */
#ifndef MURK_GEOMETRY_BOUNDARY_MESHES_H
#define MURK_GEOMETRY_BOUNDARY_MESHES_H

#include "base/shape.h"
#include "base/status.h"
#include "base/vector.h"
#include "geometry/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One bit of a 64-bit mask for each region. */
#define MURK_BOUNDARY_MESHES_MAX 64

typedef struct murk_boundary_mesh_desc {
    int region;            /* 0..63, each at most once */
    const murk_mesh *mesh; /* borrowed until creation returns */
    murk_affine to_world; /* applied after the conversion of unit and up axis */
    const char *where;
} murk_boundary_mesh_desc;

typedef struct murk_boundary_meshes murk_boundary_meshes;

/* The caller owns *out and releases it with murk_boundary_meshes_destroy();
 * without meshes *out stays as it is. Fails with MURK_BAD_VALUE at the `where`
 * of a mesh that is open (the message counts the open edges), has coordinates
 * out of range or has no area, with MURK_NO_MEMORY, or as
 * murk_surfaces_create() does if Embree fails. n is at most
 * MURK_BOUNDARY_MESHES_MAX. */
murk_status murk_boundary_meshes_create(murk_boundary_meshes **out,
                                        const murk_boundary_mesh_desc *descs,
                                        size_t n, murk_error *err);
void murk_boundary_meshes_destroy(
    murk_boundary_meshes *boundary_meshes); /* NULL is fine */

/* The set of regions whose mesh encloses the point. For a point on a
 * boundary, to rounding, either answer is possible. */
uint64_t murk_boundary_meshes_at(const murk_boundary_meshes *boundary_meshes,
                                 murk_vec3 point);

typedef struct murk_crossing {
    double distance_m;
    uint64_t inside;  /* the set of regions that the ray is inside of just
                       * beyond the crossing */
    uint64_t changed; /* the regions entered or left at the crossing */
    murk_vec3 normal; /* unit normal of the nearest crossed triangle, on the
                         side of the ray's origin */
} murk_crossing;

/* The first crossing along the unit vector `direction`, beyond from_m and up to
 * max_m (may be INFINITY). *inside is the set of regions that the ray is inside
 * of just beyond from_m, as the caller believes; the function corrects the set
 * if the boundaries ahead prove it wrong. To continue beyond a crossing, call
 * again with from_m = distance_m + tolerance_m. Returns false if the ray
 * crosses no boundary in that range. */
bool murk_boundary_meshes_next(const murk_boundary_meshes *boundary_meshes,
                               murk_vec3 origin, murk_vec3 direction,
                               double from_m, double max_m, uint64_t *inside,
                               murk_crossing *crossing);

/* The set of all regions that have a mesh. */
uint64_t
murk_boundary_meshes_regions(const murk_boundary_meshes *boundary_meshes);

double
murk_boundary_meshes_tolerance_m(const murk_boundary_meshes *boundary_meshes);

/* True if the boundaries of two regions intersect, so that one of the
 * boundaries has parts inside and parts outside of the other region. *place is
 * then, for messages, a point of that boundary on either side; the point need
 * not be near the intersection. Nested and separate regions do not intersect.
 * Touching is not intersecting: a part that protrudes by less than tolerance_m
 * is ignored. The function tests samples of the two boundaries
 * (geometry/mesh_intersection.c). */
bool murk_boundary_meshes_meet(const murk_boundary_meshes *boundary_meshes,
                               int region, int other, murk_vec3 *place);

/* A convex shape: a half space, box or sphere. */
typedef struct murk_plain_shape {
    murk_region_shape shape; /* BELOW (the points with z < box.max.z, in world
                                coordinates), BOX or SPHERE */
    murk_box box;            /* finite, except for half spaces */
    murk_vec3 center;
    double radius_m;
    murk_affine to_world; /* a similarity; not used for half spaces */
} murk_plain_shape;

/* murk_boundary_meshes_meet() for a mesh and a convex shape, without sampling:
 * exact but for tolerance_m. *place is a corner of a triangle of the mesh.
 * False if to_world cannot be inverted. */
bool murk_boundary_meshes_meet_plain(
    const murk_boundary_meshes *boundary_meshes, int region,
    const murk_plain_shape *shape, murk_vec3 *place);

typedef struct murk_boundary_mesh_facts {
    size_t triangles, crossings; /* crossings: number of edges that pass through
                                    a triangle of the same mesh */
    murk_box bounds_m;
    size_t memory_bytes;
} murk_boundary_mesh_facts;

/* Size and memory of the mesh of a region. The region must have a mesh. */
murk_boundary_mesh_facts
murk_boundary_meshes_describe(const murk_boundary_meshes *boundary_meshes,
                              int region);

#endif
