#include "study/dark.h"

#include <math.h>
#include <stdlib.h>

static const murk_estimate NOTHING = {NAN, NAN};

bool murk_stage_is_dark(const murk_stage *stage)
{
    return murk_sources_lit(stage->lights) == 0;
}

bool murk_plan_is_dark(const murk_stage *stage)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    return murk_stage_is_dark(stage) &&
           (!settings->targets.given ||
            settings->detection == MURK_SCENE_POWER);
}

static double *none_of(size_t n)
{
    double *out = malloc(n * sizeof *out + 1);
    for (size_t i = 0; out && i < n; ++i) {
        out[i] = NAN;
    }
    return out;
}

murk_status murk_dark_coverage(murk_coverage_result *out,
                               const murk_stage *stage, size_t n,
                               murk_error *err)
{
    const size_t regions = stage->scene->placement.n_interests;
    murk_coverage_result made = {.total = NOTHING,
                                 .surface = NOTHING,
                                 .volume = NOTHING,
                                 .map = {{0, NAN, NAN}, {0, NAN, NAN}},
                                 .sum_of_views = NAN,
                                 .covers = none_of(n),
                                 .only_it_covers = none_of(n),
                                 .seen_by_at_least = none_of(n)};
    made.region = regions ? calloc(regions, sizeof *made.region) : NULL;
    if (!made.covers || !made.only_it_covers || !made.seen_by_at_least ||
        (regions && !made.region)) {
        murk_coverage_result_release(&made);
        return murk_fail(err, MURK_NO_MEMORY, stage->scene->path,
                         "no memory for %zu sensors", n);
    }
    for (size_t i = 0; i < regions; ++i) {
        made.region[i].coverage = NOTHING;
    }
    *out = made;
    return MURK_OK;
}

murk_status murk_dark_plan(murk_plan_result *plan, const murk_stage *stage,
                           murk_error *err)
{
    const murk_poses *poses = plan->poses;
    const size_t n = poses->fixed;
    plan->is_dark = true;
    plan->place = (murk_place_result){.guarantee = "none: it is dark"};
    plan->confirmed = plan->held_out = NOTHING;
    plan->explore.end = MURK_EXPLORE_NOTHING;
    plan->place.sensor = calloc(n + 1, sizeof *plan->place.sensor);
    plan->sensor = calloc(n + 1, sizeof *plan->sensor);
    if (!plan->place.sensor || !plan->sensor) {
        return murk_fail(err, MURK_NO_MEMORY, stage->scene->path,
                         "no memory for the plan");
    }
    plan->place.count = n;
    for (size_t i = 0; i < n; ++i) {
        plan->place.sensor[i] = poses->fixed_number[i];
        plan->sensor[i] = poses->pose[poses->fixed_number[i]];
    }
    const murk_status status =
        murk_dark_coverage(&plan->in_sample, stage, n, err);
    return status ? status
                  : murk_robust_begin(&plan->robust, stage, plan->sensor, n,
                                      &plan->in_sample, err);
}
