/* Measures given sensors: creates the sight onto the light or the targets, then
 * measures coverage, the coverage without each sensor, the links between
 * sensors, and the coverage with random errors of position and direction. */
#include "plan/measured.h"

#include "plan/few_photons.h"

murk_status murk_measured_make(murk_measured *out, murk_sight **sight,
                               const murk_stage *stage,
                               const murk_traced *traced,
                               const murk_pose *sensor, size_t n,
                               unsigned threads, murk_error *err)
{
    *out = (murk_measured){0};
    *sight = NULL;
    if (murk_stage_has_nothing_to_see(stage)) {
        const murk_status status =
            murk_dark_coverage(&out->coverage, stage, n, err);
        return status ? status
                      : murk_robust_begin(&out->robust, stage, sensor, n,
                                          &out->coverage, err);
    }
    murk_status status = murk_plan_sight_and_targets(
        sight, &out->targets, stage, traced, threads, err);
    if (!status) {
        status =
            murk_goals_check_seen(stage->goals, murk_goals_seen(*sight), err);
    }
    /* Coverage; coverage without each sensor, and links; random errors. */
    if (!status) {
        status = murk_coverage_result_measure(&out->coverage, *sight, sensor, n,
                                              err);
    }
    if (!status) {
        murk_warn_of_thin_map(stage->scene, &out->coverage, NULL);
        status = murk_robust_begin(&out->robust, stage, sensor, n,
                                   &out->coverage, err);
    }
    return status ? status
                  : murk_robust_jitter(&out->robust, stage, *sight, sensor,
                                       &out->coverage, false, err);
}

void murk_measured_release(murk_measured *measured)
{
    murk_robust_release(&measured->robust);
    murk_coverage_result_release(&measured->coverage);
    *measured = (murk_measured){0};
}
