/* murk place: traces, senses and places for a scene or for its conditions,
 * repeats the job with other seeds if asked for, and writes the results. A
 * coverage matrix from a file is handled in place_matrix.c. */
#include "app/place_matrix.h"
#include "app/session.h"
#include "cases/condition_plans.h"
#include "results/candidates.h"
#include "results/condition_results.h"
#include "results/coverage.h"
#include "results/explore.h"
#include "results/exports.h"
#include "results/goals.h"
#include "results/plan_files.h"
#include "results/repeat.h"
#include "results/robust.h"
#include "results/summary.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

/* Bytes of the name of a result file of a condition, "scene-NAME.yaml". */
#define FILE_SIZE (MURK_SCENE_NAME_SIZE + 16)

/* The plan is shown before other seeds are run: hours of them may end in a
 * failure or an interrupt, which is told late, too. */
static murk_status repeat_all(murk_session *session,
                              const murk_plan_result *plan,
                              const murk_condition_plans *over,
                              murk_repeat *repeat, size_t runs,
                              murk_error *late, murk_error *err)
{
    const murk_plan_results results = {session, plan, over, NULL};
    const murk_repeat_first first = {plan, session->stage, over};
    const murk_status status =
        murk_session_keep(session, "plan.json",
                          murk_results_json(murk_results_list_plan, &results),
                          murk_print_plan, &results, err);
    if (!status) {
        (void)murk_repeat_make(repeat, &first, runs, session->settings.threads,
                               late);
    }
    return status;
}

/* Writes plan.json last, with repeat.csv if seeds were repeated. */
static murk_status finish(murk_session *session,
                          const murk_plan_results *results, murk_error *err)
{
    const murk_status status =
        results->repeat
            ? murk_results_add_csv(
                  &session->results, "repeat.csv", murk_results_list_run,
                  results->repeat->repeat, results->repeat->repeat->runs, err)
            : MURK_OK;
    return status ? status
                  : murk_session_finish(
                        session, "plan.json",
                        murk_results_json(murk_results_list_plan, results),
                        murk_print_plan, results, err);
}

static murk_status check_repeat(const murk_session *session, uint64_t runs,
                                murk_error *err)
{
    const murk_scene_desc *scene = session->scene;
    /* Every run has a seed of its own. */
    if (runs > 0 && scene->seed + (runs - 1) > UINT32_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, "--repeat",
                         "%llu seeds from %lu on, must end at 4294967295 at "
                         "most",
                         (unsigned long long)runs, (unsigned long)scene->seed);
    }
    /* Goals that repeats or the exported problem cannot state. */
    if ((runs > 0 || session->settings.exports & MURK_EXPORT_LP) &&
        murk_plan_at_least(scene) > 0) {
        return murk_fail(err, MURK_BAD_VALUE, scene->placement.where,
                         "at_least is given, which %s does not take: %s",
                         runs > 0 ? "--repeat" : "--export lp",
                         runs > 0 ? "run place once for each --seed, or use "
                                    "placement.redundancy"
                                  : "use --export matrix or or-library");
    }
    /* A seed fixed by a condition would be the same in all runs. */
    const bool has_conditions =
        scene->placement.over != MURK_SCENE_OBJECTIVE_NONE;
    for (size_t c = 0; runs > 0 && has_conditions && c < scene->n_conditions;
         ++c) {
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

static murk_status expect_files(murk_session *session, bool repeats,
                                murk_error *err)
{
    const murk_scene_placement *asked = &session->scene->placement;
    const bool explores = asked->knowledge == MURK_SCENE_EXPLORE;
    const bool has_conditions = asked->over != MURK_SCENE_OBJECTIVE_NONE;
    /* The files of every plan, and those of exploring and of repeats. */
    const char *names[10] = {"plan.json", "sensors.csv", "coverage.csv"};
    size_t n = 3;
    if (explores) {
        names[n++] = "explore.csv";
        names[n++] = "path.ply";
    }
    if (repeats) {
        names[n++] = "repeat.csv";
    }
    names[n++] = has_conditions ? "regret.csv" : "plan.ply";
    const murk_status status = murk_session_expect(session, names, err);
    return status           ? status
           : has_conditions ? expect_conditions(session, err)
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
        status = murk_plan_for_scene(plan, session->stage, session->traced,
                                     threads, err);
    }
    return status;
}

/* Over conditions, each of which has a light of its own. */
static murk_status place_conditions(murk_session *session,
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
    if (!status && session.scene->placement.over != MURK_SCENE_OBJECTIVE_NONE) {
        over = calloc(1, sizeof *over);
        status = over ? place_conditions(&session, options, &plan, over, err)
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
        status = murk_add_plan_files(&session, &plan, over, &late, err);
    }
    if (!status && seeds && plan.is_dark) {
        murk_note("--repeat", "it is dark, so nothing hangs on chance: once is "
                              "enough");
    } else if (!status && seeds) {
        status = repeat_all(&session, &plan, over, &repeat, (size_t)seeds,
                            &late, err);
    }
    murk_repeat_results repeated = {.repeat = &repeat};
    murk_plan_results results = {&session, &plan, over, NULL};
    if (!status && repeat.runs > 0) {
        results.repeat = &repeated;
        status = murk_repeat_sum_up(&repeated.summary, &repeat, err);
    }
    if (!status) {
        status = finish(&session, &results, err);
    }
    if (!status) {
        murk_print_run(&session, NULL, 0);
    }
    if (!status) { /* the plan is written, what is told late is not */
        status = murk_fail(err, late.code, late.where, "%s", late.text);
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
