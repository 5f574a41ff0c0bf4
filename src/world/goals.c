/* Regions of interest and the target mesh of a scene. Boundary meshes are built
 * from the imported meshes. A region that lies outside the domain, or whose
 * material or medium is used nowhere, is refused when the goals are built;
 * murk_goals_check_seen() refuses a region that contains no stored photon or
 * target. */
#include "world/goals.h"

#include "base/position.h"
#include "geometry/boundary_meshes.h"

#include <stdlib.h>
#include <string.h>

struct murk_goals {
    const murk_scene_desc *scene;
    murk_boundary_meshes *boundary_meshes; /* of the regions of interest */
    murk_boundary_meshes *target_mesh;     /* NULL: none */
    murk_interest_region *region;
    murk_interest interest;
};

void murk_goals_destroy(murk_goals *goals)
{
    if (goals) {
        murk_boundary_meshes_destroy(goals->target_mesh);
        murk_boundary_meshes_destroy(goals->boundary_meshes);
        free(goals->region);
        free(goals);
    }
}

/* ---- building ---- */

static murk_status check_name(const murk_scene_placement *settings, size_t i,
                              murk_error *err)
{
    for (size_t k = 0; k < i; ++k) {
        if (strcmp(settings->interest[k].name, settings->interest[i].name) ==
            0) {
            return murk_fail(err, MURK_BAD_VALUE, settings->interest[i].where,
                             "name: %s is the name of an earlier region of "
                             "interest, must be given once",
                             settings->interest[i].name);
        }
    }
    return MURK_OK;
}

static bool fills_a_region(const murk_scene_desc *scene, int medium)
{
    for (size_t i = 0; i < scene->n_regions; ++i) {
        if (scene->regions[i].medium == (size_t)medium) {
            return true;
        }
    }
    return false;
}

/* Fails if a region of interest lies outside the domain, if no surface has the
 * material of the region, or if no region of media contains the medium of the
 * region. No photon could be stored in such a region of interest. */
static murk_status check_place(const murk_goals *goals, size_t i,
                               const murk_surfaces *surfaces,
                               const murk_box *domain, murk_error *err)
{
    const murk_scene_desc *scene = goals->scene;
    const murk_scene_interest *r = &scene->placement.interest[i];
    const murk_box box =
        murk_goals_box(r->shape, &r->solid, goals->boundary_meshes, (int)i);
    /* The shape lies outside the domain. */
    if (!murk_box_overlaps(&box, domain)) {
        return murk_fail(err, MURK_BAD_VALUE, r->where,
                         "%s is empty: it spans %s to %s m, outside of the "
                         "domain",
                         r->name, murk_position_show(box.min).text,
                         murk_position_show(box.max).text);
    }
    /* The material or the medium of the region is used nowhere. */
    if (r->material >= 0 &&
        !(murk_surfaces_material_area(surfaces, (size_t)r->material) > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, r->where,
                         "%s is empty: no surface is of material %s", r->name,
                         scene->materials[r->material].name);
    }
    if (r->medium >= 0 && !fills_a_region(scene, r->medium)) {
        return murk_fail(err, MURK_BAD_VALUE, r->where,
                         "%s is empty: medium %s is in no region", r->name,
                         scene->media[r->medium].name);
    }
    return MURK_OK;
}

static murk_interest_region region_of(const murk_scene_interest *r)
{
    return (murk_interest_region){.name = r->name,
                                  .weight = r->weight,
                                  .shape = r->shape,
                                  .box = r->solid.box,
                                  .center = r->solid.center,
                                  .radius_m = r->solid.radius_m,
                                  .material = r->material,
                                  .medium = r->medium,
                                  .where = r->where};
}

static murk_status build_boundary_meshes(murk_goals *goals,
                                         murk_mesh *const *mesh,
                                         murk_error *err)
{
    const murk_scene_placement *settings = &goals->scene->placement;
    /* The meshes of the regions of interest form one set. */
    murk_boundary_mesh_desc desc[MURK_BOUNDARY_MESHES_MAX];
    size_t n = 0;
    for (size_t i = 0; i < settings->n_interests; ++i) {
        const murk_scene_interest *r = &settings->interest[i];
        if (mesh[i]) {
            desc[n++] = (murk_boundary_mesh_desc){
                .region = (int)i,
                .mesh = mesh[i],
                .to_world = murk_scene_placed(&r->solid),
                .where = r->where};
        }
    }
    murk_status status =
        murk_boundary_meshes_create(&goals->boundary_meshes, desc, n, err);
    /* The mesh of the targets is a set of its own. */
    const murk_scene_targets *t = &settings->targets;
    if (!status && t->solid.mesh) {
        const murk_boundary_mesh_desc target = {
            .mesh = mesh[settings->n_interests],
            .to_world = murk_scene_placed(&t->solid),
            .where = t->volume_where};
        status =
            murk_boundary_meshes_create(&goals->target_mesh, &target, 1, err);
    }
    return status;
}

/* Fails if a sensor type selects light by arrival direction although the scene
 * has targets: a target is a point without arriving light. */
static murk_status check_arrival(const murk_scene_desc *scene, murk_error *err)
{
    for (size_t i = 0; i < scene->sensors.types; ++i) {
        const murk_scene_sensor_type *type = &scene->sensors.type[i];
        if (scene->placement.targets.given && type->toward) {
            return murk_fail(err, MURK_BAD_VALUE, type->where,
                             "arrival is toward, must be any: "
                             "placement.targets are points, not light that "
                             "arrives");
        }
    }
    return MURK_OK;
}

murk_status murk_goals_create(murk_goals **out, const murk_scene_desc *scene,
                              murk_mesh *const *mesh,
                              const murk_surfaces *surfaces,
                              const murk_domain *domain, murk_error *err)
{
    const murk_scene_placement *settings = &scene->placement;
    const size_t n = settings->n_interests;
    murk_goals *goals = calloc(1, sizeof *goals);
    murk_interest_region *region = calloc(n + 1, sizeof *region);
    if (!goals || !region) {
        free(goals);
        free(region);
        return murk_no_memory(err, settings->where,
                              "for what plans are to see");
    }
    /* Build the meshes, and check and convert each region. */
    goals->scene = scene;
    goals->region = region;
    murk_status status = check_arrival(scene, err);
    if (!status) {
        status = build_boundary_meshes(goals, mesh, err);
    }
    for (size_t i = 0; i < n && !status; ++i) {
        status = check_name(settings, i, err);
        if (!status) {
            status = check_place(goals, i, surfaces, &domain->box, err);
        }
        region[i] = region_of(&settings->interest[i]);
    }
    if (status) {
        murk_goals_destroy(goals);
        return status;
    }
    goals->interest = (murk_interest){.region = region,
                                      .n = n,
                                      .boundary_meshes = goals->boundary_meshes,
                                      .elsewhere = settings->elsewhere};
    *out = goals;
    return MURK_OK;
}

const murk_interest *murk_goals_interest(const murk_goals *goals)
{
    return goals->interest.n > 0 ? &goals->interest : NULL;
}

const murk_boundary_meshes *murk_goals_target_mesh(const murk_goals *goals)
{
    return goals->target_mesh;
}

murk_box murk_goals_box(murk_region_shape shape, const murk_scene_solid *solid,
                        const murk_boundary_meshes *meshes, int number)
{
    switch (shape) {
    case MURK_REGION_BOX:
        return solid->box;
    case MURK_REGION_SPHERE:
        return murk_box_of_ball(solid->center, solid->radius_m);
    case MURK_REGION_MESH:
        return murk_boundary_meshes_describe(meshes, number).bounds_m;
    default: /* everywhere */
        break;
    }
    const murk_vec3 far = {INFINITY, INFINITY, INFINITY};
    return (murk_box){murk_scale(-1, far), far};
}

uint64_t murk_goals_seen(const murk_sight *sight)
{
    uint64_t seen = 0;
    for (size_t i = 0; i < murk_sight_photons(sight); ++i) {
        seen |= murk_sight_regions(sight, i);
    }
    return seen;
}

murk_status murk_goals_check_seen(const murk_goals *goals, uint64_t seen,
                                  murk_error *err)
{
    const murk_interest *interest = &goals->interest;
    for (size_t r = 0; r < interest->n; ++r) {
        if (!(seen >> r & 1)) {
            return murk_fail(err, MURK_RUN_FAILED, interest->region[r].where,
                             "%s is empty: none of the %s lies in it",
                             interest->region[r].name,
                             goals->scene->placement.targets.given
                                 ? "targets"
                                 : "stored photons");
        }
    }
    return MURK_OK;
}
