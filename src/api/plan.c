/* Plans: the sensors that placement chooses for a light, or over the conditions
 * of a scene. The plans for a matrix are made in matrix_plan.c. */

#include "api/matrix_plan.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "cases/repeat_part.h"
#include "lightmap/light_update.h"
#include "results/plan_files.h"
#include "results/repeat.h"

#include <math.h>
#include <stdlib.h>

/* Makes a plan that has no sensors yet. NULL when out of memory. */
static murk_plan *make(murk_world *world)
{
    murk_plan *plan = calloc(1, sizeof *plan);
    if (plan) {
        plan->world = world;
        ++world->references;
        plan->session = murk_world_session(world);
    }
    return plan;
}

/* Copies the times of tracing, of building maps, of sensing and of placing to
 * the facts of the run. */
static void take_times(murk_plan *plan)
{
    murk_run_facts *run = &plan->session.run;
    run->trace_s = plan->plan.trace_s;
    run->map_s = plan->plan.map_s;
    run->sense_s = plan->plan.sense_s;
    run->place_s = plan->plan.place_s;
    run->reused_sightlines = plan->plan.reused;
}

static murk_status place_conditions(murk_plan *plan, murk_error *err)
{
    const unsigned threads = plan->world->context->threads;
    plan->conditions = calloc(1, sizeof *plan->conditions);
    if (!plan->conditions) {
        return MURK_NO_MEMORY;
    }
    const double begun_s = murk_clock_s();
    const murk_status status = murk_condition_plans_prepare(
        plan->conditions, &plan->plan, plan->session.scene, threads, err);
    plan->session.run.load_s += murk_clock_s() - begun_s;
    return status ? status
                  : murk_condition_plans_make(plan->conditions, &plan->plan,
                                              threads, err);
}

/* The way in which a plan is made. */
typedef struct making {
    murk_light *light; /* NULL: the light is traced by the call */
    bool is_step; /* of murk follow: a request to finish does not end the search
                   * with the best plan so far */
    bool keeps;   /* what it has computed, for the plan that follows */
    murk_plan *earlier;      /* keeps: the plan before; NULL: none */
    const murk_box *watched; /* is_step: murk_plan_make_step() */
} making;

/* Traces the light of a plan. For a step of a sequence that of the step before
 * is updated, or the paths of photons are noted for the next one. */
static murk_status trace(murk_plan *plan, const murk_box *watched,
                         murk_error *err)
{
    murk_session *session = &plan->session;
    const murk_stage *stage = session->stage;
    const unsigned threads = plan->world->context->threads;
    const murk_earlier_plan *earlier = plan->plan.earlier;
    if (!plan->plan.keeps_matrix) {
        return murk_lightmap_trace(&session->traced, stage, 0, threads, err);
    }
    watched = watched ? watched : &stage->world.domain.box;
    const murk_status status =
        earlier ? murk_lightmap_update(
                      &session->traced, &session->run.reused_photons, stage,
                      earlier->traced, earlier->stage, threads, err)
                : murk_lightmap_trace_watched(&session->traced, stage, watched,
                                              threads, err);
    if (!status && session->traced->cells) {
        session->run.has_watched = true;
        session->run.watched = session->traced->cells->box;
    }
    return status;
}

/* The same for the light of a plan that looks ahead, and of the later steps.
 * A step of a sequence takes over the light that the step before has. */
static murk_status trace_ahead(murk_plan *plan, const making *m,
                               murk_error *err)
{
    murk_session *session = &plan->session;
    const murk_world *world = plan->world;
    murk_ahead *a = &plan->ahead;
    *a = (murk_ahead){.n = 1 + world->laters,
                      .before =
                          m->is_step && m->earlier ? &m->earlier->ahead : NULL};
    a->stage[0] = session->stage;
    a->traced[0] = session->traced; /* that was given, or NULL */
    for (size_t i = 0; i < world->laters; ++i) {
        a->stage[i + 1] = world->later[i];
    }
    const murk_status status = murk_ahead_trace(
        a, plan->plan.keeps_matrix, m->watched, world->context->threads, err);
    plan->plan.ahead = a;
    session->traced = a->traced[0];
    if (status) {
        return status;
    }
    session->run.reused_photons = a->reused;
    const murk_traced *last = a->traced[a->n - 1];
    if (last->cells) {
        session->run.has_watched = true;
        session->run.watched = last->cells->box;
    }
    return MURK_OK;
}

/* Gives light that was taken over to its plan: to this one, or after a failure
 * to the one before. */
static void end_ahead(murk_plan *plan, const making *m, bool is_done)
{
    murk_plan *earlier = m->is_step ? m->earlier : NULL;
    murk_ahead_end(&plan->ahead, is_done);
    if (plan->plan.ahead && !plan->light) {
        plan->session.traced = plan->ahead.traced[0];
    }
    if (earlier && earlier->plan.ahead) {
        earlier->session.traced = earlier->ahead.traced[0];
    }
}

/* Places sensors for the given light, or, if `light` is NULL, for light that is
 * traced here. Errors in the settings of sensors are found before light is
 * traced. */
static murk_status place(murk_plan *plan, const making *m,
                         murk_earlier_plan *before, murk_error *err)
{
    murk_light *light = m->light;
    murk_session *session = &plan->session;
    const unsigned threads = plan->world->context->threads;
    const bool is_ahead = murk_world_is_ahead(plan->world) &&
                          !murk_stage_has_nothing_to_see(session->stage);
    murk_status status =
        murk_plan_prepare(&plan->plan, session->stage, threads, err);
    /* The light, and that of later steps. */
    if (!status && !light && !is_ahead) {
        status = trace(plan, m->watched, err);
    } else if (!status && light) {
        plan->light = light;
        ++light->references;
        session->traced = light->session.traced;
        session->settings.light = light->path;
        session->run.load_s = light->session.run.load_s;
    }
    if (!status && is_ahead) {
        status = trace_ahead(plan, m, err);
    }
    /* The rows of the step before; murk_ahead_choose() finds its own. */
    if (!status && is_ahead && plan->ahead.n == 1 && plan->plan.earlier &&
        !murk_ahead_earlier(before, &plan->ahead, 0, before)) {
        plan->plan.earlier = NULL;
    }
    return status ? status
                  : murk_plan_for_scene(&plan->plan, session->stage,
                                        session->traced, threads, err);
}

/* Makes a plan over the conditions of the world, or, if there are none to place
 * over, for one light. */
static murk_status plan_make(murk_plan **out, murk_world *world,
                             const making *m, murk_error *error)
{
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_plan *plan = make(world), *earlier = m->earlier;
    murk_earlier_plan before = {0};
    /* Each condition has a light of its own, so none can be given. */
    const bool has_conditions =
        world->desc->placement.over != MURK_SCENE_OBJECTIVE_NONE;
    murk_status status = MURK_NO_MEMORY;
    if (plan && earlier) {
        earlier->plan.held.stage = earlier->session.stage;
        before =
            (murk_earlier_plan){earlier->session.stage, earlier->session.traced,
                                earlier->plan.poses,    earlier->plan.tested,
                                &earlier->plan.matrix,  0,
                                &earlier->plan.held};
        plan->plan.earlier = &before;
    }
    if (plan && earlier && !m->is_step) { /* steps name a file */
        plan->plan.start_sensor = earlier->plan.sensor;
        plan->plan.start_sensors = earlier->plan.place.count;
    }
    if (plan && has_conditions && m->light) {
        status = murk_fail(&call.failure, MURK_BAD_VALUE,
                           world->desc->placement.where,
                           "over: each condition has a light of its own; must "
                           "be null to place for a given light");
    } else if (plan) {
        plan->plan.keeps_matrix = m->keeps;
        murk_finish_allow(!m->is_step);
        /* The building of the world counts, whenever it was. */
        status = murk_call_limit_search(world->desc->placement.time_limit_s,
                                        murk_clock_s() - world->load_s,
                                        &call.failure);
        if (!status) {
            status = has_conditions ? place_conditions(plan, &call.failure)
                                    : place(plan, m, &before, &call.failure);
        }
        murk_finish_allow(false);
        murk_finish_set_deadline(INFINITY);
        end_ahead(plan, m, !status);
        plan->plan.earlier = NULL;
        plan->plan.start_sensor = NULL;
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_plan_destroy(plan);
        return status;
    }
    take_times(plan);
    *out = plan;
    return MURK_OK;
}

murk_status murk_plan_make(murk_plan **out, murk_world *world,
                           murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    return out && world ? plan_make(out, world, &(making){0}, error)
                        : murk_call_refuse(error, "out or world is NULL");
}

murk_status murk_plan_make_step(murk_plan **out, murk_world *world,
                                murk_plan *earlier, const murk_box *watched,
                                murk_error *error)
{
    const making step = {
        .is_step = true, .keeps = true, .earlier = earlier, .watched = watched};
    *out = NULL;
    return plan_make(out, world, &step, error);
}

murk_status murk_plan_for_light(murk_plan **out, murk_light *light,
                                murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    return out && light
               ? plan_make(out, light->world, &(making){.light = light}, error)
               : murk_call_refuse(error, "out or light is NULL");
}

murk_status murk_plan_update(murk_plan **out, murk_plan *plan,
                             murk_light *light, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !plan || !light) {
        return murk_call_refuse(error, "out, plan or light is NULL");
    }
    if (plan->matrix || plan->conditions) {
        return murk_call_refuse(error, "a plan for a matrix or over conditions "
                                       "is not updated");
    }
    if (plan->world->context != light->world->context) {
        return murk_call_refuse(error,
                                "plan and light are of different contexts");
    }
    if (!murk_worlds_share_origin(plan->world, light->world)) {
        return murk_call_refuse(error, MURK_OTHER_ORIGIN);
    }
    /* A plan of the same scene. */
    if (!murk_world_has_poses(light->world, plan->plan.sensor,
                              plan->plan.place.count)) {
        return murk_call_refuse(error, MURK_OTHER_SENSORS);
    }
    const making update = {.light = light, .keeps = true, .earlier = plan};
    return plan_make(out, light->world, &update, error);
}

/* Begins a call in the context of the plan, with the files in memory of the
 * world, or of the scene if the plan is for a matrix. */
static murk_call begin(const murk_plan *plan, murk_error *error)
{
    const murk_world *world = plan->world;
    const murk_scene *scene = plan->scene;
    return world ? murk_call_begin(world->context, &world->files, error)
                 : murk_call_begin(scene->context, &scene->files, error);
}

void murk_plan_destroy(murk_plan *plan)
{
    if (!plan) {
        return;
    }
    if (plan->conditions) {
        murk_condition_plans_release(plan->conditions);
        free(plan->conditions);
    }
    murk_repeat_release(&plan->repeat);
    murk_ahead_release(&plan->ahead);
    murk_plan_result_release(&plan->plan);
    murk_fields_release(&plan->fields);
    murk_fields_release(&plan->saved);
    murk_matrix_plan_release(plan->matrix);
    murk_scene_release(plan->scene);
    if (!plan->light) {
        murk_traced_destroy(plan->session.traced);
    }
    murk_light_release(plan->light);
    murk_world_release(plan->world);
    free(plan);
}

/* ---- repeats ---- */

/* What a call does with the further runs of a plan: makes them, makes those of
 * a shard, or takes them from parts. */
typedef struct repeating {
    uint64_t runs;
    murk_shard shard;        /* count 0: not divided */
    const char *const *path; /* [n]: of the part of the shard, or of all parts
                              * that are put together */
    size_t n;
} repeating;

static murk_status make_runs(murk_plan *plan, const repeating *r,
                             murk_error *err)
{
    const murk_repeat_first first = {
        &plan->plan, plan->conditions ? NULL : plan->session.stage,
        plan->conditions};
    const size_t runs = (size_t)r->runs;
    const unsigned threads = plan->world->context->threads;
    if (r->shard.count > 0) { /* the plan stays as it is */
        return murk_repeat_part_make(&first, runs, r->shard, threads,
                                     r->path[0], err);
    }
    murk_fields_release(&plan->fields);
    murk_repeat_release(&plan->repeat);
    return murk_repeat_merge(&plan->repeat, &first, runs, r->path, r->n,
                             threads, err);
}

static murk_status repeat(murk_plan *plan, const repeating *r, murk_error *err)
{
    murk_session session = plan->session;
    murk_status status = murk_save_check(&session, "place", r->runs, err);
    murk_results_end(&session.results);
    if (!status && r->shard.count > 0) {
        status = murk_shard_check(r->shard, err);
    }
    if (status) {
        return status;
    }
    if (plan->plan.is_dark) {
        murk_note("runs",
                  "it is dark, so nothing hangs on chance: once is enough");
    }
    return make_runs(plan, r, err);
}

/* Does what was asked for in a call. */
static murk_status repeat_in_call(murk_plan *plan, const repeating *r,
                                  murk_error *error)
{
    bool has_paths = true;
    for (size_t i = 0; has_paths && i < r->n; ++i) {
        has_paths = r->path && r->path[i];
    }
    if (!plan || r->runs == 0 || !has_paths) {
        return murk_call_refuse(error, "plan or a path is NULL, or runs is 0");
    }
    if (plan->matrix) {
        return murk_call_refuse(error, "the plan is for a matrix, which is one "
                                       "sample: other seeds have no other");
    }
    murk_call call = begin(plan, error);
    return murk_call_end_long(&call, repeat(plan, r, &call.failure));
}

murk_status murk_plan_repeat(murk_plan *plan, uint64_t runs, murk_error *error)
{
    return repeat_in_call(plan, &(repeating){.runs = runs}, error);
}

murk_status murk_plan_repeat_part(murk_plan *plan, uint64_t runs,
                                  uint32_t number, uint32_t count,
                                  const char *path, murk_error *error)
{
    const repeating r = {runs, {number, count}, &path, 1};
    return count > 0 ? repeat_in_call(plan, &r, error)
                     : murk_call_refuse(error, "count is 0, must be 1 or more");
}

murk_status murk_plan_repeat_merge(murk_plan *plan, uint64_t runs,
                                   const char *const *path, size_t n,
                                   murk_error *error)
{
    const repeating r = {.runs = runs, .path = path, .n = n};
    return n > 0 ? repeat_in_call(plan, &r, error)
                 : murk_call_refuse(error, "n is 0: there are no parts");
}

/* ---- results ---- */

/* Sets *out to the results of a plan in the form of results/plan.h, with the
 * given session. If the plan was repeated, fills *repeated, which must then
 * outlive *out. */
static murk_status results_of(murk_plan_results *out,
                              murk_repeat_results *repeated,
                              const murk_plan *plan,
                              const murk_session *session, murk_error *err)
{
    *out = (murk_plan_results){session, &plan->plan, plan->conditions, NULL};
    if (plan->repeat.runs == 0) {
        return MURK_OK;
    }
    out->repeat = repeated;
    *repeated = (murk_repeat_results){.repeat = &plan->repeat};
    return murk_repeat_sum_up(&repeated->summary, &plan->repeat, err);
}

murk_status murk_plan_fields(murk_plan *plan, const murk_fields **fields,
                             murk_error *error)
{
    if (!plan || !fields) {
        return murk_call_refuse(error, "plan or fields is NULL");
    }
    murk_plan_results results;
    murk_repeat_results repeated;
    murk_call call = begin(plan, error);
    murk_status status =
        plan->matrix
            ? murk_fields_make(&plan->fields, murk_results_list_matrix_plan,
                               plan->matrix, &call.failure)
            : results_of(&results, &repeated, plan, &plan->session,
                         &call.failure);
    if (!status && !plan->matrix) {
        status = murk_fields_make(&plan->fields, murk_results_list_plan,
                                  &results, &call.failure);
    }
    *fields = status ? NULL : &plan->fields;
    return murk_call_end(&call, status);
}

static murk_status save(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    murk_plan *plan = of;
    murk_plan_results results;
    murk_repeat_results repeated;
    /* Judge the folder and the options. */
    murk_status status = results_of(&results, &repeated, plan, session, err);
    if (!status) {
        status = murk_save_check(session, "place", plan->repeat.runs, err);
    }
    if (!status) {
        status = murk_save_identify(session, "place", options, "", err);
    }
    if (!status) {
        /* Add the files; plan.json comes last. */
        status = murk_add_plan_files(session, &plan->plan, plan->conditions,
                                     late, err);
    }
    if (!status && results.repeat) {
        status = murk_results_add_csv(&session->results, "repeat.csv",
                                      murk_results_list_run, &plan->repeat,
                                      plan->repeat.runs, err);
    }
    return status ? status
                  : murk_session_finish(
                        session, "plan.json",
                        murk_results_json(murk_results_list_plan, &results),
                        murk_print_plan, &results, err);
}

murk_status murk_plan_save(murk_plan *plan, const char *folder,
                           const murk_save_options *options,
                           const murk_fields **fields, murk_error *error)
{
    if (!plan) {
        return murk_save_refuse(fields, error, "plan is NULL");
    }
    murk_call call = begin(plan, error);
    return plan->matrix
               ? murk_save_results(&call, &plan->matrix->session, &plan->saved,
                                   folder, options, fields,
                                   murk_matrix_plan_save, plan->matrix)
               : murk_save_results(&call, &plan->session, &plan->saved, folder,
                                   options, fields, save, plan);
}
