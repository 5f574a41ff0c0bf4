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
    size_t draws;      /* 0 if the scene does not ask for draws, or the plan has
                        * no sensors; the other members are 0 then */
    bool on_held_out;  /* measured on the second map; else on the map that chose
                        * the plan, or on the only map of given sensors */
    double as_planned; /* coverage without errors, on the same map */
    murk_estimate mean; /* mean over the draws. The square of the standard error
                         * is the sum of two squares: of the error by draws, and
                         * of an upper bound on the error by photons, which is
                         * the mean of the errors of the draws */
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
    double total, total_held_out; /* coverage with all sensors; total_held_out
                                   * is NaN without a second map */
    murk_jittered jittered;
    murk_links links;
} murk_robust;

/* Sets *robust: computes the links between the sensors pose[n], and the
 * coverage without each sensor from `coverage`, which is that of all n sensors;
 * for a plan, on the map that chose the plan. Fails with MURK_NO_MEMORY or as
 * murk_links_find(). Release *robust also after a failure. */
murk_status murk_robust_begin(murk_robust *robust, const murk_stage *stage,
                              const murk_pose *pose, size_t n,
                              const murk_coverage_result *coverage,
                              murk_error *err);

/* Adds the coverage without each sensor on the second map. */
murk_status murk_robust_hold_out(murk_robust *robust,
                                 const murk_coverage_result *coverage,
                                 murk_error *err);

/* Fills robust->jittered if the scene asks for draws and the plan has sensors.
 * coverage is that of the plan, without errors, on this sight. Fails as
 * murk_coverage_result_measure(). */
murk_status murk_robust_jitter(murk_robust *robust, const murk_stage *stage,
                               murk_sight *sight, const murk_pose *pose,
                               const murk_coverage_result *coverage,
                               bool on_held_out, murk_error *err);

/* The number of draws that the scene asks for; 0: none. murk_robust_draws(),
 * murk_robust_draw() and murk_robust_summarise() are the steps of
 * murk_robust_jitter(), for a plan over several sights. */
size_t murk_robust_draws(const murk_scene_desc *scene);

/* Computes covered[draws], the coverage in each draw of the sensors pose[n]
 * displaced among the surfaces of this stage, on one sight. The displacements
 * do not depend on the sight. *unmoved receives the number of displacements
 * that found no free position. */
murk_status murk_robust_draw(murk_estimate *covered, size_t *unmoved,
                             const murk_stage *stage, murk_sight *sight,
                             const murk_pose *pose, size_t n, murk_error *err);

/* Sets robust->jittered from the coverage of each draw, covered[draws], and the
 * coverage without errors, as_planned. draws is at least 1. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_robust_summarise(murk_robust *robust,
                                  const murk_estimate *covered, size_t draws,
                                  size_t unmoved, double as_planned,
                                  bool on_held_out, murk_error *err);
void murk_robust_release(murk_robust *robust);

/* The sensor (counted from 0; of equal ones the first) whose failure lowers
 * coverage most, the coverage lost then, and the mean over all sensors of the
 * coverage that the failure of one sensor loses; on the second map if there is
 * one. Both losses are NaN without sensors. */
typedef struct murk_drop_one {
    size_t worst;
    double worst_loss, mean_loss;
} murk_drop_one;
murk_drop_one murk_robust_drop_one(const murk_robust *robust);

#endif
