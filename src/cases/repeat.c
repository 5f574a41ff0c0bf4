/* Repeats the whole job with other seeds and sums the runs up: the spread of
 * coverage, and a confidence interval of the optimality gap of the first plan
 * by the method of Mak, Morton and Wood (1999,
 * doi:10.1016/S0167-6377(98)00054-6). */
#include "cases/repeat.h"

#include "base/progress.h"
#include "base/quantile.h"
#include "base/ranks.h"
#include "cases/condition_plans.h"

#include <stdlib.h>
#include <string.h>

/* Probability beyond either end of the interval of the gap, of 95 %. */
#define MISS 0.025

static murk_status no_memory(size_t runs, murk_error *err)
{
    return murk_no_memory(err, "", "for %zu runs", runs);
}

const murk_scene_desc *murk_repeat_scene(const murk_repeat_first *first)
{
    return first->stage ? first->stage->scene : first->over->conditions->scene;
}

/* ---- runs ---- */

static const murk_estimate NO_ESTIMATE = {NAN, NAN};

static murk_repeat_run run_of(const murk_plan_result *plan, uint32_t seed)
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

/* Where sensors may stand does not depend on seeds, so candidates, poses and
 * start are those of the first plan. */
static murk_plan_result plan_again(const murk_plan_result *first)
{
    return (murk_plan_result){.candidates = first->candidates,
                              .poses = first->poses,
                              .start = first->start};
}

static void release_again(murk_plan_result *plan)
{
    plan->candidates = NULL;
    plan->poses = NULL;
    murk_plan_result_release(plan);
}

/* Measures the coverage of the plan with the present sight of each condition
 * (the photons or targets of this run), and combines the coverages of the
 * conditions by the objective of the scene. */
static murk_status measure(murk_estimate *out, const murk_plan_result *plan,
                           const murk_conditions *all, murk_error *err)
{
    murk_estimate of[MURK_SCENE_CONDITIONS_MAX];
    murk_status status = MURK_OK;
    for (size_t c = 0; !status && c < all->n; ++c) {
        murk_pose *sensor =
            murk_condition_sensors(&all->condition[c], plan->poses,
                                   plan->place.sensor, plan->place.count);
        status =
            sensor
                ? murk_coverage_total_measure(&of[c], all->condition[c].sight,
                                              sensor, plan->place.count, err)
                : no_memory(1, err);
        free(sensor);
    }
    if (!status) {
        size_t worst;
        *out = murk_conditions_estimate(all, of, all->scene->placement.over,
                                        false, &worst);
    }
    return status;
}

/* Runs the same job with seeds that are greater by `later`. */
static murk_status run_again(murk_repeat_run *out,
                             const murk_plan_result *first,
                             const murk_conditions *conditions, uint32_t later,
                             unsigned threads, murk_error *err)
{
    murk_condition_plans *over = calloc(1, sizeof *over);
    if (!over) {
        return no_memory(1, err);
    }
    /* Choose a plan under the other seed, in the worlds and with the
     * candidates of the first run. */
    murk_plan_result plan = plan_again(first);
    murk_status status =
        murk_conditions_again(&over->conditions, conditions, later, err);
    if (!status) {
        status = murk_condition_plans_make(over, &plan, threads, err);
    }
    if (!status) {
        *out = run_of(&plan, over->conditions->scene->seed);
    }
    /* Measure the plan of the first run on the maps of this run, if these
     * differ from run to run. */
    if (!status && murk_plan_has_streams(over->conditions->scene)) {
        status = measure(&out->plan, first, over->conditions, err);
    }
    murk_condition_plans_release(over);
    free(over);
    release_again(&plan);
    return status;
}

murk_status murk_repeat_begin(murk_repeat *out, const murk_repeat_first *first,
                              size_t asked, murk_error *err)
{
    const murk_scene_desc *scene = murk_repeat_scene(first);
    *out = (murk_repeat){
        .run = calloc(asked, sizeof *out->run),
        .asked = asked,
        .target = scene->sensors.target,
        .has_gap = !(scene->sensors.target > 0) &&
                   scene->placement.over != MURK_SCENE_OBJECTIVE_WORST &&
                   scene->placement.over != MURK_SCENE_OBJECTIVE_REGRET};
    if (!out->run) {
        return no_memory(asked, err);
    }
    out->run[0] = run_of(first->plan, scene->seed);
    out->run[0].plan = out->run[0].held_out;
    out->runs = 1;
    return MURK_OK;
}

/* The further runs that are to be made. */
typedef struct making {
    murk_repeat *repeat;
    const murk_repeat_first *first;
    const murk_conditions *conditions;
    const bool *is_left_out; /* NULL: none is */
    unsigned threads;
} making;

static murk_status make_run(const making *m, size_t later, murk_error *err)
{
    murk_error why = {0};
    const murk_status status =
        run_again(&m->repeat->run[later], m->first->plan, m->conditions,
                  (uint32_t)later, m->threads, &why);
    return status ? murk_fail(err, status, why.where, "seed %lu: %s",
                              (unsigned long)murk_repeat_scene(m->first)->seed +
                                  later,
                              why.text)
                  : MURK_OK;
}

/* How the runs of one rank ended. */
typedef struct ending {
    uint64_t failed; /* number of the run that failed; UINT64_MAX: none did */
    murk_status status;
    murk_error error;
} ending;

/* The failure of the run with the lowest number, of all ranks. A failure here
 * is that of the exchange. */
static murk_status find_failure(ending *out, const ending *own, murk_error *err)
{
    murk_gathered all;
    const murk_status status =
        murk_ranks_gather(&all, own, sizeof *own, MURK_OK, err);
    *out = (ending){.failed = UINT64_MAX};
    for (unsigned r = 0; r < murk_ranks_count() && !status; ++r) {
        ending one;
        memcpy(&one, all.bytes + r * sizeof one, sizeof one);
        if (one.failed < out->failed) {
            *out = one;
        }
    }
    murk_gathered_release(&all);
    return status;
}

/* Makes all runs with the other ranks: each rank makes the next run until none
 * is left or a run has failed. Runs are dealt out in order, so those before the
 * failed one with the lowest number are made, as in a single process. */
static murk_status make_dealt(const making *m, murk_error *err)
{
    murk_repeat *repeat = m->repeat;
    murk_repeat_run *made = calloc(repeat->asked, sizeof *made);
    ending own = {.failed = UINT64_MAX}, first = own;
    murk_deal deal;
    murk_status status = murk_ranks_deal(
        &deal, made ? MURK_OK : no_memory(repeat->asked, err), err);
    const murk_ranks *ranks = murk_ranks_leave();
    uint64_t later = 0;
    while (!status && !own.status &&
           (later = murk_ranks_take(&deal) + 1) < repeat->asked) {
        if (m->is_left_out && m->is_left_out[later]) {
            continue;
        }
        own.status = make_run(m, (size_t)later, &own.error);
        if (own.status) {
            own.failed = later;
            murk_ranks_take_no_more(&deal);
        } else {
            made[later] = repeat->run[later];
            murk_progress_add_to_group(1);
        }
    }
    murk_ranks_return(ranks);
    /* Exchange. */
    status =
        murk_ranks_complete(made, repeat->asked * sizeof *made, status, err);
    if (!status) {
        status = find_failure(&first, &own, err);
    }
    const bool has_failed = first.failed < repeat->asked;
    repeat->runs = status       ? 1
                   : has_failed ? (size_t)first.failed
                                : repeat->asked;
    for (size_t i = 1; i < repeat->runs; ++i) {
        if (!m->is_left_out || !m->is_left_out[i]) {
            repeat->run[i] = made[i];
        }
    }
    free(made);
    return status || !has_failed
               ? status
               : murk_fail(err, first.status, first.error.where, "%s",
                           first.error.text);
}

murk_status murk_repeat_make(murk_repeat *out, const murk_repeat_first *first,
                             const bool *is_left_out, unsigned threads,
                             murk_error *err)
{
    murk_conditions *own = NULL; /* the scene as it stands */
    murk_status status =
        first->stage ? murk_conditions_of_stage(&own, first->stage, NULL, err)
                     : MURK_OK;
    const murk_conditions *conditions =
        first->stage ? own : first->over->conditions;
    /* Count the runs, the first one included. */
    size_t total = out->asked, done = 1;
    for (size_t i = 1; i < out->asked && is_left_out; ++i) {
        total -= is_left_out[i];
    }
    /* The other runs: one seed after the other, or dealt to ranks. */
    murk_progress_begin_group("repeat", total, "seeds");
    murk_progress_add_to_group(1);
    const making m = {out, first, conditions, is_left_out, threads};
    if (!status && murk_ranks_count() > 1) {
        status = make_dealt(&m, err);
    }
    while (out->runs < out->asked && !status) {
        const size_t later = out->runs;
        if (is_left_out && is_left_out[later]) {
            ++out->runs;
            continue;
        }
        murk_progress_part(done + 1, total, done);
        status = make_run(&m, later, err);
        if (!status) {
            ++out->runs;
            ++done;
            murk_progress_add_to_group(1);
        }
    }
    murk_progress_part(0, 0, 0);
    murk_progress_end();
    murk_conditions_destroy(own);
    return status;
}

void murk_repeat_release(murk_repeat *repeat)
{
    free(repeat->run);
    *repeat = (murk_repeat){0};
}

/* ---- the summary ---- */

static murk_spread spread_of(double *x, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        if (isnan(x[i])) {
            return (murk_spread){NAN, NAN, NAN};
        }
    }
    murk_sort(x, n);
    return (murk_spread){.median = (x[(n - 1) / 2] + x[n / 2]) / 2,
                         .min = x[0],
                         .max = x[n - 1]};
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
    double *x = calloc(6 * n, sizeof *x);
    if (!x) {
        return no_memory(n, err);
    }
    double *sensors = x, *in_sample = x + n, *held_out = x + 2 * n,
           *upper = x + 3 * n, *plan = x + 4 * n, *gap = x + 5 * n;
    size_t measured = 0; /* runs that measured the first plan */
    murk_repeat_summary s = {.best = n};
    double best = -1;
    for (size_t i = 0; i < n; ++i) {
        const murk_repeat_run *run = &repeat->run[i];
        sensors[i] = (double)run->sensors;
        in_sample[i] = run->in_sample;
        held_out[i] = run->held_out.value;
        upper[i] = run->upper;
        if (isfinite(run->plan.value)) {
            plan[measured] = run->plan.value;
            gap[measured++] = run->upper - run->plan.value;
        }
        /* The best run, and the runs that meet the target. */
        if (held_out[i] > best) {
            s.best = i;
            best = held_out[i];
        }
        s.met += repeat->target > 0 && held_out[i] >= repeat->target;
    }
    /* Means first, because spreads sort. */
    s.upper_mean = murk_mean_estimate(upper, n);
    s.plan = murk_mean_estimate(plan, measured);
    s.gap = gap_of(gap, repeat->has_gap ? measured : 0);
    s.sensors = spread_of(sensors, n);
    s.in_sample = spread_of(in_sample, n);
    s.held_out = spread_of(held_out, n);
    s.upper = spread_of(upper, n);
    *out = s;
    free(x);
    return MURK_OK;
}
