#include "app/place_matrix.h"
#include "app/session.h"
#include "cases/condition_plans_make.h"
#include "results/candidates.h"
#include "results/coverage.h"
#include "results/explore.h"
#include "results/exports.h"
#include "results/goals.h"
#include "results/over.h"
#include "results/plan.h"
#include "results/repeat.h"
#include "results/robust.h"
#include "results/summary.h"
#include "results/tallies.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

#define FILE_SIZE (MURK_SCENE_NAME_SIZE + 16)

static void add_candidates(cJSON *root, const murk_plan_result *plan)
{
    cJSON *object = murk_json_candidates(root, plan->candidates);
    cJSON_AddNumberToObject(object, "poses", (double)plan->poses->count);
    cJSON_AddNumberToObject(object, "after_presolve",
                            (double)plan->place.after_presolve);
}

static void add_coverage(cJSON *root, const murk_plan_result *plan,
                         bool is_strict)
{
    cJSON *object = cJSON_AddObjectToObject(root, "coverage");
    murk_json_number(object, "in_sample", plan->in_sample.total.value);
    murk_json_number(object, "held_out",
                     plan->has_held_out ? plan->held_out.value : NAN);
    murk_json_number(object, "held_out_standard_error",
                     plan->has_held_out ? plan->held_out.standard_error : NAN);
    murk_json_number(object, "in_sample_standard_error",
                     plan->in_sample.total.standard_error);
    murk_json_number(object, "surface", plan->in_sample.surface.value);
    murk_json_number(object, "surface_standard_error",
                     plan->in_sample.surface.standard_error);
    murk_json_number(object, "volume", plan->in_sample.volume.value);
    murk_json_number(object, "volume_standard_error",
                     plan->in_sample.volume.standard_error);
    murk_json_number(
        object, "ceiling",
        is_strict ? NAN : murk_share(plan->place.ceiling, plan->place.whole));
    murk_json_number(object, "sum_of_views", plan->in_sample.sum_of_views);
}

/* The strict question: asked, reached, and whether fewer cannot do. */
static void add_strict(cJSON *target, const murk_plan_result *plan,
                       const murk_scene_desc *scene)
{
    const size_t at_least = murk_plan_at_least(scene);
    if (at_least > 0) {
        cJSON_AddNumberToObject(target, "at_least", (double)at_least);
        murk_json_number(target, "reached",
                         plan->is_dark ? NAN : plan->in_sample.at_least.value);
        murk_json_number(
            target, "reached_standard_error",
            plan->is_dark ? NAN : plan->in_sample.at_least.standard_error);
        murk_json_number(target, "ceiling",
                         murk_share(plan->place.ceiling, plan->place.whole));
        cJSON_AddBoolToObject(target, "proven_fewest",
                              !plan->is_dark &&
                                  plan->place.count <= plan->place.fewest);
    }
}

static void add_target(cJSON *root, const murk_plan_result *plan,
                       const murk_scene_desc *scene)
{
    if (scene->sensors.target > 0) {
        cJSON *object = cJSON_AddObjectToObject(root, "target");
        murk_json_number(object, "asked", scene->sensors.target);
        murk_json_number(object, "fewest_possible",
                         plan->is_dark ? NAN : (double)plan->place.fewest);
        add_strict(object, plan, scene);
        murk_json_number(object, "confirmed", plan->confirmed.value);
        murk_json_number(object, "confirmed_standard_error",
                         plan->confirmed.standard_error);
    }
}

static void add_budget(cJSON *root, const murk_plan_result *plan,
                       const murk_scene_desc *scene)
{
    if (scene->sensors.budget > 0) {
        cJSON *object = cJSON_AddObjectToObject(root, "budget");
        murk_json_number(object, "asked", scene->sensors.budget);
        murk_json_number(object, "spent",
                         (double)plan->place.cost * MURK_COST_UNIT);
    }
}

static void add_placement(cJSON *root, const murk_plan_result *plan,
                          const murk_scene_desc *scene)
{
    static const char *const through_names[] = {[MURK_SCENE_THIN] = "thin",
                                                [MURK_SCENE_BLOCK] = "block",
                                                [MURK_SCENE_REFRACT] =
                                                    "refract"};
    const murk_scene_placement *settings = &scene->placement;
    cJSON *object = cJSON_AddObjectToObject(root, "placement");
    cJSON_AddStringToObject(object, "method",
                            settings->knowledge == MURK_SCENE_EXPLORE
                                ? "greedy"
                                : murk_method_names[settings->method]);
    cJSON_AddStringToObject(object, "detection",
                            murk_detection_name(settings->detection));
    murk_json_number(
        object, "threshold",
        murk_detection_is(settings->detection, MURK_DETECTION_HAS_THRESHOLD)
            ? settings->threshold
            : NAN);
    murk_json_number(object, "power_radius_m",
                     plan->power_radius_m > 0 ? plan->power_radius_m : NAN);
    murk_json_number(object, "power_neighbours",
                     plan->power_neighbours ? (double)plan->power_neighbours
                                            : NAN);
    cJSON_AddNumberToObject(object, "redundancy", (double)settings->redundancy);
    cJSON_AddStringToObject(object, "visibility",
                            settings->by_normal ? "normal" : "ray");
    cJSON_AddStringToObject(object, "through",
                            through_names[settings->through]);
    cJSON_AddStringToObject(object, "knowledge",
                            murk_knowledge_names[settings->knowledge]);
    cJSON_AddNumberToObject(object, "restarts", (double)settings->restarts);
    cJSON_AddNumberToObject(object, "starts", (double)plan->place.restarts);
    cJSON_AddNumberToObject(object, "evaluations",
                            (double)plan->place.evaluations);
    cJSON_AddNumberToObject(object, "queries", (double)plan->queries);
    cJSON_AddNumberToObject(object, "shadow_rays", (double)plan->shadow_rays);
    cJSON_AddNumberToObject(object, "sightlines_blocked_by_interfaces",
                            (double)plan->blocked_by_interfaces);
    cJSON_AddNumberToObject(object, "sightlines_totally_reflected",
                            (double)plan->totally_reflected);
    cJSON_AddNumberToObject(object, "nodes", (double)plan->place.nodes);
    murk_json_cut(object, &plan->place);
}

/* over NULL: the scene as it stands. */
static cJSON *plan_json(const murk_session *session,
                        const murk_plan_result *plan,
                        const murk_condition_plans *over)
{
    cJSON *root = murk_json_begin(session->scene);
    if (over) {
        murk_over_json_photons(root, over);
    } else {
        murk_json_photons(root, session->traced);
    }
    murk_json_targets(root, session->scene, &plan->targets);
    add_candidates(root, plan);
    murk_json_sensors(root, session->scene, plan->sensor, plan->place.count,
                      &plan->in_sample);
    add_coverage(root, plan, murk_plan_at_least(session->scene) > 0);
    murk_json_weights(root, session->scene, &plan->in_sample);
    murk_json_seen(root, &plan->in_sample, plan->place.count);
    murk_json_regions(root, session->scene, plan->in_sample.region,
                      plan->held_out_region);
    murk_json_robust(root, session->scene, &plan->robust);
    murk_json_bound(root, &plan->place);
    add_target(root, plan, session->scene);
    add_budget(root, plan, session->scene);
    murk_json_explore(root, session->scene, plan);
    add_placement(root, plan, session->scene);
    if (over) {
        murk_over_json(root, over);
    }
    return root;
}

static murk_status print_plan(const murk_session *session,
                              const murk_plan_result *plan,
                              const murk_condition_plans *over,
                              const murk_repeat *repeat, murk_error *err)
{
    const murk_place_result *place = &plan->place;
    murk_status status = MURK_OK;
    if (!over) {
        murk_print_light(session);
        murk_print_tallies(session);
    }
    murk_print_targets(&plan->targets);
    murk_print_candidates(plan->candidates);
    if (over) {
        murk_over_print(over);
    }
    murk_print_sensors(session->scene, plan->sensor, place->count,
                       &plan->in_sample, session->results.folder);
    if (plan->is_dark) {
        murk_print("coverage    none: it is dark, and no sensor is better than "
                   "another\n");
    } else {
        murk_print("coverage    %.4f in sample (", plan->in_sample.total.value);
        murk_print_maps(&plan->in_sample);
        murk_print(")");
        if (murk_plan_at_least(session->scene) == 0) {
            murk_print("; all candidates: %.4f",
                       murk_share(place->ceiling, place->whole));
        }
        murk_print("\n");
        murk_print_weights(session->scene, &plan->in_sample);
    }
    if (plan->has_held_out) {
        murk_print("held out    ");
        murk_print_estimate(plan->held_out);
        if (isfinite(plan->held_out.standard_error)) {
            murk_print(" (one standard error, %s)",
                       murk_error_by(session->scene));
        }
        murk_print("\n");
    }
    if (session->scene->sensors.target > 0 && !plan->is_dark) {
        const size_t at_least = murk_plan_at_least(session->scene);
        murk_print("target      %.4f ", session->scene->sensors.target);
        if (at_least > 0) {
            murk_print("seen by %zu or more ", at_least);
        }
        murk_print("takes %zu sensors, and no fewer than %zu", place->count,
                   place->fewest);
        if (at_least > 0) {
            murk_print("; %.4f in sample, of all candidates %.4f",
                       plan->in_sample.at_least.value,
                       murk_share(place->ceiling, place->whole));
        }
        if (isfinite(plan->confirmed.value)) {
            murk_print("; on a third map ");
            murk_print_estimate(plan->confirmed);
        }
        murk_print("\n");
    }
    murk_print_regions(session->scene, plan->in_sample.region,
                       plan->held_out_region);
    murk_print_robust(session->scene, &plan->robust);
    if (session->scene->sensors.budget > 0) {
        murk_print("budget      %.10g of %.10g spent\n",
                   (double)place->cost * MURK_COST_UNIT,
                   session->scene->sensors.budget);
    }
    if (!plan->is_dark) {
        if (session->scene->placement.over == MURK_SCENE_OVER_REGRET) {
            murk_over_print_bound(over, murk_sample_of(session->scene));
        } else {
            const size_t at_least = murk_plan_at_least(session->scene);
            char sample[80];
            snprintf(sample, sizeof sample,
                     at_least ? "%s by %zu or more" : "%s",
                     murk_sample_of(session->scene), at_least);
            murk_print_bound(place, session->scene->sensors.budget > 0, sample);
        }
        murk_print_explore(plan, session->results.folder);
    }
    if (repeat->runs > 0) {
        status = murk_print_repeat(repeat, err);
    }
    murk_print_time(&session->run, NULL, 0);
    murk_print_files(session);
    return status;
}

static murk_status write_light(murk_session *session, murk_error *err)
{
    murk_status status = murk_session_add_light(session, err);
    if (!status) {
        status = murk_session_add_ledger(session, err);
    }
    if (!status) {
        status = murk_add_tallies(session, err);
    }
    return status;
}

static murk_status add_files(murk_session *session,
                             const murk_plan_result *plan,
                             const murk_condition_plans *over, murk_error *late,
                             murk_error *err)
{
    murk_status status = over ? murk_over_add_files(session, plan, over, err)
                              : write_light(session, err);
    if (!status) {
        status = murk_add_sensors_csv(&session->results, session->scene,
                                      plan->sensor, plan->place.count, err);
    }
    if (!status) {
        status = murk_add_coverage_csv(&session->results, session->scene,
                                       plan->sensor, plan->place.count,
                                       &plan->in_sample, err);
    }
    if (!status) {
        status = murk_add_explore(&session->results, session->stage, plan, err);
    }
    if (!status && !over) {
        status = murk_exports_add_plan(session, plan, late, err);
    }
    return status;
}

/* The plan is shown before other seeds are run: hours of them may end in a
 * failure or an interrupt, which is told late, too. */
static murk_status repeat_all(murk_session *session,
                              const murk_plan_result *plan,
                              const murk_condition_plans *over,
                              murk_repeat *repeat, size_t runs,
                              murk_error *late, murk_error *err)
{
    const murk_repeat_first first = {plan, session->stage, over};
    const murk_status status = murk_session_keep(
        session, "plan.json", plan_json(session, plan, over), err);
    if (!status) {
        (void)murk_repeat_make(repeat, &first, runs, session->settings.threads,
                               late);
    }
    return status;
}

/* With a row of repeat.csv a seed where it was repeated. */
static murk_status finish(murk_session *session, const murk_plan_result *plan,
                          const murk_condition_plans *over,
                          const murk_repeat *repeat, murk_error *err)
{
    cJSON *root = plan_json(session, plan, over);
    murk_status status = MURK_OK;
    if (repeat->runs > 0) {
        status = murk_json_repeat(root, repeat, err);
    }
    if (!status && repeat->runs > 0) {
        status = murk_add_repeat_csv(&session->results, repeat, err);
    }
    if (status) {
        cJSON_Delete(root);
        return status;
    }
    return murk_session_finish(session, "plan.json", root, err);
}

static murk_status check_repeat(const murk_session *session, uint64_t runs,
                                murk_error *err)
{
    const murk_scene_desc *scene = session->scene;
    if (runs > 0 && scene->seed + (runs - 1) > UINT32_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, "--repeat",
                         "%llu seeds from %lu on, must end at 4294967295 at "
                         "most",
                         (unsigned long long)runs, (unsigned long)scene->seed);
    }
    if ((runs > 0 || session->settings.exports & MURK_EXPORT_LP) &&
        murk_plan_at_least(scene) > 0) {
        return murk_fail(err, MURK_BAD_VALUE, scene->placement.where,
                         "at_least is given, which %s does not take: %s",
                         runs > 0 ? "--repeat" : "--export lp",
                         runs > 0 ? "run place once for each --seed, or use "
                                    "placement.redundancy"
                                  : "use --export matrix or or-library");
    }
    const bool is_over = scene->placement.over != MURK_SCENE_OVER_NONE;
    for (size_t c = 0; runs > 0 && is_over && c < scene->n_conditions; ++c) {
        if (scene->conditions[c].scene->seed != scene->seed) {
            return murk_fail(err, MURK_BAD_VALUE, scene->conditions[c].where,
                             "seed: one of its own, which other runs of "
                             "--repeat would share; leave it out");
        }
    }
    return MURK_OK;
}

/* Checks the result files that are written for each condition. */
static murk_status expect_conditions(murk_session *session, murk_error *err)
{
    static const char *const begin[] = {"light", "ledger", "plan", "scene"};
    static const char *const end[] = {".murk", ".json", ".ply", ".yaml"};
    const murk_scene_desc *scene = session->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < 4 * scene->n_conditions && !status; ++i) {
        const murk_scene_condition *condition = &scene->conditions[i / 4];
        const size_t k = i % 4;
        char name[FILE_SIZE];
        snprintf(name, sizeof name, "%s-%s%s", begin[k], condition->name,
                 end[k]);
        status = murk_results_expect(&session->results, name,
                                     k == 3 ? condition->scene->resolved : NULL,
                                     err);
    }
    return status;
}

/* Of a plan, over conditions or not; explore and repeat have a file more. */
static murk_status expect_files(murk_session *session, bool repeats,
                                murk_error *err)
{
    const bool explores =
        session->scene->placement.knowledge == MURK_SCENE_EXPLORE;
    const bool is_over = session->scene->placement.over != MURK_SCENE_OVER_NONE;
    const char *names[10] = {"plan.json", "sensors.csv", "coverage.csv"};
    size_t n = 3;
    if (explores) {
        names[n++] = "explore.csv";
        names[n++] = "path.ply";
    }
    if (repeats) {
        names[n++] = "repeat.csv";
    }
    names[n++] = is_over ? "regret.csv" : "plan.ply";
    const murk_status status = murk_session_expect(session, names, err);
    return status    ? status
           : is_over ? expect_conditions(session, err)
                     : murk_session_expect_light(session, err);
}

static murk_status place(murk_session *session, const murk_options *options,
                         murk_plan_result *plan, murk_error *err)
{
    const unsigned threads = session->settings.threads;
    murk_status status = murk_session_build(session, err);
    if (!status) {
        status = murk_exports_begin(session, err);
    }
    if (!status) {
        status = expect_files(
            session, murk_option_text(options, "--repeat") != NULL, err);
    }
    if (!status) {
        status = murk_plan_prepare(plan, session->stage, threads, err);
    }
    if (!status) {
        status = murk_session_light(session, err);
    }
    if (!status) {
        status = murk_plan_result_make(plan, session->stage, session->traced,
                                       threads, err);
    }
    return status;
}

/* Over conditions, each of which has a light of its own. */
static murk_status place_over(murk_session *session,
                              const murk_options *options,
                              murk_plan_result *plan,
                              murk_condition_plans *over, murk_error *err)
{
    if (options->light || options->exports) {
        return murk_fail(err, MURK_BAD_VALUE,
                         options->light ? "--light" : "--export",
                         "not over conditions: each condition has its own "
                         "light; placement.over must be null");
    }
    murk_status status = murk_condition_plans_prepare(
        over, plan, session->scene, options->threads, err);
    session->run.load_s = murk_clock_s() - session->begun_s;
    if (!status) {
        status = expect_files(
            session, murk_option_text(options, "--repeat") != NULL, err);
    }
    if (!status) {
        status = murk_condition_plans_make(over, plan, options->threads, err);
    }
    return status;
}

murk_status murk_command_place(const murk_options *options, murk_error *err)
{
    if (options->matrix) {
        return murk_place_matrix(options, err);
    }
    const uint64_t seeds = murk_option_number(options, "--repeat", 0);
    murk_session session;
    murk_plan_result plan = {0};
    murk_condition_plans *over = NULL;
    murk_repeat repeat = {0};
    murk_error late = {0};
    murk_status status = murk_session_read(&session, options, err);
    if (!status) {
        status = check_repeat(&session, seeds, err);
    }
    if (!status) {
        status = murk_exports_check(options->exports,
                                    session.scene->placement.detection, err);
    }
    if (!status && session.scene->placement.over != MURK_SCENE_OVER_NONE) {
        over = calloc(1, sizeof *over);
        status = over ? place_over(&session, options, &plan, over, err)
                      : murk_fail(err, MURK_NO_MEMORY, session.scene->path,
                                  "no memory for conditions");
    } else if (!status) {
        status = place(&session, options, &plan, err);
    }
    if (!status) {
        session.run.trace_s = plan.trace_s;
        session.run.map_s = plan.map_s;
        session.run.sense_s = plan.sense_s;
        session.run.place_s = plan.place_s;
        status = add_files(&session, &plan, over, &late, err);
    }
    if (!status && seeds && plan.is_dark) {
        murk_note("--repeat", "it is dark, so nothing hangs on chance: once is "
                              "enough");
    } else if (!status && seeds) {
        status = repeat_all(&session, &plan, over, &repeat, (size_t)seeds,
                            &late, err);
    }
    if (!status) {
        status = finish(&session, &plan, over, &repeat, err);
    }
    if (!status && murk_session_speaks(&session)) {
        status = print_plan(&session, &plan, over, &repeat, err);
    }
    if (!status) { /* the plan is written, what is told late is not */
        status = murk_fail(err, late.status, late.where, "%s", late.text);
    }
    if (over) {
        murk_condition_plans_release(over);
        free(over);
    }
    murk_repeat_release(&repeat);
    murk_plan_result_release(&plan);
    murk_session_end(&session);
    return status;
}
