/* Zones of space. A point is transformed into the coordinates of each box
 * and sphere; closed meshes are tested by murk_boundary_meshes_at(). */
#include "geometry/zones.h"

#include <assert.h>
#include <stdlib.h>

typedef struct plain {
    bool is_sphere;
    murk_box box;
    murk_vec3 center;
    double radius_m;
    murk_affine from_world;
} plain;

struct murk_zones {
    plain *plain; /* boxes and spheres: [plains] */
    size_t plains;
    murk_boundary_meshes *boundary_meshes; /* NULL: no zone is a mesh */
};

static murk_status add_plain(murk_zones *zones, const murk_zone *zone,
                             murk_error *err)
{
    plain *p = &zones->plain[zones->plains++];
    *p = (plain){.is_sphere = zone->shape == MURK_REGION_SPHERE,
                 .box = zone->box,
                 .center = zone->center,
                 .radius_m = zone->radius_m};
    return murk_affine_invert(&zone->to_world, &p->from_world)
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, zone->where,
                           "is moved so that nothing is left of it");
}

static murk_status fill(murk_zones *made, const murk_zone *zones, size_t n,
                        murk_error *err)
{
    murk_boundary_mesh_desc desc[MURK_ZONE_MESHES_MAX];
    size_t meshes = 0;
    /* Boxes and spheres are stored directly; meshes are collected. */
    for (size_t i = 0; i < n; ++i) {
        if (zones[i].shape != MURK_REGION_MESH) {
            const murk_status status = add_plain(made, &zones[i], err);
            if (status) {
                return status;
            }
            continue;
        }
        if (meshes == MURK_ZONE_MESHES_MAX) {
            return murk_fail(err, MURK_BAD_VALUE, zones[i].where,
                             "one mesh too many, must be at most %d zones that "
                             "are meshes",
                             MURK_ZONE_MESHES_MAX);
        }
        desc[meshes] = (murk_boundary_mesh_desc){.region = (int)meshes,
                                                 .mesh = zones[i].mesh,
                                                 .to_world = zones[i].to_world,
                                                 .where = zones[i].where};
        ++meshes;
    }
    /* All meshes share one set of boundary meshes, each as a region of its
     * own. */
    return murk_boundary_meshes_create(&made->boundary_meshes, desc, meshes,
                                       err);
}

murk_status murk_zones_create(murk_zones **out, const murk_zone *zones,
                              size_t n, murk_error *err)
{
    assert(out && (zones || n == 0));
    murk_status status = MURK_OK;
    murk_zones *made = calloc(1, sizeof *made);
    if (!made || !(made->plain = calloc(n + 1, sizeof *made->plain))) {
        status = murk_no_memory(err, "zones", "for %zu zones", n);
        goto done;
    }
    status = fill(made, zones, n, err);
    if (status) {
        goto done;
    }
    *out = made;
    made = NULL;
done:
    murk_zones_destroy(made);
    return status;
}

void murk_zones_destroy(murk_zones *zones)
{
    if (zones) {
        murk_boundary_meshes_destroy(zones->boundary_meshes);
        free(zones->plain);
        free(zones);
    }
}

static bool holds(const plain *p, murk_vec3 point)
{
    const murk_vec3 at = murk_affine_point(&p->from_world, point);
    return p->is_sphere ? murk_length(murk_sub(at, p->center)) <= p->radius_m
                        : murk_box_contains(&p->box, at);
}

bool murk_zones_contain(const murk_zones *zones, murk_vec3 point)
{
    for (size_t i = 0; i < zones->plains; ++i) {
        if (holds(&zones->plain[i], point)) {
            return true;
        }
    }
    return zones->boundary_meshes &&
           murk_boundary_meshes_at(zones->boundary_meshes, point) != 0;
}
