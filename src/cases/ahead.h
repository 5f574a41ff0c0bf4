/* A plan that looks ahead (placement.look_ahead): it is chosen for the mean
 * coverage of its own time and of the next steps of the timeline, each of which
 * has its own world and light. The candidates are those of its own time, and
 * its coverage is measured there alone. In a sequence of such plans, light and
 * rows of a step are computed once and taken over by the plans that follow. */
#ifndef MURK_CASES_AHEAD_H
#define MURK_CASES_AHEAD_H

#include "plan/plan.h"

typedef struct murk_ahead {
    size_t n; /* steps; 0: the plan does not look ahead */
    /* [n] borrowed; the first is that of the plan, the others are later. */
    const murk_stage *stage[MURK_SCENE_CONDITIONS_MAX];
    /* [n] the light of each step. That of the first belongs to the plan; the
     * others are owned. */
    murk_traced *traced[MURK_SCENE_CONDITIONS_MAX];
    /* [n] the first photon of the step in the matrix of the plan; SIZE_MAX: the
     * matrix does not have the step */
    size_t first[MURK_SCENE_CONDITIONS_MAX];
    size_t block[MURK_SCENE_CONDITIONS_MAX]; /* [n] number of the step there */
    /* [n] the candidates of the plan as they are at each step
     * (murk_ahead_choose()); pose[i] is the array of step i, NULL: that of the
     * plan. */
    murk_poses poses[MURK_SCENE_CONDITIONS_MAX];
    murk_pose *pose[MURK_SCENE_CONDITIONS_MAX];
    /* What the plan before leaves; NULL: there is none. */
    struct murk_ahead *before;
    /* [n] the step of `before` whose light and rows the step has; before->n:
     * or more: none */
    size_t same[MURK_SCENE_CONDITIONS_MAX];
    size_t seen; /* steps that the plan was chosen for: those with something to
                  * see */
    uint64_t photons, reused; /* traced in all steps; of these for plans before
                               */
} murk_ahead;

/* Traces the light of all steps that have none. A step with the light key of a
 * step of ahead->before has the light of that step; with `notes_paths` other
 * light is updated from that of the step before it, or else traced with the
 * cells of `watched` for the last step, NULL: of the domain. Fails as
 * murk_lightmap_trace(). murk_ahead_end() must follow, also after a failure. */
murk_status murk_ahead_trace(murk_ahead *ahead, bool notes_paths,
                             const murk_box *watched, unsigned threads,
                             murk_error *err);

/* With is_done, light that was taken over now belongs to `ahead`, else to
 * ahead->before. */
void murk_ahead_end(murk_ahead *ahead, bool is_done);

/* Destroys the light of the later steps, and the poses. */
void murk_ahead_release(murk_ahead *ahead);

/* What the plan before leaves for the rows of a step. `plan` has the candidates
 * and the matrix of that plan. False: nothing. */
bool murk_ahead_earlier(murk_earlier_plan *out, const murk_ahead *ahead,
                        size_t step, const murk_earlier_plan *plan);

/* murk_plan_choose() for the mean of all steps of plan->ahead at which there is
 * something to see; `sight` is that of the plan's own time. Fixed sensors are
 * at each step where they are then, and are absent once they have failed.
 * Value, bound and curve of plan->place are of the mean; plan->free is of the
 * own time alone. */
murk_status murk_ahead_choose(murk_plan_result *plan, murk_sight *sight,
                              murk_error *err);

#endif
