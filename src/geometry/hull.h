/* One closed mesh with its own ray scene; inside this room only.
 *
 * Each mesh has a scene of its own, so that faces which several regions share
 * are all found. */
#ifndef MURK_GEOMETRY_HULL_H
#define MURK_GEOMETRY_HULL_H

#include "geometry/closed.h"
#include "geometry/hulls.h"
#include "geometry/walk.h"

typedef struct murk_hull {
    murk_surfaces *shape; /* only its triangles are used */
    int region;
    size_t crossings; /* edges through triangles of the same mesh */
    bool *is_copy;    /* [triangles] of one listed before: does not count */
    bool *is_inward;  /* [triangles] the normal by winding points inside; NULL:
                         the mesh crosses itself, or has no two sides, and only
                         counts of crossings tell */
} murk_hull;

struct murk_hulls {
    size_t n;
    murk_hull hull[MURK_HULLS_MAX];
    double tolerance_m;
};

/* Checks that the mesh is closed and learns which sides are outer. Fails at
 * `where` when it is open. */
murk_status murk_hull_find_sides(murk_hull *hull, const char *where,
                                 murk_error *err);

/* Tells every triangle that a ray meets between two distances, in no order,
 * and some that lie a little before or beyond. distance_m is exact to double
 * but for rays that lie in the triangle's plane. */
typedef void (*murk_meet)(void *context, size_t triangle, double distance_m);
void murk_hull_gather(const murk_hull *hull, murk_vec3 origin,
                      murk_vec3 direction, double from_m, double to_m,
                      murk_meet meet, void *context);

/* Whether the mesh encloses the point. */
bool murk_hull_holds(const murk_hull *hull, murk_vec3 point);

/* The next change along a ray: as murk_hulls_next(), of one mesh. */
bool murk_hull_next(const murk_hull *hull, murk_vec3 origin,
                    murk_vec3 direction, double from_m, double max_m,
                    double tolerance_m, bool *inside, double *distance_m,
                    murk_vec3 *normal);

/* As murk_hulls_meet(). */
bool murk_hull_meets(const murk_hull *one, const murk_hull *other,
                     double tolerance_m, murk_vec3 *place);

/* As murk_hulls_meet_plain(). */
bool murk_hull_meets_plain(const murk_hull *hull, const murk_plain_shape *shape,
                           double tolerance_m, murk_vec3 *place);

#endif
