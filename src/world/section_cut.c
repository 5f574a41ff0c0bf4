/* Chooses the planes of the plan (a level section) and of the two upright
 * sections. The height of the floor is found by rays that lead down from the
 * sites of sensors, because a plan at the lowest point of sloping ground would
 * lie below most of the ground. */
#include "world/section_cut.h"

#include "base/quantile.h"
#include "world/extent.h"

/* Height of a plan above the floor [m]: between sill and lintel of doors and
 * windows, as architects cut. */
#define PLAN_ABOVE_FLOOR_M 1.5

/* The largest number of sites below which the floor is looked for. */
#define FLOOR_SAMPLES 1024

/* Planes that the user has not chosen lie at multiples of this length [m] in
 * the coordinates of the user, unless rounding would leave the domain. */
#define CUT_STEP_M 0.01

static murk_box box_of_sites(const murk_vec3 *site, size_t sites)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < sites; ++i) {
        box = murk_box_with(box, site[i]);
    }
    return box;
}

/* The height of the floor: the median height of the first surfaces below the
 * sites, or below every step-th site if there are many. If no surface is below
 * a site, the bottom of `things` counts. A table or a hole below few of the
 * sites does not change the median. Without sites the result is the bottom of
 * `things`. */
static double floor_of(const murk_stage *stage, const murk_vec3 *site,
                       size_t sites, const murk_box *things)
{
    double below[FLOOR_SAMPLES];
    size_t n = 0;
    const size_t step = sites / FLOOR_SAMPLES + 1;
    for (size_t i = 0; i < sites; i += step) {
        const murk_vec3 at = site[i];
        murk_hit hit;
        const bool is_hit =
            murk_surfaces_hit(stage->surfaces, at, murk_vec(0, 0, -1),
                              at.z - stage->world.domain.box.min.z, &hit);
        below[n++] = is_hit ? at.z - hit.distance_m : things->min.z;
    }
    if (n == 0) {
        return things->min.z;
    }
    murk_sort(below, n);
    return below[n / 2];
}

murk_box murk_stage_things_box(const murk_stage *stage, const murk_vec3 *site,
                               size_t sites)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_surfaces_facts facts = murk_surfaces_describe(stage->surfaces);
    murk_box box = murk_box_empty();
    box = murk_extent_join(box, facts.bounds_m);
    box = murk_extent_join(box, murk_media_bounds(stage->media));
    box = murk_extent_join(box, box_of_sites(site, sites));
    for (size_t i = 0; i < scene->n_lights; ++i) {
        if (!murk_scene_light_is_distant(&scene->lights[i])) {
            box = murk_box_with(box, scene->lights[i].position);
        }
    }
    for (size_t i = 0; i < scene->sensors.n_fixed; ++i) {
        box = murk_box_with(box, scene->sensors.fixed[i].position);
    }
    for (size_t i = 0; i < scene->n_cameras; ++i) {
        box = murk_box_with(box, scene->cameras[i].from);
    }
    box = murk_box_meet(box, stage->world.domain.box);
    return murk_extent_is_box(&box) ? box : stage->world.domain.box;
}

murk_vec3 murk_stage_section_cut(const murk_stage *stage, const murk_vec3 *site,
                                 size_t sites)
{
    const murk_box things = murk_stage_things_box(stage, site, sites);
    const murk_box site_box = box_of_sites(site, sites);
    const murk_box middle_of =
        murk_extent_is_box(&site_box) ? site_box : things;
    const double floor_m = floor_of(stage, site, sites, &things),
                 plan_m = floor_m + PLAN_ABOVE_FLOOR_M;
    murk_vec3 cut = murk_scale(0.5, murk_add(middle_of.min, middle_of.max));
    cut.z = plan_m < things.max.z ? plan_m : (floor_m + things.max.z) / 2;
    /* Round to CUT_STEP_M: a user can give round numbers more easily. */
    const murk_vec3 user = murk_scene_user(stage->scene, cut);
    const murk_vec3 rounded = murk_vec(round(user.x / CUT_STEP_M) * CUT_STEP_M,
                                       round(user.y / CUT_STEP_M) * CUT_STEP_M,
                                       round(user.z / CUT_STEP_M) * CUT_STEP_M);
    const murk_vec3 out = murk_scene_local(stage->scene, rounded);
    return murk_box_contains(&stage->world.domain.box, out) ? out : cut;
}
