/* One closed mesh with its own ray scene; inside this room only.
 *
 * Each mesh has a scene of its own, so that faces which several regions share
 * are all found. */
#ifndef MURK_GEOMETRY_BOUNDARY_MESH_H
#define MURK_GEOMETRY_BOUNDARY_MESH_H

#include "geometry/boundary_meshes.h"
#include "geometry/closed.h"
#include "geometry/walk.h"

typedef struct murk_boundary_mesh {
    murk_surfaces *shape; /* only its triangles are used */
    int region;
    size_t crossings; /* edges through triangles of the same mesh */
    bool *is_copy;    /* [triangles] of one listed before: does not count */
    bool *is_inward;  /* [triangles] the normal by winding points inside; NULL:
                         the mesh crosses itself, or has no two sides, and only
                         counts of crossings tell */
} murk_boundary_mesh;

struct murk_boundary_meshes {
    size_t n;
    murk_boundary_mesh boundary_mesh[MURK_BOUNDARY_MESHES_MAX];
    double tolerance_m;
};

/* Checks that the mesh is closed and learns which sides are outer. Fails at
 * `where` when it is open. */
murk_status murk_boundary_mesh_find_sides(murk_boundary_mesh *boundary_mesh,
                                          const char *where, murk_error *err);

/* Tells every triangle that a ray meets between two distances, in no order,
 * and some that lie a little before or beyond. distance_m is exact to double
 * but for rays that lie in the triangle's plane. */
typedef void (*murk_meet)(void *context, size_t triangle, double distance_m);
void murk_boundary_mesh_gather(const murk_boundary_mesh *boundary_mesh,
                               murk_vec3 origin, murk_vec3 direction,
                               double from_m, double to_m, murk_meet meet,
                               void *context);

/* Whether the mesh encloses the point. */
bool murk_boundary_mesh_holds(const murk_boundary_mesh *boundary_mesh,
                              murk_vec3 point);

/* The next change along a ray: as murk_boundary_meshes_next(), of one mesh. */
bool murk_boundary_mesh_next(const murk_boundary_mesh *boundary_mesh,
                             murk_vec3 origin, murk_vec3 direction,
                             double from_m, double max_m, double tolerance_m,
                             bool *inside, double *distance_m,
                             murk_vec3 *normal);

/* As murk_boundary_meshes_meet(). */
bool murk_boundary_mesh_meets(const murk_boundary_mesh *one,
                              const murk_boundary_mesh *other,
                              double tolerance_m, murk_vec3 *place);

/* As murk_boundary_meshes_meet_plain(). */
bool murk_boundary_mesh_meets_plain(const murk_boundary_mesh *boundary_mesh,
                                    const murk_plain_shape *shape,
                                    double tolerance_m, murk_vec3 *place);

#endif
