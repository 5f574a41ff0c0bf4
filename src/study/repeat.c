#include "study/repeat.h"

#include "base/progress.h"
#include "base/quantile.h"

#include <stdlib.h>

#define MISS 0.025 /* beyond either end of the gap's interval */

static murk_status no_memory(size_t runs, murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu runs", runs);
}

/* ---- runs ---- */

static const murk_estimate NO_ESTIMATE = {NAN, NAN};

static murk_repeat_run run_of(const murk_plan *plan, uint32_t seed)
{
    const murk_place_result *place = &plan->place;
    return (murk_repeat_run){
        .seed = seed,
        .sensors = place->count,
        .in_sample = plan->in_sample.total.value,
        .upper = (double)place->upper / (double)place->whole,
        .proven_optimal = place->proven_optimal,
        .held_out = plan->has_held_out ? plan->held_out : NO_ESTIMATE,
        .plan = NO_ESTIMATE};
}

/* The plan's coverage in this light. */
static murk_status measure(murk_estimate *out, const murk_plan *plan,
                           const murk_stage *stage, const murk_traced *traced,
                           unsigned threads, murk_error *err)
{
    murk_sight *sight = NULL;
    murk_coverage coverage = {0};
    murk_status status = murk_plan_sight(&sight, stage, traced, threads, err);
    if (!status) {
        status = murk_coverage_measure(&coverage, sight, plan->sensor,
                                       plan->place.count, err);
    }
    if (!status) {
        *out = coverage.total;
    }
    murk_coverage_release(&coverage);
    murk_sight_destroy(sight);
    return status;
}

/* The same world under another seed. Where sensors may stand does not depend on
 * seeds, so candidates and poses are the first plan's. */
static murk_status run_again(murk_repeat_run *out, const murk_stage *stage,
                             const murk_plan *first, uint32_t seed,
                             unsigned threads, murk_error *err)
{
    murk_scene scene = *stage->scene;
    scene.seed = seed;
    scene.placement.jitter_m = scene.placement.jitter_rad = 0;
    murk_stage again = *stage;
    again.scene = &scene;
    murk_traced *traced = NULL;
    murk_plan plan = {.candidates = first->candidates,
                      .poses = first->poses,
                      .start = first->start};
    murk_status status = murk_plan_see_anew(&traced, &again, 0, threads, err);
    if (!status) {
        status = murk_plan_make(&plan, &again, traced, threads, err);
    }
    if (!status) {
        *out = run_of(&plan, seed);
    }
    if (!status && murk_plan_can_see_anew(&scene)) {
        status = measure(&out->plan, first, &again, traced, threads, err);
    }
    plan.candidates = NULL; /* borrowed */
    plan.poses = NULL;
    murk_plan_release(&plan);
    murk_traced_destroy(traced);
    return status;
}

murk_status murk_repeat_make(murk_repeat *out, const murk_stage *stage,
                             const murk_plan *first, size_t asked,
                             unsigned threads, murk_error *err)
{
    *out = (murk_repeat){.run = calloc(asked, sizeof *out->run),
                         .asked = asked,
                         .target = stage->scene->sensors.target};
    if (!out->run) {
        return no_memory(asked, err);
    }
    out->run[0] = run_of(first, stage->scene->seed);
    out->run[0].plan = out->run[0].held_out;
    murk_status status = MURK_OK;
    for (out->runs = 1; out->runs < asked && !status;) {
        const uint32_t seed = stage->scene->seed + (uint32_t)out->runs;
        murk_error told = {0};
        murk_progress_part(out->runs + 1, asked);
        status =
            run_again(&out->run[out->runs], stage, first, seed, threads, &told);
        if (status) {
            status = murk_fail(err, status, told.where, "seed %lu: %s",
                               (unsigned long)seed, told.text);
        } else {
            ++out->runs;
        }
    }
    murk_progress_part(0, 0);
    return status;
}

void murk_repeat_release(murk_repeat *repeat)
{
    free(repeat->run);
    *repeat = (murk_repeat){0};
}

/* ---- the summary ---- */

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static murk_spread spread_of(double *x, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        if (isnan(x[i])) {
            return (murk_spread){NAN, NAN, NAN};
        }
    }
    qsort(x, n, sizeof *x, by_value);
    return (murk_spread){.median = (x[(n - 1) / 2] + x[n / 2]) / 2,
                         .least = x[0],
                         .most = x[n - 1]};
}

static murk_gap gap_of(const double *difference, size_t n)
{
    const murk_estimate mean = murk_mean_estimate(difference, n);
    murk_gap gap = {.runs = n, .value = mean.value, .lower = NAN, .upper = NAN};
    if (n >= 2) {
        const double half =
            murk_student_upper(MISS, n - 1) * mean.standard_error;
        gap.lower = mean.value - half;
        gap.upper = mean.value + half;
    }
    return gap;
}

murk_status murk_repeat_sum_up(murk_repeat_summary *out,
                               const murk_repeat *repeat, murk_error *err)
{
    const size_t n = repeat->runs;
    double *x = malloc(n * sizeof *x);
    if (!x) {
        return no_memory(n, err);
    }
    murk_repeat_summary s = {.best = n};
    for (size_t i = 0; i < n; ++i) {
        x[i] = (double)repeat->run[i].sensors;
    }
    s.sensors = spread_of(x, n);
    for (size_t i = 0; i < n; ++i) {
        x[i] = repeat->run[i].in_sample;
    }
    s.in_sample = spread_of(x, n);
    for (size_t i = 0; i < n; ++i) {
        const double held_out = x[i] = repeat->run[i].held_out.value;
        if (held_out > (s.best < n ? repeat->run[s.best].held_out.value : -1)) {
            s.best = i;
        }
        s.met += repeat->target > 0 && held_out >= repeat->target;
    }
    s.held_out = spread_of(x, n);
    for (size_t i = 0; i < n; ++i) {
        x[i] = repeat->run[i].upper;
    }
    s.upper_mean = murk_mean_estimate(x, n);
    s.upper = spread_of(x, n);
    size_t measured = 0;
    for (size_t i = 0; i < n; ++i) {
        if (isfinite(repeat->run[i].plan.value)) {
            x[measured++] = repeat->run[i].plan.value;
        }
    }
    s.plan = murk_mean_estimate(x, measured);
    size_t pairs = 0;
    for (size_t i = 0; i < n; ++i) {
        if (isfinite(repeat->run[i].plan.value) && !(repeat->target > 0)) {
            x[pairs++] = repeat->run[i].upper - repeat->run[i].plan.value;
        }
    }
    s.gap = gap_of(x, pairs);
    *out = s;
    free(x);
    return MURK_OK;
}
