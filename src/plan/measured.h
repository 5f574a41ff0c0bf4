/* Everything that is measured of given sensors on one light: coverage,
 * robustness, and the targets if the scene has them. */
#ifndef MURK_PLAN_MEASURED_H
#define MURK_PLAN_MEASURED_H

#include "plan/plan.h"

typedef struct murk_measured {
    murk_target_facts targets; /* points 0: the scene has no targets, or there
                                * is nothing to see */
    murk_coverage_result coverage;
    murk_robust robust;
} murk_measured;

/* Measures sensor[n]. *sight is the sight by which they are measured; the
 * caller destroys *sight also after a failure. *sight is NULL if it cannot be
 * created, or if there is nothing to see (murk_stage_has_nothing_to_see()); in
 * the second case all coverage is NaN. Release *out also after a failure. */
murk_status murk_measured_make(murk_measured *out, murk_sight **sight,
                               const murk_stage *stage,
                               const murk_traced *traced,
                               const murk_pose *sensor, size_t n,
                               unsigned threads, murk_error *err);
void murk_measured_release(murk_measured *measured);

#endif
