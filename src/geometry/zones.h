/* Zones of space: boxes, spheres and closed meshes, each placed by a
 * similarity, for the question whether a point lies in any of them.
 *
 * Zones are neither surfaces nor regions of media, and light ignores them.
 * Boxes and spheres contain their boundary. A mesh must be closed as
 * described in geometry/boundary_meshes.h; for a point on its boundary, to
 * rounding, either answer is possible. Immutable after creation: any number
 * of threads may use it. */
#ifndef MURK_GEOMETRY_ZONES_H
#define MURK_GEOMETRY_ZONES_H

#include "base/shape.h"
#include "geometry/boundary_meshes.h"

#define MURK_ZONE_MESHES_MAX MURK_BOUNDARY_MESHES_MAX

typedef struct murk_zone {
    murk_region_shape shape; /* SPHERE or MESH; any other value means the box */
    murk_box box;
    murk_vec3 center;
    double radius_m;
    const murk_mesh *mesh; /* borrowed until creation returns */
    murk_affine
        to_world; /* meshes: applied after the conversion of unit and up axis */
    const char *where;
} murk_zone;

typedef struct murk_zones murk_zones;

/* Creates the zones; n may be 0. The caller owns *out and releases it with
 * murk_zones_destroy(). Fails at the zone's `where` with MURK_BAD_VALUE (an
 * open mesh, with the number of open edges; more than MURK_ZONE_MESHES_MAX
 * meshes; a box or sphere with a placement that cannot be inverted), or for a
 * mesh as murk_boundary_meshes_create() does, or with MURK_NO_MEMORY. */
murk_status murk_zones_create(murk_zones **out, const murk_zone *zones,
                              size_t n, murk_error *err);
void murk_zones_destroy(murk_zones *zones); /* NULL is fine */

/* True if the point lies in any zone. */
bool murk_zones_contain(const murk_zones *zones, murk_vec3 point);

#endif
