/* A plan over conditions: for their mean coverage, for the worst of them, or
 * for the least largest regret; and what it costs to plan for one condition and
 * meet another (regret).
 *
 * Each condition's coverage is measured in its own light; dark ones are left
 * out. Its held-out map is
 * independent of all other maps, those of other conditions too; the maps that
 * choose share their random numbers, which leaves differences between
 * conditions less noise. */
#ifndef MURK_CASES_CONDITION_PLANS_H
#define MURK_CASES_CONDITION_PLANS_H

#include "cases/conditions.h"
#include "plan/plan.h"

/* One plan, used in each condition. */
typedef struct murk_condition_plan {
    murk_scene_name made_for; /* a condition, mean, worst,
                                regret */
    size_t count;
    murk_pose *sensor; /* [count] */
    murk_estimate in_sample[MURK_SCENE_CONDITIONS_MAX];
    murk_estimate held_out[MURK_SCENE_CONDITIONS_MAX];
} murk_condition_plan;

#define MURK_CONDITION_PLANS_MAX (MURK_SCENE_CONDITIONS_MAX + 3)

typedef struct murk_condition_plans {
    murk_conditions *conditions;
    murk_condition_plan plan[MURK_CONDITION_PLANS_MAX]; /* each condition's own,
                                                 in their order; mean; worst
                                                 (known environment); regret,
                                                 where it is asked for */
    size_t plans;  /* 0: it is dark in all of them */
    size_t chosen; /* the one that was asked for */
    bool has_held_out;
    murk_coverage_result coverage[MURK_SCENE_CONDITIONS_MAX]; /* of the chosen
                                                          one, in sample */
    murk_estimate *shaken; /* [conditions * draws] the chosen one's, by
                              condition, where jitter is asked for */
    size_t unmoved;        /* of each condition's draws */
    /* With over: regret, of the sample that chose. The largest regret of the
     * plan to the best plans known; the least that any plan has, to these and
     * so to the true optima, which are not less; and the largest that this
     * plan can have to the true optima. */
    double regret, regret_lower, regret_upper;
    uint64_t ceiling_of[MURK_SCENE_CONDITIONS_MAX]; /* coverage by all
                              candidates, over MURK_SHARE_ONE, likewise */
} murk_condition_plans;

/* How far from the best plan known for condition c the coverage `of` is there:
 * held out where it is. */
double murk_condition_plans_regret(const murk_condition_plans *plans,
                                   const murk_condition_plan *plan, size_t c);

/* Also after a failure. */
void murk_condition_plans_release(murk_condition_plans *plans);

#endif
