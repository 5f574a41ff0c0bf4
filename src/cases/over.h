/* A plan over conditions: for their mean coverage, for the worst of them, or
 * for the least largest regret; and what it costs to plan for one condition and
 * meet another (regret).
 *
 * Each condition's coverage is measured in its own light; dark ones are left
 * out. Its held-out map is
 * independent of all other maps, those of other conditions too; the maps that
 * choose share their random numbers, which leaves differences between
 * conditions less noise. */
#ifndef MURK_CASES_OVER_H
#define MURK_CASES_OVER_H

#include "cases/conditions.h"
#include "plan/plan.h"

/* One plan, used in each condition. */
typedef struct murk_over_plan {
    murk_scene_name made_for; /* a condition, mean, worst,
                                regret */
    size_t count;
    murk_pose *sensor; /* [count] */
    murk_estimate in_sample[MURK_SCENE_CONDITIONS_MAX];
    murk_estimate held_out[MURK_SCENE_CONDITIONS_MAX];
} murk_over_plan;

#define MURK_OVER_PLANS_MAX (MURK_SCENE_CONDITIONS_MAX + 3)

typedef struct murk_over {
    murk_conditions *conditions;
    murk_over_plan plan[MURK_OVER_PLANS_MAX]; /* each condition's own, in their
                                                 order; mean; worst (known
                                                 environment); regret, where it
                                                 is asked for */
    size_t plans;                             /* 0: it is dark in all of them */
    size_t chosen;                            /* the one that was asked for */
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
} murk_over;

/* What a plan is worth over conditions: the mean by weight, or the least of
 * those that have a say, or what it covers where its regret to best_known is
 * largest; *worst is which (of the mean, the least). Errors: of the least, its
 * own; of the mean, as of independent maps, or if not so, their mean, which is
 * more than it is. */
murk_estimate murk_over_estimate(const murk_conditions *conditions,
                                 const murk_estimate *of, murk_scene_over over,
                                 bool are_independent, size_t *worst);

/* How far from the best plan known for condition c the coverage `of` is there:
 * held out where it is. */
double murk_over_regret(const murk_over *over, const murk_over_plan *plan,
                        size_t c);

/* All that can be wrong is found here, before light is traced: fills out's
 * conditions, and the plan's candidates and poses. */
murk_status murk_over_prepare(murk_over *out, murk_plan_result *plan,
                              const murk_scene_desc *scene, unsigned threads,
                              murk_error *err);

/* The main job. Of the plan, in_sample, held_out and confirmed are the mean's,
 * or of the condition that is covered least; in_sample's total is the value of
 * the problem of all scenarios (cases/scenarios.h), which the bound is of, its
 * error as measured. Release both also after a failure. */
murk_status murk_over_make(murk_over *over, murk_plan_result *plan,
                           unsigned threads, murk_error *err);
void murk_over_release(murk_over *over);

#endif
