/* Parts of space, to ask whether a point lies in any of them: boxes, spheres
 * and closed meshes, each moved by a similarity.
 *
 * Zones are no surfaces and no regions: light knows nothing of them. Boxes and
 * spheres hold their boundary. A mesh must be closed as
 * geometry/boundary_meshes.h says; in its boundary, to rounding, either answer
 * may come. Immutable after creation: any number of threads may ask. */
#ifndef MURK_GEOMETRY_ZONES_H
#define MURK_GEOMETRY_ZONES_H

#include "geometry/boundary_meshes.h"

#define MURK_ZONE_MESHES_MAX MURK_BOUNDARY_MESHES_MAX

typedef enum murk_zone_shape {
    MURK_ZONE_BOX,
    MURK_ZONE_SPHERE,
    MURK_ZONE_MESH
} murk_zone_shape;

typedef struct murk_zone {
    murk_zone_shape shape;
    murk_box box;
    murk_vec3 center;
    double radius_m;
    const murk_mesh *mesh; /* borrowed during creation */
    murk_affine to_world;  /* meshes: after unit and up axis */
    const char *where;
} murk_zone;

typedef struct murk_zones murk_zones;

/* n may be 0. *out is the caller's: murk_zones_destroy(). Fails at the zone's
 * `where` with MURK_BAD_VALUE (an open mesh, with the number of its open edges;
 * more than MURK_ZONE_MESHES_MAX meshes; a move that flattens), or
 * MURK_NO_MEMORY. */
murk_status murk_zones_create(murk_zones **out, const murk_zone *zones,
                              size_t n, murk_error *err);
void murk_zones_destroy(murk_zones *zones); /* NULL is fine */

/* Whether the point lies in any of them. */
bool murk_zones_contain(const murk_zones *zones, murk_vec3 point);

#endif
