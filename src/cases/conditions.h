/* The scene's conditions as worlds: each with its own stage, light and sight,
 * and one list of places where sensors may stand in all of them.
 *
 * A condition is lit once; those that the light does not tell apart share it.
 * One of weight 0 is lit and measured, and has no say. One in which it is dark
 * (plan/dark.h) has nothing to see, so it is neither: plans are made for the
 * others, and its coverage is null. */
#ifndef MURK_CASES_CONDITIONS_H
#define MURK_CASES_CONDITIONS_H

#include "lightmap/lightmap.h"
#include "plan/poses.h"
#include "plan/sites.h"
#include "plan/targets.h"

typedef struct murk_condition {
    const murk_scene_condition *settings;
    murk_stage *stage;
    murk_scene_desc
        *borrowed;       /* of a stage whose parts are another's; else NULL */
    murk_traced *traced; /* the light that chooses */
    bool borrows_light;  /* an earlier condition's */
    murk_sight *sight;
    murk_target_facts targets; /* points 0: photons are seen */
    /* With over: regret, once plans are chosen: the coverage of the best plan
     * known for this condition alone, and what no plan exceeds there. */
    double best_known, best_upper;
} murk_condition;

typedef struct murk_conditions {
    const murk_scene_desc *scene; /* borrowed */
    murk_scene_desc *again; /* it, of murk_conditions_again(); else NULL */
    size_t n;               /* that there is something to see in */
    size_t dark; /* that follow them, and have no sight; where no condition that
                    has a say is lit, all do */
    murk_condition condition[MURK_SCENE_CONDITIONS_MAX]; /* [n + dark], else in
                                                            the scene's order */
    bool has_regret_at; /* over: regret, once the plan is measured in sample: */
    size_t regret_at;   /* where its regret is largest; results speak of it */
    double trace_s, map_s;
} murk_conditions;

/* Imports the files of all conditions, then builds them. *out is the caller's:
 * murk_conditions_destroy(). The scene must outlive it. */
murk_status murk_conditions_create(murk_conditions **out,
                                   const murk_scene_desc *scene,
                                   murk_error *err);
void murk_conditions_destroy(murk_conditions *conditions); /* NULL is fine */

/* The same worlds under seeds that are `later` by so much, for another job, and
 * without jitter; nothing is lit yet. Borrows what `from` is built of: destroy
 * it first. Fails with MURK_NO_MEMORY. */
murk_status murk_conditions_again(murk_conditions **out,
                                  const murk_conditions *from, uint32_t later,
                                  murk_error *err);

/* The candidates that are usable in every condition, by their places. Counts
 * of why others are not are those of the first; those that only a later one
 * drops count as unreached. */
murk_status murk_conditions_sites(murk_candidates **out,
                                  const murk_conditions *conditions,
                                  unsigned threads, murk_error *err);

/* Lights every condition and looks: fills traced and, of the first n, sight.
 * Refused before any is traced, by forecast, when they do not fit in memory
 * together. */
murk_status murk_conditions_light(murk_conditions *conditions, unsigned threads,
                                  murk_error *err);

/* weight[n]: the weight of each condition in the mean. */
void murk_conditions_weights(const murk_conditions *conditions, double *weight);

/* Regret of a coverage in one condition: the difference to the best coverage
 * that is known there, or with placement.regret: relative this difference as a
 * share of the best coverage. */
double murk_condition_regret(const murk_scene_desc *scene,
                             const murk_condition *condition, double coverage);

/* One figure from the coverages of[n] of a plan, by the objective: the mean by
 * weight; the least of the conditions that have weight; or the coverage of the
 * condition in which the regret of the plan is largest. *worst is the number of
 * that condition (for the mean: of the least). The error of a single condition
 * is its own; the error of the mean holds for independent maps, or, if they are
 * not independent, is the mean of the errors, which is an upper bound. */
murk_estimate murk_conditions_estimate(const murk_conditions *conditions,
                                       const murk_estimate *of,
                                       murk_scene_over objective,
                                       bool are_independent, size_t *worst);

#endif
