/* Chooses the sensors of a plan: checks the settings, and places by a coverage
 * matrix (known), by repeated visibility queries (unknown) or by exploration
 * (explore). */
#include "plan/plan.h"

#include "base/log.h"
#include "base/machine.h"
#include "base/progress.h"
#include "medium/rescaled.h"
#include "placement/at_least.h"
#include "plan/free_space.h"
#include "plan/row_cache.h"
#include "plan/start_plan.h"
#include "plan/start_sensors.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* An estimate that has no value. */
static const murk_estimate NO_ESTIMATE = {NAN, NAN};

murk_place_desc murk_plan_desc(const murk_scene_desc *scene)
{
    murk_place_desc desc = murk_place_defaults();
    desc.method = scene->placement.method;
    desc.count = (size_t)scene->sensors.count;
    desc.restarts = (size_t)scene->placement.restarts;
    desc.nodes = scene->placement.nodes;
    desc.row_memory =
        (uint64_t)(scene->placement.memory_mb * MURK_BYTES_PER_MB);
    desc.seed = scene->seed;
    desc.is_of_sequence = scene->timeline.given &&
                          scene->placement.over == MURK_SCENE_OBJECTIVE_NONE;
    return desc;
}

/* Fails if murk_sight_create() would fail, after light is traced, because of
 * acceptance angles or the radius of `detection: power`. */
static murk_status check_sensing(const murk_stage *stage, murk_error *err)
{
    const murk_scene_sensors *settings = &stage->scene->sensors;
    murk_status status = MURK_OK;
    for (size_t k = 0; k < settings->types && !status; ++k) {
        if (settings->type[k].acceptance_rad > 0) {
            status = murk_media_check_acceptance(stage->media, err);
        }
    }
    const double radius_m = murk_plan_power_radius_m(stage);
    if (!status && radius_m > 0) {
        status = murk_power_check_radius(radius_m, &stage->world.domain,
                                         stage->scene->placement.where, err);
    }
    return status;
}

/* Moves are pairs of sensors, which plans within a budget do not have; and a
 * target asks for coverage, whatever moves cost. */
static murk_status check_moves(const murk_scene_desc *scene, murk_error *err)
{
    const murk_scene_placement *p = &scene->placement;
    const murk_scene_sensors *sensors = &scene->sensors;
    if (sensors->budget > 0 && (p->limits_moves || p->move_cost > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, sensors->where,
                         "budget: placement.%s counts moves of a number of "
                         "sensors; give sensors.count or sensors.target",
                         p->limits_moves ? "moves_at_most" : "move_cost");
    }
    return sensors->target > 0 && p->move_cost > 0
               ? murk_fail(err, MURK_BAD_VALUE, sensors->where,
                           "target: a plan that reaches a coverage does not "
                           "weigh placement.move_cost; give sensors.count")
               : MURK_OK;
}

static const char *single_key(const murk_scene_desc *scene, bool has_start)
{
    const murk_scene_placement *p = &scene->placement;
    return murk_plan_at_least(scene) > 0                 ? "at_least"
           : has_start && p->limits_moves                ? "moves_at_most"
           : has_start && p->move_cost > 0               ? "move_cost"
           : scene->timeline.given && p->steps_ahead > 1 ? "look_ahead"
                                                         : NULL;
}

const char *murk_plan_single_key(const murk_scene_desc *scene)
{
    return single_key(scene, scene->placement.start_plan);
}

const char *murk_plan_single_key_of_steps(const murk_scene_desc *scene)
{
    return single_key(scene, true);
}

murk_status murk_plan_check(const murk_stage *stage, unsigned threads,
                            murk_error *err)
{
    const murk_scene_sensors *settings = &stage->scene->sensors;
    const bool by_power = murk_detection_is(stage->scene->placement.detection,
                                            MURK_DETECTION_BY_POWER);
    /* Sensors; a count, a target or a budget; and stored photons if they are
     * needed must be there. */
    if (!settings->given) {
        return murk_fail(err, MURK_BAD_VALUE, stage->scene->path,
                         "sensors: the scene has none");
    }
    if (settings->count < 1 && !(settings->target > 0) &&
        !(settings->budget > 0)) {
        return settings->all_failed
                   ? murk_fail(err, MURK_BAD_VALUE, settings->where,
                               "count: all sensors have failed at %g s",
                               stage->scene->timeline.at_s)
                   : murk_fail(err, MURK_BAD_VALUE, settings->where,
                               "count: not given; give sensors.count, "
                               "sensors.target or sensors.budget");
    }
    if (stage->scene->photons.maps == MURK_SCENE_MAPS_NONE &&
        (!stage->scene->placement.targets.given || by_power)) {
        return murk_fail(err, MURK_BAD_VALUE, stage->scene->photons.where,
                         "maps: none, but placing needs stored photons");
    }
    murk_status status = check_moves(stage->scene, err);
    if (!status) {
        status = check_sensing(stage, err);
    }
    return !status && stage->scene->placement.targets.given
               ? murk_targets_check(stage, threads, err)
               : status;
}

/* Makes the poses, and chooses those at which the search begins: at a plan that
 * is updated, or at that of the scene, of which sensors that have drifted are
 * poses, too. */
static murk_status make_poses(murk_plan_result *plan, const murk_stage *stage,
                              murk_error *err)
{
    const murk_candidates *sites = plan->candidates;
    murk_start_sensors start = {0};
    murk_status status =
        plan->start_sensor ? MURK_OK
                           : murk_start_sensors_read(&start, stage, sites, err);
    if (!status) {
        status = murk_poses_create_with(
            &plan->poses, stage->scene, &stage->world.domain, sites->position,
            sites->usable, start.drifted, start.n_drifted, err);
    }
    if (!status && plan->start_sensor) {
        status = murk_start_plan_take(plan->poses, plan->start_sensor,
                                      plan->start_sensors,
                                      "the plan that is updated", err);
    } else if (!status && stage->scene->placement.start_plan) {
        status = murk_start_plan_take(plan->poses, start.pose, start.n,
                                      stage->scene->placement.start_plan, err);
    }
    murk_start_sensors_release(&start);
    return status;
}

murk_status murk_plan_prepare(murk_plan_result *plan, const murk_stage *stage,
                              unsigned threads, murk_error *err)
{
    murk_status status = murk_plan_check(stage, threads, err);
    plan->power_radius_m = murk_plan_power_radius_m(stage);
    plan->power_neighbours = murk_plan_power_neighbours(stage);
    if (!status) {
        status = murk_sites_find(&plan->candidates, stage, threads, err);
    }
    if (!status) {
        status = make_poses(plan, stage, err);
    }
    if (!status) {
        status = murk_warn_of_fixed_sensors(stage, threads, err);
    }
    if (!status) {
        murk_poses_limit_moves(plan->poses, &stage->scene->placement);
    }
    if (!status && stage->scene->placement.knowledge == MURK_SCENE_EXPLORE) {
        status = murk_explore_start(&plan->start, stage, plan->candidates,
                                    plan->poses, err);
    }
    return status;
}

uint64_t murk_plan_value_of(double share, const murk_problem *problem)
{
    uint64_t whole = 0;
    for (size_t i = 0; i < problem->photons; ++i) {
        whole += (uint64_t)problem->weight[i] * MURK_CLEAR *
                 murk_problem_layers(problem);
    }
    /* The product of a share and a whole may exceed the exact value by
     * rounding: .195 of 200 is 39, but .195 in binary is slightly more. 2^-51
     * is two units in the last place. */
    const double value = ceil(share * (double)whole * (1 - 0x1p-51));
    return value < (double)whole ? (uint64_t)value : whole;
}

void murk_plan_add_work(murk_plan_result *plan, const murk_sight *sight)
{
    const murk_sight_work work = murk_sight_work_of(sight);
    plan->looks += work.queries - plan->forecast_queries;
    plan->shadow_rays += work.shadow_rays - plan->forecast_rays;
    plan->reused += work.reused;
    plan->blocked_by_interfaces += work.blocked_by_interfaces;
    plan->totally_reflected += work.totally_reflected;
}

void murk_plan_count_queries(murk_plan_result *plan, uint64_t queries)
{
    plan->queries = queries > 0 ? queries : plan->looks;
}

/* Explores with a cache of coverage rows, then computes bounds. The queries
 * that the bounds need do not count as work of choosing. */
static murk_status explore(murk_plan_result *plan, const murk_stage *stage,
                           murk_sight *sight, const murk_problem *problem,
                           murk_place_desc *desc, murk_error *err)
{
    murk_row_cache tried = {0};
    murk_status status = murk_row_cache_init(&tried, problem, err);
    desc->constraints = &plan->poses->constraints;
    if (!status) {
        status = murk_explore_run(&plan->explore, &plan->place, stage, sight,
                                  &tried.problem, plan->candidates, plan->poses,
                                  plan->start, desc, err);
    }
    murk_plan_add_work(plan, sight);
    murk_plan_count_queries(plan, plan->place.queries);
    if (!status) {
        status = murk_explore_bound(&plan->place, &plan->explore,
                                    &tried.problem, desc, err);
    }
    murk_row_cache_release(&tried);
    return status;
}

/* The number of candidates that the forecast evaluates at most, and the assumed
 * number of sweeps over the sensors of one start. Both are rough figures: the
 * method SPOQ (placement/place.h) sweeps until a sweep brings no gain, and
 * relocation follows. */
#define FORECAST_CANDIDATES 16
#define FORECAST_SWEEPS     4

/* The memory of a remembered row of the candidate [bytes], about: bits or a
 * list of photons, with a clarity of two bytes for each if needed
 * (placement/row.h). */
static double row_bytes(const murk_sparse_row *row, size_t photons)
{
    const double seen = (double)row->seen, all = (double)photons;
    return row->clarity ? fmin(2 * all, fmin(all / 8 + 2 * seen, 6 * seen))
                        : fmin(all / 8, 4 * seen);
}

/* For `method: best` in an unknown environment, with a count of at least 2,
 * without a target and without a start plan: forecasts the work from the rays
 * and the time of a sample of candidates, for as many starts as are made if no
 * start brings a gain, and prints the forecast beside the work in a known
 * environment, unless most rows can be cached. The looks and rays of the sample
 * are not part of the work of the plan (murk_plan_add_work()). */
static void forecast_unknown(murk_plan_result *plan, murk_sight *sight,
                             const murk_problem *problem,
                             const murk_place_desc *desc)
{
    const size_t n = problem->candidates;
    const size_t sample = n < FORECAST_CANDIDATES ? n : FORECAST_CANDIDATES;
    const uint64_t rays = murk_sight_work_of(sight).shadow_rays;
    const double begun_s = murk_clock_s();
    double bytes = 0;
    /* Other methods, single sensors, targets and start plans, which take the
     * place of all starts, get no forecast. */
    if (desc->method != MURK_PLACE_BEST || desc->count < 2 || desc->target ||
        desc->start_plan) {
        return;
    }
    /* Evaluate the sample. */
    for (size_t k = 0; k < sample; ++k) {
        murk_sparse_row row;
        problem->get_row(problem->context, 0, k * n / sample, &row);
        bytes += row_bytes(&row, problem->photons) * (double)n / (double)sample;
    }
    plan->forecast_queries = sample;
    plan->forecast_rays = murk_sight_work_of(sight).shadow_rays - rays;
    if (bytes <= (double)desc->row_memory) {
        return;
    }
    /* Scale to all evaluations. */
    const double each = (double)plan->forecast_rays / (double)sample;
    const double each_s =
        (murk_clock_s() - begun_s) / (double)sample / (double)problem->threads;
    const double starts = desc->restarts < MURK_STARTS_WITHOUT_GAIN
                              ? (double)desc->restarts
                              : (double)MURK_STARTS_WITHOUT_GAIN;
    const double queries =
        starts * FORECAST_SWEEPS * (double)desc->count * (double)n;
    murk_note(
        "placement.knowledge",
        "unknown with method: best looks again for each row that memory_mb "
        "does not hold: at most about %.2g visibility queries, %.2g shadow "
        "rays and %.2g s with %.0f starts (at most %zu are made). memory_mb: "
        "%.3g holds all rows; then, and with knowledge: known, %zu queries "
        "(%.2g rays, %.2g s) are looked up, and the plan is as good. method: "
        "greedy or spoq, or fewer restarts, take less time",
        queries, queries * each, queries * each_s, starts, desc->restarts,
        ceil(bytes / MURK_BYTES_PER_MB), n, each * (double)n,
        each_s * (double)n);
}

uint64_t murk_plan_memory_taken(const murk_matrix *earlier, uint64_t memory)
{
    const uint64_t taken = earlier ? murk_matrix_memory(earlier) : 0;
    return taken < memory ? taken : memory;
}

void murk_plan_forget_earlier(murk_plan_result *plan)
{
    if (plan->earlier) {
        murk_matrix_destroy(*plan->earlier->matrix);
        *plan->earlier->matrix = NULL;
    }
}

/* Leaves the matrix, and the numbers of sightlines of its rows, to the plan, if
 * that is asked for and the rows leave half of the memory for those of the next
 * plan; else destroys them. */
static void keep_matrix(murk_plan_result *plan, murk_matrix *matrix,
                        murk_row_counts *tested, uint64_t memory)
{
    if (matrix && tested && murk_matrix_bytes(matrix) <= memory / 2) {
        plan->matrix = matrix;
        plan->tested = tested;
        return;
    }
    murk_matrix_destroy(matrix);
    free(tested);
}

murk_row_counts *murk_plan_note_sightlines(size_t candidates)
{
    murk_row_counts *tested = malloc(candidates * sizeof *tested + 1);
    for (size_t i = 0; tested && i < candidates; ++i) {
        tested[i] = (murk_row_counts){.tested = MURK_NOT_TESTED};
    }
    return tested;
}

murk_status murk_plan_choose_free(murk_plan_result *plan,
                                  const murk_problem *problem,
                                  const murk_matrix *matrix,
                                  const murk_place_desc *like, murk_error *err)
{
    murk_place_desc desc = *like;
    murk_constraints rules;
    murk_place_result any = {0};
    if (desc.target) { /* its number of sensors is another */
        return MURK_OK;
    }
    desc.constraints = murk_poses_constraints_of_any(plan->poses, &rules);
    desc.with_curve = false;
    const murk_status status =
        murk_place_sensors(&any, problem, matrix, &desc, err);
    return murk_plan_take_free(plan, &any, status);
}

murk_status murk_plan_take_free(murk_plan_result *plan, murk_place_result *any,
                                murk_status status)
{
    if (!status) {
        const double whole = (double)any->whole;
        plan->free = (murk_free_plan){true,
                                      (double)any->value / whole,
                                      (double)any->upper / whole,
                                      (double)any->ceiling / whole,
                                      any->is_interrupted,
                                      any->is_late};
        plan->place.evaluations += any->evaluations;
        plan->place.nodes += any->nodes;
        plan->place.is_interrupted |= any->is_interrupted;
    }
    murk_place_release(any);
    return status;
}

/* Chooses the sensors by the method that placement.knowledge asks for. */
static murk_status choose(murk_plan_result *plan, const murk_stage *stage,
                          murk_sight *sight, murk_error *err)
{
    /* Settings; a target replaces the count. */
    murk_sight_problem seen;
    murk_sight_problem_init(&seen, sight, plan->poses->pose,
                            plan->poses->count);
    murk_place_desc desc = murk_plan_desc(stage->scene);
    desc.constraints = murk_poses_constraints(plan->poses);
    desc.start_plan = plan->poses->start;
    desc.start_size = plan->poses->starts;
    desc.with_curve = desc.with_curve && !plan->without_curve;
    if (stage->scene->sensors.target > 0) {
        desc.target =
            murk_plan_value_of(stage->scene->sensors.target, &seen.problem);
        desc.count = plan->poses->count;
    }
    murk_matrix *matrix = NULL;
    murk_status status = MURK_OK;
    double begun_s = murk_clock_s();
    /* Explore. */
    if (stage->scene->placement.knowledge == MURK_SCENE_EXPLORE) {
        status = explore(plan, stage, sight, &seen.problem, &desc, err);
        plan->place_s = murk_clock_s() - begun_s;
        return status;
    }
    /* Unknown environment: rows that are not cached are computed at each
     * evaluation. */
    if (stage->scene->placement.knowledge == MURK_SCENE_UNKNOWN) {
        forecast_unknown(plan, sight, &seen.problem, &desc);
        status =
            murk_place_sensors(&plan->place, &seen.problem, NULL, &desc, err);
        plan->place_s = murk_clock_s() - begun_s;
        murk_plan_add_work(plan, sight);
        murk_plan_count_queries(plan, plan->place.queries);
        return status;
    }
    /* Known environment: build the matrix, then choose. The rows of an earlier
     * plan, of which the new ones may take entries over, count towards the
     * memory of the rows. */
    murk_earlier_rows rows;
    status = murk_earlier_rows_create(&rows, plan->earlier, plan->poses, stage,
                                      sight, murk_plan_sight_again, err);
    rows.frees_rows = true;
    seen.problem.has_columns = plan->keeps_matrix;
    seen.tested = plan->keeps_matrix
                      ? murk_plan_note_sightlines(plan->poses->count)
                      : NULL;
    const uint64_t taken = murk_plan_memory_taken(rows.matrix, desc.row_memory);
    if (!rows.matrix) {
        murk_plan_forget_earlier(plan);
    }
    const size_t at_least = murk_plan_at_least(stage->scene);
    murk_at_least strict;
    murk_sight_problem_know(&seen, rows.known.get ? &rows.known : NULL);
    murk_at_least_init(&strict, &seen.problem, (unsigned)at_least);
    const murk_problem *problem = at_least ? &strict.problem : &seen.problem;
    if (!status) {
        status =
            murk_matrix_create(&matrix, problem, desc.row_memory - taken, err);
    }
    murk_sight_problem_know(&seen, NULL);
    murk_earlier_rows_release(&rows);
    murk_plan_forget_earlier(plan);
    plan->sense_s = murk_clock_s() - begun_s;
    begun_s = murk_clock_s();
    if (!status && at_least) {
        /* murk_place_at_least() counts photons that enough sensors see, so the
         * target is a share of the sum of the weights, without redundancy. */
        desc.target =
            murk_plan_value_of(stage->scene->sensors.target,
                               &(murk_problem){.photons = problem->photons,
                                               .weight = problem->weight});
        status = murk_place_at_least(&plan->place, problem, matrix, &desc, err);
    } else if (!status) {
        status = murk_place_sensors(&plan->place, problem, matrix, &desc, err);
    }
    if (!status && plan->poses->limits_moves) {
        status = murk_plan_choose_free(plan, problem, matrix, &desc, err);
    }
    keep_matrix(plan, matrix, seen.tested, desc.row_memory);
    plan->place_s = murk_clock_s() - begun_s;
    murk_plan_add_work(plan, sight);
    murk_plan_count_queries(plan, plan->place.queries);
    return status;
}

size_t murk_plan_at_least(const murk_scene_desc *scene)
{
    return scene->sensors.target > 0 ? (size_t)scene->placement.at_least : 0;
}

murk_status murk_plan_trace_stream(murk_traced **out, const murk_stage *stage,
                                   uint32_t stream, unsigned threads,
                                   murk_error *err)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    if (!settings->targets.given ||
        murk_detection_is(settings->detection, MURK_DETECTION_BY_POWER)) {
        return murk_lightmap_trace(out, stage, stream, threads, err);
    }
    *out = murk_traced_create(stage, stream, err);
    return *out ? MURK_OK : MURK_NO_MEMORY;
}

bool murk_plan_has_streams(const murk_scene_desc *scene)
{
    return !scene->placement.targets.points;
}

murk_status murk_plan_take_sensors(murk_plan_result *plan,
                                   const murk_scene_desc *scene,
                                   murk_error *err)
{
    plan->sensor = calloc(plan->place.count + 1, sizeof *plan->sensor);
    if (!plan->sensor) {
        return murk_no_memory(err, scene->path, "for the plan");
    }
    for (size_t i = 0; i < plan->place.count; ++i) {
        plan->sensor[i] = plan->poses->pose[plan->place.sensor[i]];
    }
    return MURK_OK;
}

murk_status murk_plan_choose(murk_plan_result *plan, const murk_stage *stage,
                             murk_sight *sight, murk_error *err)
{
    const murk_status status = choose(plan, stage, sight, err);
    if (status) {
        if (err && !err->where[0]) {
            snprintf(err->where, sizeof err->where, "%s",
                     stage->scene->sensors.where);
        }
        return status;
    }
    return murk_plan_take_sensors(plan, stage->scene, err);
}

murk_status murk_plan_result_make_dark(murk_plan_result *plan,
                                       const murk_stage *stage, murk_error *err)
{
    /* Every share is undefined. */
    const murk_poses *poses = plan->poses;
    const size_t n = poses->fixed;
    plan->is_dark = true;
    plan->place = (murk_place_result){.guarantee = "none: it is dark"};
    plan->confirmed = plan->held_out = NO_ESTIMATE;
    plan->explore.end = MURK_EXPLORE_NOTHING;
    plan->place.sensor = calloc(n + 1, sizeof *plan->place.sensor);
    if (!plan->place.sensor) {
        return murk_no_memory(err, stage->scene->path, "for the plan");
    }
    /* The plan consists of the fixed sensors. */
    plan->place.count = n;
    memcpy(plan->place.sensor, poses->fixed_number,
           n * sizeof *plan->place.sensor);
    murk_status status = murk_plan_take_sensors(plan, stage->scene, err);
    if (!status) {
        status = murk_dark_coverage(&plan->in_sample, stage, n, err);
    }
    return status ? status
                  : murk_robust_begin(&plan->robust, stage, plan->sensor, n,
                                      &plan->in_sample, err);
}

void murk_plan_result_release(murk_plan_result *plan)
{
    murk_matrix_destroy(plan->matrix);
    murk_passed_light_release(&plan->held);
    free(plan->tested);
    murk_candidates_destroy(plan->candidates);
    murk_poses_destroy(plan->poses);
    murk_place_release(&plan->place);
    murk_explore_release(&plan->explore);
    murk_coverage_result_release(&plan->in_sample);
    murk_robust_release(&plan->robust);
    free(plan->held_out_region);
    free(plan->sensor);
    *plan = (murk_plan_result){0};
}
