/* How much a plan hangs on each of its sensors, on standing just so, and on
 * how far its links reach. */
#ifndef MURK_PLAN_ROBUST_H
#define MURK_PLAN_ROBUST_H

#include "sensing/links.h"
#include "sensing/sight.h"
#include "world/stage.h"

/* Coverage of sensors set down not quite where and turned not quite as planned
 * (sensing/jitter.h), over many draws. */
typedef struct murk_jittered {
    size_t draws;      /* 0: not asked for */
    bool on_held_out;  /* the map it was measured on; else the one that chose */
    double as_planned; /* on the same map */
    murk_estimate mean; /* error: of the draws and of the map's photons; the
                           latter at most, the mean of each draw's own */
    double quantile;    /* 5 %: one draw in twenty covers no more */
    double quantile_lower, quantile_upper; /* hold it at 95 %, as for the
                           draws; NaN where there are too few draws */
    size_t unmoved; /* of draws * sensors: found no free place */
} murk_jittered;

typedef struct murk_robust {
    size_t sensors;
    double *without;              /* [sensors] coverage without that one */
    double *without_held_out;     /* likewise on the second map; NULL: none */
    double total, total_held_out; /* with all of them */
    murk_jittered jittered;
    murk_links links;
} murk_robust;

/* Links, and coverage without each sensor, from coverage of all n as measured
 * on the map that chose. Release also after a failure. */
murk_status murk_robust_begin(murk_robust *robust, const murk_stage *stage,
                              const murk_pose *pose, size_t n,
                              const murk_coverage_result *coverage,
                              murk_error *err);

/* Coverage without each sensor on the second map. */
murk_status murk_robust_hold_out(murk_robust *robust,
                                 const murk_coverage_result *coverage,
                                 murk_error *err);

/* Fills `jittered` where the scene asks for it. `coverage` is the plan's on
 * this sight. Fails as murk_coverage_result_measure(). */
murk_status murk_robust_jitter(murk_robust *robust, const murk_stage *stage,
                               murk_sight *sight, const murk_pose *pose,
                               const murk_coverage_result *coverage,
                               bool on_held_out, murk_error *err);

/* The same in two steps, for a plan over several sights. Draws that the scene
 * asks for; 0: none. */
size_t murk_robust_draws(const murk_scene_desc *scene);

/* covered[draws] of n sensors set down by this stage's surfaces, on one sight;
 * the same draws on any sight. */
murk_status murk_robust_shake(murk_estimate *covered, size_t *unmoved,
                              const murk_stage *stage, murk_sight *sight,
                              const murk_pose *pose, size_t n, murk_error *err);

/* `jittered` from what each draw covers, and the plan as it is. */
murk_status murk_robust_sum_up(murk_robust *robust,
                               const murk_estimate *covered, size_t draws,
                               size_t unmoved, double as_planned,
                               bool on_held_out, murk_error *err);
void murk_robust_release(murk_robust *robust);

/* The sensor, from 0, without which coverage falls most, and by how much; the
 * mean over all. On the second map where there is one. */
typedef struct murk_drop_one {
    size_t worst;
    double worst_loss, mean_loss;
} murk_drop_one;
murk_drop_one murk_robust_drop_one(const murk_robust *robust);

#endif
