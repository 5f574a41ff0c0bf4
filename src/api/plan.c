/* Plans: the sensors that placement chooses for a light, or over the conditions
 * of a scene. */
#include "api/light.h"

#include "results/plan_files.h"

#include <stdlib.h>

/* Without a choice yet. NULL when out of memory. */
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

/* Takes the times of the choice into the record of the run. */
static void take_times(murk_plan *plan)
{
    murk_run_facts *run = &plan->session.run;
    run->trace_s = plan->plan.trace_s;
    run->map_s = plan->plan.map_s;
    run->sense_s = plan->plan.sense_s;
    run->place_s = plan->plan.place_s;
}

static murk_status place_conditions(murk_plan *plan, murk_error *err)
{
    const unsigned threads = plan->world->context->threads;
    plan->conditions = calloc(1, sizeof *plan->conditions);
    if (!plan->conditions) {
        return MURK_NO_MEMORY;
    }
    const murk_status status = murk_condition_plans_prepare(
        plan->conditions, &plan->plan, plan->session.scene, threads, err);
    return status ? status
                  : murk_condition_plans_make(plan->conditions, &plan->plan,
                                              threads, err);
}

/* Errors of the settings of sensors are found before light is traced. */
static murk_status place(murk_plan *plan, murk_light *light, murk_error *err)
{
    murk_session *session = &plan->session;
    const unsigned threads = plan->world->context->threads;
    murk_status status =
        murk_plan_prepare(&plan->plan, session->stage, threads, err);
    if (!status && !light) {
        status = murk_lightmap_trace(&session->traced, session->stage, 0,
                                     threads, err);
    } else if (!status) {
        plan->light = light;
        ++light->references;
        session->traced = light->session.traced;
    }
    return status ? status
                  : murk_plan_for_scene(&plan->plan, session->stage,
                                        session->traced, threads, err);
}

/* light NULL: traced here. */
static murk_status plan_make(murk_plan **out, murk_world *world,
                             murk_light *light, murk_error *error)
{
    *out = NULL;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_plan *plan = make(world);
    /* Each condition has a light of its own, so none can be given. */
    const bool has_conditions =
        world->desc->placement.over != MURK_SCENE_OBJECTIVE_NONE;
    murk_status status = MURK_NO_MEMORY;
    if (plan && has_conditions && light) {
        status = murk_fail(&call.failure, MURK_BAD_VALUE,
                           world->desc->placement.where,
                           "over: each condition has a light of its own; must "
                           "be null to place for a given light");
    } else if (plan) {
        status = has_conditions ? place_conditions(plan, &call.failure)
                                : place(plan, light, &call.failure);
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
    return out && world ? plan_make(out, world, NULL, error)
                        : murk_call_refuse(error, "out or world is NULL");
}

murk_status murk_plan_for_light(murk_plan **out, murk_light *light,
                                murk_error *error)
{
    return out && light ? plan_make(out, light->world, light, error)
                        : murk_call_refuse(error, "out or light is NULL");
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
    murk_plan_result_release(&plan->plan);
    murk_fields_release(&plan->fields);
    if (!plan->light) {
        murk_traced_destroy(plan->session.traced);
    }
    murk_light_release(plan->light);
    murk_world_release(plan->world);
    free(plan);
}

murk_status murk_plan_fields(murk_plan *plan, const murk_fields **fields,
                             murk_error *error)
{
    if (!plan || !fields) {
        return murk_call_refuse(error, "plan or fields is NULL");
    }
    const murk_plan_results results = {&plan->session, &plan->plan,
                                       plan->conditions, NULL};
    murk_call call = murk_call_begin(plan->world->context, NULL, error);
    *fields = &plan->fields;
    return murk_call_end(&call,
                         murk_fields_make(&plan->fields, murk_results_list_plan,
                                          &results, &call.failure));
}

static murk_status save(murk_plan *plan, murk_session *session,
                        const char *folder, murk_error *err)
{
    murk_error late = {0};
    const murk_plan_results results = {session, &plan->plan, plan->conditions,
                                       NULL};
    murk_status status = murk_session_save_begin(session, "place", folder, err);
    if (!status) {
        status = murk_add_plan_files(session, &plan->plan, plan->conditions,
                                     &late, err);
    }
    if (!status) {
        status = murk_session_finish(
            session, "plan.json",
            murk_results_json(murk_results_list_plan, &results),
            murk_print_plan, &results, err);
    }
    /* The plan is written; an export that could not be had is an error. */
    return status ? status
                  : murk_fail(err, late.code, late.where, "%s", late.text);
}

murk_status murk_plan_save(murk_plan *plan, const char *folder,
                           murk_error *error)
{
    if (!plan || !folder) {
        return murk_call_refuse(error, "plan or folder is NULL");
    }
    murk_world *world = plan->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_session session = plan->session; /* borrows the plan */
    const murk_status status = save(plan, &session, folder, &call.failure);
    murk_results_end(&session.results);
    return murk_call_end_long(&call, status);
}
