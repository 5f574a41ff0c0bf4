/* Closed meshes that bound regions: where a ray goes into and out of them.
 *
 * They are no surfaces: nothing here reflects, and murk_surfaces knows nothing
 * of them. Regions have numbers 0..63 and are told as bits of a 64-bit mask,
 * "inside of these". Each mesh must be closed: every edge belongs to an even
 * number of its triangles, once vertices of equal place are one (triangles
 * listed twice count once; winding means nothing). A point is inside when a
 * way out of it crosses the mesh an odd number of times: a shell in a shell is
 * a cavity. So parts of one mesh that overlap leave a hole where they do; a
 * warning says so.
 *
 * What lies nearer together along a ray than tolerance_m is met at once:
 * boundaries of several regions that share a face change together, and the two
 * sides of a sliver thinner than that cancel. tolerance_m is 16 float steps
 * (1.9e-6) of the largest coordinate of any of the meshes (counted from the
 * middle of a mesh that is far from the origin).
 *
 * Each triangle of a mesh that does not cross itself knows its outer side, so
 * the nearest boundary ahead tells where a point is, and a ray that grazes an
 * edge cannot leave a wrong count behind. Immutable after creation: any number
 * of threads may ask. */
#ifndef MURK_GEOMETRY_BOUNDARY_MESHES_H
#define MURK_GEOMETRY_BOUNDARY_MESHES_H

#include "base/status.h"
#include "base/vector.h"
#include "geometry/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_BOUNDARY_MESHES_MAX 64

typedef struct murk_boundary_mesh_desc {
    int region;            /* 0..63, each at most once */
    const murk_mesh *mesh; /* borrowed during creation */
    murk_affine to_world;  /* after unit and up axis */
    const char *where;
} murk_boundary_mesh_desc;

typedef struct murk_boundary_meshes murk_boundary_meshes;

/* *out is the caller's: murk_boundary_meshes_destroy(). Fails with
 * MURK_BAD_VALUE at the desc's `where` when a mesh is open (with the number of
 * its open edges), out of range or without area, or MURK_NO_MEMORY. */
murk_status murk_boundary_meshes_create(murk_boundary_meshes **out,
                                        const murk_boundary_mesh_desc *descs,
                                        size_t n, murk_error *err);
void murk_boundary_meshes_destroy(
    murk_boundary_meshes *boundary_meshes); /* NULL is fine */

/* The regions whose mesh encloses the point. In the boundary itself, to
 * rounding, either answer may come. */
uint64_t murk_boundary_meshes_at(const murk_boundary_meshes *boundary_meshes,
                                 murk_vec3 point);

typedef struct murk_crossing {
    double distance_m;
    uint64_t inside;  /* of these, beyond */
    uint64_t changed; /* these are entered or left here */
    murk_vec3 normal; /* unit, of the nearest of them; faces the side the ray
                         came from */
} murk_crossing;

/* The first place along unit `direction`, after from_m and at most at max_m
 * (may be INFINITY), where the regions around the ray change. *inside: those
 * around it after from_m as the caller believes; corrected by what lies ahead.
 * To go on from a crossing, ask from distance_m + tolerance_m. False: nothing
 * changes on the way. */
bool murk_boundary_meshes_next(const murk_boundary_meshes *boundary_meshes,
                               murk_vec3 origin, murk_vec3 direction,
                               double from_m, double max_m, uint64_t *inside,
                               murk_crossing *crossing);

/* All that have a mesh. */
uint64_t
murk_boundary_meshes_regions(const murk_boundary_meshes *boundary_meshes);

double
murk_boundary_meshes_tolerance_m(const murk_boundary_meshes *boundary_meshes);

/* Whether the boundaries of two of the regions cross, so that each has parts
 * inside and outside of the other; *place is then a point nearby. Nested or
 * apart is not crossing, and touching is not: what reaches less than
 * tolerance_m beyond does not count. */
bool murk_boundary_meshes_meet(const murk_boundary_meshes *boundary_meshes,
                               int region, int other, murk_vec3 *place);

/* A region of another shape, to be held against meshes. */
typedef enum murk_plain {
    MURK_PLAIN_BELOW, /* z less than box.max.z, in the world */
    MURK_PLAIN_BOX,
    MURK_PLAIN_SPHERE
} murk_plain;

typedef struct murk_plain_shape {
    murk_plain plain;
    murk_box box; /* finite, but for half spaces */
    murk_vec3 center;
    double radius_m;
    murk_affine to_world; /* a similarity; unused by half spaces */
} murk_plain_shape;

/* As murk_boundary_meshes_meet(), of a mesh and such a shape; exact. False
 * where to_world cannot be inverted. */
bool murk_boundary_meshes_meet_plain(
    const murk_boundary_meshes *boundary_meshes, int region,
    const murk_plain_shape *shape, murk_vec3 *place);

typedef struct murk_boundary_mesh_facts {
    size_t triangles, crossings; /* crossings: edges that pass through a
                                    triangle of the same mesh */
    murk_box bounds_m;
    size_t memory_bytes;
} murk_boundary_mesh_facts;

/* Of one region that has a mesh. */
murk_boundary_mesh_facts
murk_boundary_meshes_describe(const murk_boundary_meshes *boundary_meshes,
                              int region);

#endif
