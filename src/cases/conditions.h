/* The conditions of a scene as worlds: each has a stage, light and a sight. The
 * candidates of a plan are those that are usable in every condition. A scene as
 * it stands is a set of one condition.
 *
 * Light is traced once for each condition; conditions with equal light keys
 * (murk_stage.light_key) share one light. A condition of weight 0 is lit and
 * measured, and has a plan of its own for comparison, but no part in the plan
 * over the conditions. In a dark condition there is nothing to see: plans are
 * chosen for the other conditions, and the coverage of the dark one is null
 * (plan/dark.c). If every condition that has a weight is dark, all conditions
 * count as dark. */
#ifndef MURK_CASES_CONDITIONS_H
#define MURK_CASES_CONDITIONS_H

#include "lightmap/lightmap.h"
#include "plan/poses.h"
#include "plan/sites.h"
#include "plan/targets.h"

typedef struct murk_condition {
    const murk_scene_condition *settings; /* name, weight and scene */
    murk_stage *stage;
    murk_scene_desc *borrowed; /* owned copy of the scene, if the parts of the
                                * stage belong to another stage; else NULL */
    murk_traced *traced;       /* the light by which plans are chosen */
    bool borrows_light;        /* traced belongs to an earlier condition or to
                                  the caller */
    murk_sight *sight;         /* sight onto the records of `traced`, or onto
                                * targets; NULL before lighting and in a dark
                                * condition */
    murk_target_facts targets; /* points 0: photons are seen, no targets */
    murk_pose *pose;           /* [candidates] as they are in the condition, of
                                * murk_conditions_take_poses(); NULL: as in the plan */
    /* With the objective regret, once plans are chosen, for a condition of
     * weight above 0: the coverage of the best plan known for this condition
     * alone, and the upper bound of the coverage of any plan in this condition,
     * both as shares. */
    double best_known, best_upper;
} murk_condition;

typedef struct murk_conditions {
    const murk_scene_desc *scene; /* borrowed */
    murk_scene_desc *again;       /* owned copy that `scene` points to, of
                                   * murk_conditions_again(); else NULL */
    bool is_scene;                /* one condition: the scene as it stands */
    size_t n;    /* number of conditions in which there is something to see; 0
                  * if none of them has a weight above 0 */
    size_t dark; /* number of the other conditions, which follow the first n
                  * and have no sight */
    /* [n + dark]; first the n conditions in which there is something to see,
     * then the dark ones, each in the order of the scene. If n is 0, those that
     * are dark by themselves come last. */
    murk_condition condition[MURK_SCENE_CONDITIONS_MAX];
    /* With the objective regret, once the plan is measured in sample: the
     * number of the condition in which the regret of the plan is largest. */
    bool has_regret_at;
    size_t regret_at;
    double trace_s, map_s; /* seconds of all traces, and of building maps */
} murk_conditions;

/* Imports the files of all conditions and then builds their worlds. Fails as
 * murk_stage_import() and murk_stage_build() (world/stage_build.h), or with
 * MURK_NO_MEMORY. *out is the caller's: murk_conditions_destroy(). The scene
 * must outlive *out. */
murk_status murk_conditions_create(murk_conditions **out,
                                   const murk_scene_desc *scene,
                                   murk_error *err);
void murk_conditions_destroy(murk_conditions *conditions); /* NULL is fine */

/* The scene as it stands as the only condition. *out borrows the stage, and the
 * light `traced` unless that is NULL. Fails with MURK_NO_MEMORY. */
murk_status murk_conditions_of_stage(murk_conditions **out,
                                     const murk_stage *stage,
                                     murk_traced *traced, murk_error *err);

/* The same worlds without light. If `later` is above 0, the worlds are for
 * another run of the same job: all seeds are greater by `later`, and there is
 * no jitter. *out borrows the worlds of `from`: destroy *out first. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_conditions_again(murk_conditions **out,
                                  const murk_conditions *from, uint32_t later,
                                  murk_error *err);

/* Traces the light of every condition that has none, and builds the sight of
 * the first n: fills traced, sight and targets. If targets replace photons and
 * detection is not by power, the light of the scene as it stands (is_scene) is
 * left empty. Fails as tracing and building a sight do. Unless is_scene, fails
 * with MURK_BAD_VALUE before any light is traced in full if by forecast the
 * maps of the first n conditions, equal light counted once, and the further
 * memory of one trace exceed the free memory. Fails at the end as
 * murk_goals_check_seen(). */
murk_status murk_conditions_light(murk_conditions *conditions, unsigned threads,
                                  murk_error *err);

/* Finds the candidates of a plan as they are in each of the first n conditions
 * (cases/poses_at.h). Fails with MURK_NO_MEMORY. */
murk_status murk_conditions_take_poses(murk_conditions *conditions,
                                       const murk_poses *poses,
                                       murk_error *err);

/* The sensors of a plan, by their numbers among the candidates, as they are in
 * a condition. A fixed sensor that is absent there is of MURK_POSE_OF_NONE.
 * NULL when out of memory; else the caller's (free()). */
murk_pose *murk_condition_sensors(const murk_condition *condition,
                                  const murk_poses *poses,
                                  const size_t *candidate, size_t n);

/* Regret of a coverage in one condition: the difference to the best coverage
 * that is known for this condition, or with placement.regret: relative this
 * difference as a share of the best coverage (0 if that is 0). */
double murk_condition_regret(const murk_scene_desc *scene,
                             const murk_condition *condition, double coverage);

/* One figure from the coverages of[n] of a plan, by the objective: the mean by
 * weight; the smallest coverage of the conditions that have weight; or the
 * coverage of the condition in which the regret of the plan is largest. n must
 * be above 0. *worst is the number of that condition (for the mean: of the
 * condition with the smallest coverage). Once conditions->has_regret_at is
 * true, the condition of the largest regret is regret_at. The standard error of
 * the result is that of the single condition. For the mean it is the error of
 * independent estimates if are_independent is set, or else the mean of the
 * errors, which is an upper bound if the maps of the conditions share random
 * numbers. */
murk_estimate murk_conditions_estimate(const murk_conditions *conditions,
                                       const murk_estimate *of,
                                       murk_scene_objective objective,
                                       bool are_independent, size_t *worst);

#endif
