/* Reads the keys of a scene that have a meaning for a coverage matrix, by the
 * key table of scenes (scene/keys.h), and completes the goal by the matrix. */
#include "api/matrix_settings.h"

#include "api/scene.h"
#include "base/machine.h"
#include "plan/plan.h"
#include "plan/poses.h"
#include "scene/yaml.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COST_MAX 1e6 /* as of a scene: scene/keys_sensors.c */

/* The keys of a scene that have a meaning for a matrix. */
static const char *const KEYS[] = {
    "seed",
    "sensors.count",
    "sensors.target",
    "sensors.budget",
    "placement.method",
    "placement.detection",
    "placement.redundancy",
    "placement.restarts",
    "placement.nodes",
    "placement.time_limit_s",
    "placement.memory_mb",
};
#define N_KEYS (sizeof KEYS / sizeof *KEYS)

/* Fails unless the key of an override is one of KEYS. */
static murk_status check_key(const murk_override *override, murk_error *err)
{
    const size_t length = strcspn(override->text, "=");
    char list[256] = "", name[96];
    for (size_t i = 0, n = 0; i < N_KEYS; ++i) {
        if (strlen(KEYS[i]) == length &&
            strncmp(KEYS[i], override->text, length) == 0) {
            return MURK_OK;
        }
        n += (size_t)snprintf(list + n, sizeof list - n, "%s%s", i ? ", " : "",
                              KEYS[i]);
    }
    snprintf(name, sizeof name, MURK_SET_MARK "%.*s", (int)length,
             override->text);
    return murk_fail(err, MURK_BAD_VALUE, name,
                     "a matrix has no such key; there are %s", list);
}

/* Reads the keys that the caller has set; the last value of a key counts. Fails
 * if a key is not one of KEYS, if a value is wrong, or if the mode of detection
 * is one that a matrix does not take (base/detection.h). */
static murk_status read_keys(murk_scene_desc *asked, const murk_scene *scene,
                             murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < scene->n && !status; ++i) {
        status = check_key(&scene->set[i], err);
        if (!status) {
            status = murk_scene_override_read(asked, &scene->set[i], err);
        }
    }
    if (!status &&
        !murk_detection_is(asked->placement.detection, MURK_DETECTION_SMOOTH)) {
        status = murk_fail(
            err, MURK_BAD_VALUE, "placement.detection",
            "%s, must be %s for a matrix",
            murk_detection_name(asked->placement.detection),
            murk_detection_list(MURK_DETECTION_SMOOTH, true, ", ").text);
    }
    return status;
}

murk_status murk_matrix_settings(murk_matrix_plan *p, const murk_scene *scene,
                                 murk_error *err)
{
    p->desc = murk_place_defaults();
    murk_place_desc *desc = &p->desc;
    murk_scene_desc asked = {
        .seed = desc->seed,
        .placement = {.method = desc->method,
                      .redundancy = 1,
                      .restarts = desc->restarts,
                      .nodes = desc->nodes,
                      .memory_mb =
                          (double)desc->row_memory / MURK_BYTES_PER_MB}};
    if (strcmp(scene->text, MURK_EMPTY_SCENE) != 0) {
        return murk_fail(err, MURK_BAD_VALUE, scene->name,
                         "has a text, must be a scene of murk_scene_create(): "
                         "a matrix stands in place of all but a few keys");
    }
    const murk_status status = read_keys(&asked, scene, err);
    if (status) {
        return status;
    }
    /* The settings of the search. */
    desc->seed = asked.seed;
    desc->count = (size_t)asked.sensors.count;
    desc->method = asked.placement.method;
    desc->restarts = (size_t)asked.placement.restarts;
    desc->nodes = asked.placement.nodes;
    desc->row_memory =
        (uint64_t)(asked.placement.memory_mb * MURK_BYTES_PER_MB);
    p->time_limit_s = asked.placement.time_limit_s;
    p->detection = asked.placement.detection;
    p->redundancy = (unsigned)asked.placement.redundancy;
    p->target = asked.sensors.target;
    p->budget = asked.sensors.budget;
    /* One goal, and only one. */
    const int goals = (p->desc.count > 0) + (p->target > 0) + (p->budget > 0);
    return goals == 1
               ? MURK_OK
               : murk_fail(
                     err, MURK_BAD_VALUE, "sensors",
                     "needs one of count, target and budget for a matrix, %d "
                     "are given",
                     goals);
}

/* Makes the constraint of the budget: the cost of each column is that of the
 * file, or 1 if the file has no costs. */
static murk_status price(murk_matrix_plan *p, murk_error *err)
{
    const murk_sparse_matrix *m = p->matrix;
    p->cost = calloc(m->columns + 1, sizeof *p->cost);
    if (!p->cost) {
        return murk_no_memory(err, p->file, "for the costs");
    }
    for (size_t j = 0; j < m->columns; ++j) {
        const double cost = m->cost ? m->cost[j] : 1;
        if (!(cost >= 0 && cost <= COST_MAX)) {
            return murk_fail(err, MURK_BAD_VALUE, p->file,
                             "column %zu costs %g, must be 0..1e6", j + 1,
                             cost);
        }
        p->cost[j] = llround(cost / MURK_COST_UNIT);
    }
    p->constraints = (murk_constraints){
        .cost = p->cost, .budget = llround(p->budget / MURK_COST_UNIT)};
    p->desc.constraints = &p->constraints;
    return MURK_OK;
}

murk_status murk_matrix_goal(murk_matrix_plan *p, const murk_problem *problem,
                             murk_error *err)
{
    if (p->target > 0) {
        p->desc.target = murk_plan_value_of(p->target, problem);
        p->desc.count = problem->candidates;
    } else if (p->budget > 0) {
        return price(p, err);
    } else if (p->desc.count > problem->candidates) {
        return murk_fail(err, MURK_BAD_VALUE, MURK_SET_MARK "sensors.count",
                         "%zu, but %s has %zu columns", p->desc.count, p->file,
                         problem->candidates);
    }
    return MURK_OK;
}
