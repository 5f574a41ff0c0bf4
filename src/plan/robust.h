/* Robustness of a plan: the coverage that is left if one sensor fails, the
 * coverage if sensors are placed and turned with random errors, and the range
 * that links between sensors need to join all sensors (sensing/links.h). */
#ifndef MURK_PLAN_ROBUST_H
#define MURK_PLAN_ROBUST_H

#include "sensing/links.h"
#include "sensing/sight.h"
#include "world/stage.h"

/* Coverage of sensors that are placed and turned with random errors
 * (sensing/jitter.h), over many draws. */
typedef struct murk_jittered {
    size_t draws;      /* 0 if the scene does not ask for it */
    bool on_held_out;  /* measured on the second map; else on the map that chose
                        * the plan */
    double as_planned; /* coverage without errors, on the same map */
    murk_estimate mean; /* mean over the draws. Error: that of the draws, and
                         * that of the photons, for which the mean of the errors
                         * of the draws is an upper bound */
    double quantile;    /* 5 % quantile: one draw in twenty covers less */
    double quantile_lower, quantile_upper; /* 95 % confidence interval of the
                                            * quantile, by the number of draws;
                                            * NaN if there are too few draws */
    size_t unmoved; /* number of the draws * sensors displacements that found no
                     * free position */
} murk_jittered;

typedef struct murk_robust {
    size_t sensors;
    double *without;              /* [sensors]; coverage of the plan without
                                   * that sensor */
    double *without_held_out;     /* [sensors]; the same on the second map; NULL
                                   * if there is none */
    double total, total_held_out; /* coverage with all sensors */
    murk_jittered jittered;
    murk_links links;
} murk_robust;

/* Computes the links, and the coverage without each sensor from the coverage of
 * all n sensors on the map that chose the plan. Release also after a failure.
 */
murk_status murk_robust_begin(murk_robust *robust, const murk_stage *stage,
                              const murk_pose *pose, size_t n,
                              const murk_coverage_result *coverage,
                              murk_error *err);

/* Adds the coverage without each sensor on the second map. */
murk_status murk_robust_hold_out(murk_robust *robust,
                                 const murk_coverage_result *coverage,
                                 murk_error *err);

/* Fills `jittered` if the scene asks for it and the plan has sensors. coverage
 * is that of the plan on this sight. Fails as murk_coverage_result_measure().
 */
murk_status murk_robust_jitter(murk_robust *robust, const murk_stage *stage,
                               murk_sight *sight, const murk_pose *pose,
                               const murk_coverage_result *coverage,
                               bool on_held_out, murk_error *err);

/* The number of draws that the scene asks for; 0: none. This and the next two
 * functions are the steps of murk_robust_jitter(), for a plan over several
 * sights. */
size_t murk_robust_draws(const murk_scene_desc *scene);

/* Computes covered[draws] of n sensors displaced among the surfaces of this
 * stage, on one sight. The draws are the same for any sight. *unmoved counts
 * displacements that found no free position. */
murk_status murk_robust_draw(murk_estimate *covered, size_t *unmoved,
                             const murk_stage *stage, murk_sight *sight,
                             const murk_pose *pose, size_t n, murk_error *err);

/* Sets `jittered` from the coverage of each draw and the coverage without
 * errors. */
murk_status murk_robust_summarise(murk_robust *robust,
                                  const murk_estimate *covered, size_t draws,
                                  size_t unmoved, double as_planned,
                                  bool on_held_out, murk_error *err);
void murk_robust_release(murk_robust *robust);

/* The sensor (counted from 0) whose loss lowers coverage most, with that loss,
 * and the mean loss over all sensors; on the second map if there is one. Both
 * losses are NaN without sensors. */
typedef struct murk_drop_one {
    size_t worst;
    double worst_loss, mean_loss;
} murk_drop_one;
murk_drop_one murk_robust_drop_one(const murk_robust *robust);

#endif
