/* Defaults and check of a placement's settings, and the release of a result.
 * The check covers all that does not depend on the constraints in detail
 * (placement/constraints.h checks these). */
#include "placement/settings.h"

#include <stdlib.h>

/* Weights add up to less than 2^47 (placement/problem.h). */
#define WEIGHT_MAX ((UINT64_C(1) << 47) - 1)

murk_place_desc murk_place_defaults(void)
{
    return (murk_place_desc){.method = MURK_PLACE_BEST,
                             .count = 1,
                             .restarts = 200,
                             .nodes = 1000000,
                             .row_memory = MURK_ROW_MEMORY,
                             .seed = 1,
                             .with_curve = true};
}

static murk_status check_redundancy(const murk_problem *problem,
                                    murk_error *err)
{
    const size_t layers = murk_problem_layers(problem);
    /* Redundancy, and the sum of the weights. */
    if (layers > MURK_REDUNDANCY_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "redundancy is %zu, must be 1..%d", layers,
                         MURK_REDUNDANCY_MAX);
    }
    if (problem->combining == MURK_COMBINE_INDEPENDENT && layers > 1) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "redundancy is %zu, must be 1 where views are "
                         "independent chances: all of them count",
                         layers);
    }
    uint64_t weight = 0;
    for (size_t i = 0; i < problem->photons; ++i) {
        weight += problem->weight[i];
    }
    if (weight > WEIGHT_MAX / layers) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "weights add up to %llu, must be %llu at most with "
                         "redundancy %zu",
                         (unsigned long long)weight,
                         (unsigned long long)(WEIGHT_MAX / layers), layers);
    }
    return MURK_OK;
}

/* A rule on moves is kept by searches that begin at the start plan and know
 * what every candidate sees. */
static murk_status check_moves(bool known, const murk_place_desc *desc,
                               murk_error *err)
{
    const murk_constraints *rules = desc->constraints;
    if (!rules || !rules->start) {
        return MURK_OK;
    }
    const char *cause = !known              ? "knowledge: known"
                        : !desc->start_plan ? "a start plan"
                        : rules->budget > 0 ? "no budget"
                        : desc->method == MURK_PLACE_GREEDY
                            ? "method best, spoq or exact"
                        : desc->target && rules->move_cost > 0
                            ? "a move cost of 0 with a target"
                            : NULL;
    if (cause) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "a rule on moves is given, which needs %s", cause);
    }
    return rules->move_cost >= 0 && rules->move_cost <= 1
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "",
                           "cost of a move is %g, must be 0..1",
                           rules->move_cost);
}

murk_status murk_place_check(const murk_problem *problem, bool known,
                             const murk_place_desc *desc, murk_error *err)
{
    const bool has_budget = desc->constraints && desc->constraints->budget > 0;
    /* Count, target and budget. */
    if (has_budget && desc->target) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "a target and a budget are given, must be one");
    }
    if (desc->count < 1 && !has_budget) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "0 sensors asked for, must be 1 or more");
    }
    if (desc->count > problem->candidates) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but only %zu usable "
                         "candidates",
                         desc->count, problem->candidates);
    }
    /* Method and starts. */
    if (desc->method == MURK_PLACE_EXACT && !known) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "method exact needs what every candidate sees: "
                         "knowledge must be known");
    }
    if (desc->restarts < 1) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "restarts is 0, must be 1 or more");
    }
    const murk_status status = check_moves(known, desc, err);
    return status ? status : check_redundancy(problem, err);
}

void murk_place_release(murk_place_result *result)
{
    free(result->sensor);
    free(result->curve);
    *result = (murk_place_result){0};
}
