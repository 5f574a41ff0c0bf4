/* One closed mesh that bounds a region, with a ray scene of its own. For use
 * inside src/geometry only.
 *
 * Each mesh has a scene of its own so that a face shared by several regions
 * is found once for each of them. */
#ifndef MURK_GEOMETRY_BOUNDARY_MESH_H
#define MURK_GEOMETRY_BOUNDARY_MESH_H

#include "geometry/closed.h"
#include "geometry/walk.h"

typedef struct murk_boundary_mesh {
    murk_surfaces *shape; /* only its triangles are used */
    int region;
    size_t crossings; /* number of edges that pass through a triangle of the
                         same mesh */
    bool *is_copy; /* [triangles] the triangle repeats an earlier one and is not
                      counted */
    bool *is_inward; /* [triangles] the winding's normal points into the mesh.
                        NULL: the mesh crosses itself or is not orientable, and
                        inside is decided by counting crossings only */
} murk_boundary_mesh;

/* Checks that the mesh is closed, counts the edges that pass through the mesh
 * (a warning reports them), and fills is_copy and, where possible, is_inward.
 * Fails with MURK_BAD_VALUE at `where` if the mesh is open, or with
 * MURK_NO_MEMORY. */
murk_status murk_boundary_mesh_find_sides(murk_boundary_mesh *boundary_mesh,
                                          const char *where, murk_error *err);

/* Calls `meet` for every triangle, copies left out, that the ray intersects
 * between the two distances, in no particular order. Triangles slightly before
 * from_m or slightly beyond to_m may be reported too. distance_m is computed in
 * double precision, except for rays that are almost parallel to the triangle.
 * `direction` is a unit vector. */
typedef void (*murk_meet)(void *context, size_t triangle, double distance_m);
void murk_boundary_mesh_gather(const murk_boundary_mesh *boundary_mesh,
                               murk_vec3 origin, murk_vec3 direction,
                               double from_m, double to_m, murk_meet meet,
                               void *context);

/* True if the ray from a point crosses the mesh an odd number of times beyond
 * the distance beyond_m. */
bool murk_boundary_mesh_is_odd(const murk_boundary_mesh *boundary_mesh,
                               murk_vec3 point, murk_vec3 direction,
                               double beyond_m);

/* True if the mesh encloses the point. */
bool murk_boundary_mesh_holds(const murk_boundary_mesh *boundary_mesh,
                              murk_vec3 point);

/* murk_boundary_meshes_next() for one mesh: finds the next place along the ray,
 * beyond from_m and up to max_m, at which the ray enters or leaves the mesh.
 * *inside, whether the ray is inside before that place, is corrected if
 * necessary. If the result is true, *distance_m and *normal are set; *normal is
 * a unit vector on the side of the origin. */
bool murk_boundary_mesh_next(const murk_boundary_mesh *boundary_mesh,
                             murk_vec3 origin, murk_vec3 direction,
                             double from_m, double max_m, double tolerance_m,
                             bool *inside, double *distance_m,
                             murk_vec3 *normal);

struct murk_boundary_meshes {
    size_t n;
    double tolerance_m;
    murk_boundary_mesh boundary_mesh[]; /* [n] */
};

/* The mesh of a region, which must have one. */
const murk_boundary_mesh *
murk_boundary_mesh_of(const struct murk_boundary_meshes *boundary_meshes,
                      int region);

#endif
