/* All closed meshes that bound regions: creation, and the combination of the
 * crossings of single meshes (geometry/boundary_mesh.h) into crossings of sets
 * of regions.
 *
 * Each mesh is asked for the next crossing along the ray. Crossings within
 * the tolerance of the nearest one are combined into one change of the set
 * of regions. */
#include "geometry/boundary_meshes.h"

#include "geometry/boundary_mesh.h"

#include <assert.h>
#include <stdlib.h>

/* Tolerance in units of the step of murk_surfaces_leave(): 2, because both
 * sides of a boundary may be off by one step. */
#define TOLERANCE_LEAVES 2

static murk_status make_one(murk_boundary_mesh *b,
                            const murk_boundary_mesh_desc *d, murk_error *err)
{
    const char *where = d->where ? d->where : "region";
    const murk_material black = {.name = "hull"};
    const murk_surface_desc shape = {.shape = MURK_SHAPE_MESH,
                                     .mesh = d->mesh,
                                     .to_world = d->to_world,
                                     .material = 0,
                                     .where = where};
    b->region = d->region;
    murk_status status =
        murk_surfaces_create(&b->shape, &shape, 1, &black, 1, err);
    if (!status && b->shape->soup.triangles == 0) {
        status = murk_fail(err, MURK_BAD_VALUE, where,
                           "no triangle of the mesh has any area");
    }
    return status ? status : murk_boundary_mesh_find_sides(b, where, err);
}

murk_status murk_boundary_meshes_create(murk_boundary_meshes **out,
                                        const murk_boundary_mesh_desc *descs,
                                        size_t n, murk_error *err)
{
    assert(out && n <= MURK_BOUNDARY_MESHES_MAX);
    if (n == 0) {
        return MURK_OK;
    }
    murk_boundary_meshes *made =
        calloc(1, sizeof *made + n * sizeof *made->boundary_mesh);
    if (!made) {
        return murk_no_memory(err, "regions", "for %zu meshes", n);
    }
    /* Build the ray scene of each mesh. */
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        assert(descs[i].region >= 0 &&
               descs[i].region < MURK_BOUNDARY_MESHES_MAX);
        status = make_one(&made->boundary_mesh[made->n++], &descs[i], err);
    }
    if (status) {
        murk_boundary_meshes_destroy(made);
        return status;
    }
    /* The mesh with the largest coordinates determines the tolerance of all. */
    for (size_t i = 0; i < n; ++i) {
        made->tolerance_m =
            fmax(made->tolerance_m,
                 TOLERANCE_LEAVES * made->boundary_mesh[i].shape->leave_m);
    }
    *out = made;
    return MURK_OK;
}

void murk_boundary_meshes_destroy(murk_boundary_meshes *b)
{
    if (!b) {
        return;
    }
    for (size_t i = 0; i < b->n; ++i) {
        murk_surfaces_destroy(b->boundary_mesh[i].shape);
        free(b->boundary_mesh[i].is_copy);
        free(b->boundary_mesh[i].is_inward);
    }
    free(b);
}

static uint64_t bit_of(const murk_boundary_mesh *b)
{
    return UINT64_C(1) << b->region;
}

uint64_t murk_boundary_meshes_at(const murk_boundary_meshes *b, murk_vec3 point)
{
    uint64_t inside = 0;
    for (size_t i = 0; i < b->n; ++i) {
        if (murk_boundary_mesh_holds(&b->boundary_mesh[i], point)) {
            inside |= bit_of(&b->boundary_mesh[i]);
        }
    }
    return inside;
}

bool murk_boundary_meshes_next(const murk_boundary_meshes *b, murk_vec3 origin,
                               murk_vec3 direction, double from_m, double max_m,
                               uint64_t *inside, murk_crossing *crossing)
{
    double distance[MURK_BOUNDARY_MESHES_MAX], nearest = INFINITY;
    for (size_t i = 0; i < b->n; ++i) {
        const murk_boundary_mesh *one = &b->boundary_mesh[i];
        bool is_inside = *inside & bit_of(one);
        murk_vec3 normal;
        /* Crossings up to the tolerance beyond the nearest belong to the
         * same change. */
        const double max = fmin(max_m, nearest + b->tolerance_m);
        if (!murk_boundary_mesh_next(one, origin, direction, from_m, max,
                                     b->tolerance_m, &is_inside, &distance[i],
                                     &normal)) {
            distance[i] = INFINITY;
            continue;
        }
        *inside = is_inside ? *inside | bit_of(one) : *inside & ~bit_of(one);
        if (distance[i] < nearest) {
            nearest = distance[i];
            crossing->normal = normal;
        }
    }
    /* Combine all crossings within the tolerance of the nearest. */
    if (!(nearest < INFINITY)) {
        return false;
    }
    crossing->distance_m = nearest;
    crossing->changed = 0;
    for (size_t i = 0; i < b->n; ++i) {
        if (distance[i] <= nearest + b->tolerance_m) {
            crossing->changed |= bit_of(&b->boundary_mesh[i]);
        }
    }
    crossing->inside = *inside ^ crossing->changed;
    return true;
}

uint64_t murk_boundary_meshes_regions(const murk_boundary_meshes *b)
{
    uint64_t all = 0;
    for (size_t i = 0; i < b->n; ++i) {
        all |= bit_of(&b->boundary_mesh[i]);
    }
    return all;
}

double murk_boundary_meshes_tolerance_m(const murk_boundary_meshes *b)
{
    return b->tolerance_m;
}

const murk_boundary_mesh *murk_boundary_mesh_of(const murk_boundary_meshes *b,
                                                int region)
{
    size_t i = 0;
    while (i < b->n && b->boundary_mesh[i].region != region) {
        ++i;
    }
    assert(i < b->n);
    return &b->boundary_mesh[i];
}

murk_boundary_mesh_facts
murk_boundary_meshes_describe(const murk_boundary_meshes *b, int region)
{
    const murk_boundary_mesh *one = murk_boundary_mesh_of(b, region);
    const murk_surfaces_facts facts = murk_surfaces_describe(one->shape);
    return (murk_boundary_mesh_facts){
        .triangles = facts.triangles,
        .crossings = one->crossings,
        .bounds_m = facts.bounds_m,
        .memory_bytes = sizeof *one + facts.memory_bytes +
                        facts.triangles * (one->is_inward ? 2 : 1)};
}
