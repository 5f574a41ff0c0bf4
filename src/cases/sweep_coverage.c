/* Coverage of sensors in one row of a study: of the given placement, of the
 * best plan for the row, and of plans for all rows. */
#include "cases/sweep_coverage.h"

#include "plan/placement_in.h"
#include "plan/plan.h"

#include <math.h>
#include <stdlib.h>

static const murk_estimate NONE = {NAN, NAN};

bool murk_sweep_needs_no_light(const murk_scene_desc *scene)
{
    return scene->placement.targets.given &&
           !murk_detection_is(scene->placement.detection,
                              MURK_DETECTION_BY_POWER);
}

bool murk_sweep_can_see(const murk_sweep_light *l, size_t k)
{
    return murk_sweep_light_shines(l, k) ||
           murk_sweep_needs_no_light(l->scene[k]);
}

bool murk_sweep_has_seen(const murk_stage *stage, const murk_traced *traced)
{
    return murk_sweep_needs_no_light(stage->scene) ||
           murk_photon_map_count(traced->surface) +
                   murk_photon_map_count(traced->volume) >
               0;
}

/* Measures the total coverage in light of a stream. NaN if nothing is
 * stored. */
static murk_status measure_anew(murk_sweep_light *l, size_t k, uint32_t stream,
                                const murk_pose *sensor, size_t n,
                                murk_estimate *out, murk_error *err)
{
    const murk_stage *stage = l->stage[k];
    const unsigned threads = l->sweep->desc.threads;
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    bool is_own = true;
    /* Targets need no light; otherwise take the light of the row for this
     * stream. */
    murk_status status =
        murk_sweep_needs_no_light(stage->scene)
            ? murk_plan_trace_stream(&traced, stage, stream, threads, err)
            : murk_sweep_light_of(l, k, stream, &traced, &is_own, err);
    /* Measure if there is something to see. */
    if (!status && murk_sweep_has_seen(stage, traced)) {
        status = murk_plan_sight(&sight, stage, traced, threads, err);
        if (!status) {
            status = murk_coverage_total_measure(out, sight, sensor, n, err);
        }
    } else if (!status) {
        *out = NONE;
    }
    murk_sight_destroy(sight);
    if (is_own) {
        murk_traced_destroy(traced);
    }
    return status;
}

static bool holds_out(const murk_scene_desc *scene)
{
    return scene->placement.hold_out && murk_plan_has_streams(scene);
}

murk_status murk_sweep_measure(murk_sweep_light *l, size_t k,
                               const murk_pose *sensor, size_t n,
                               murk_estimate *out, murk_error *err)
{
    return measure_anew(l, k,
                        holds_out(l->scene[k]) ? MURK_HELD_OUT_STREAM : 0u,
                        sensor, n, out, err);
}

static murk_status measure_fixed(const murk_sweep_light *l, size_t k,
                                 murk_study_row *row, murk_sight *sight,
                                 murk_error *err)
{
    const murk_stage *stage = l->stage[k];
    murk_pose *sensor = NULL;
    murk_estimate value = NONE;
    size_t n = 0;
    murk_status status =
        murk_placement_read(&sensor, &n, l->sweep->desc.study->plan, 1,
                            stage->scene, &stage->world.domain, err);
    if (!status) {
        status = murk_coverage_total_measure(&value, sight, sensor, n, err);
    }
    free(sensor);
    if (!status) {
        murk_study_row_add(row, "coverage_fixed", "", value);
    }
    return status;
}

static murk_status measure_best(murk_sweep_light *l, size_t k,
                                murk_study_row *row, murk_sight *sight,
                                murk_error *err)
{
    const murk_stage *stage = l->stage[k];
    murk_plan_result plan = {.without_curve = true};
    murk_estimate value = NONE;
    /* Choose the plan on the light of the row. */
    murk_status status =
        murk_plan_prepare(&plan, stage, l->sweep->desc.threads, err);
    if (!status) {
        status = murk_plan_choose(&plan, stage, sight, err);
    }
    const size_t n = plan.place.count;
    if (!status) {
        status =
            murk_study_row_set_sensors(row, stage->scene, plan.sensor, n, err);
    }
    /* Measure the plan on held-out light if the scene holds light out, else on
     * the light that chose the plan. */
    if (!status && holds_out(stage->scene)) {
        status = measure_anew(l, k, MURK_HELD_OUT_STREAM, plan.sensor, n,
                              &value, err);
    } else if (!status) {
        status =
            murk_coverage_total_measure(&value, sight, plan.sensor, n, err);
    }
    murk_plan_result_release(&plan);
    if (!status) {
        murk_study_row_add(row, "coverage_best", "", value);
    }
    return status;
}

murk_status murk_sweep_measure_coverage(murk_sweep_light *l, size_t k,
                                        murk_study_row *row,
                                        const murk_traced *traced,
                                        murk_error *err)
{
    const murk_stage *stage = l->stage[k];
    const murk_outputs *outputs = &l->sweep->outputs;
    const bool is_fixed = outputs->wants[MURK_OUTPUT_FIXED],
               is_best = outputs->wants[MURK_OUTPUT_BEST];
    murk_sight *sight = NULL;
    if (!is_fixed && !is_best) {
        return MURK_OK;
    }
    /* Without anything to see all coverages are NaN. */
    if (!traced || !murk_sweep_has_seen(stage, traced)) {
        if (traced) {
            murk_study_add_note(row->note,
                                "no photon is stored: nothing to cover");
        }
        if (is_fixed) {
            murk_study_row_add(row, "coverage_fixed", "", NONE);
        }
        if (is_best) {
            murk_study_row_add(row, "coverage_best", "", NONE);
        }
        return MURK_OK;
    }
    /* One sight serves both coverages. */
    murk_status status =
        murk_plan_sight(&sight, stage, traced, l->sweep->desc.threads, err);
    if (!status && is_fixed) {
        status = measure_fixed(l, k, row, sight, err);
    }
    if (!status && is_best) {
        status = measure_best(l, k, row, sight, err);
    }
    murk_sight_destroy(sight);
    return status;
}
