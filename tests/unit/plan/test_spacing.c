/* `candidates.spacing_m` of a scene, from its key to the plan. The seed is
 * fixed: nothing here is random. */
#include "check.h"
#include "chosen.h"
#include "stage_text.h"

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "media: {fog: {extinction_per_m: 1, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [1, 1, 1.5], power_w: 8}]\n"
    "photons: {emit: 300}\n"
    "sensors: {types: [{name: node, range_m: 1}], count: 3, candidates: "
    "{grid: {min_m: [0.25, 0.25, 1], max_m: [3.75, 3.75, 2], size: [8, 8, 2]}}}"
    "\n"
    "placement: {hold_out: false}\n";

/* The least distance between two sensors of the scene's plan; 0: none made. */
static double closest(const char *spacing, murk_error *err)
{
    const char *const overrides[] = {spacing, NULL};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    murk_traced *traced = NULL;
    murk_plan_result plan = {0};
    double min = INFINITY;
    CHECK(stage && !murk_plan_prepare(&plan, stage, 2, err) &&
          !murk_lightmap_trace(&traced, stage, 0, 2, err));
    if (!traced || choose_sensors(&plan, stage, traced, 2, err)) {
        min = 0;
    }
    for (size_t i = 0; min > 0 && i < plan.place.count; ++i) {
        for (size_t j = 0; j < i; ++j) {
            const murk_vec3 offset =
                murk_sub(plan.sensor[i].position, plan.sensor[j].position);
            min = fmin(min, murk_length(offset));
        }
    }
    murk_plan_result_release(&plan);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return min;
}

int main(void)
{
    murk_error err = {0};
    const double free_m = closest("sensors.candidates.spacing_m=0", &err);
    const double spacing_m = closest("sensors.candidates.spacing_m=2.6", &err);
    CHECK_TEXT(err.text, "");
    CHECK(free_m > 0 && free_m < 2.6); /* or the spacing asked for nothing */
    CHECK(spacing_m >= 2.6);
    CHECK(closest("sensors.candidates.spacing_m=99", &err) == 0);
    CHECK_TEXT(err.text, "no plan: no 3 of 128 usable candidates keep all "
                         "rules");
    CHECK_MENTIONS(err.where, "sensors");
    return check_done();
}
