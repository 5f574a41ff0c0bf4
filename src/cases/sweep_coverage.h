/* What sensors see in one row of a study. Private to the sweep. */
#ifndef MURK_CASES_SWEEP_COVERAGE_H
#define MURK_CASES_SWEEP_COVERAGE_H

#include "cases/sweep_light.h"

/* Whether targets stand in for light. */
bool murk_sweep_needs_no_light(const murk_scene_desc *scene);

/* Whether anything can be seen: light, or targets that stand in for it. */
bool murk_sweep_can_see(const murk_sweep_light *light, size_t k);

/* Whether the row's light leaves anything to see in it. */
bool murk_sweep_has_seen(const murk_stage *stage, const murk_traced *traced);

/* Adds coverage_fixed and coverage_best, as far as they are asked for, and the
 * best plan's sensors. `traced` is the light that chooses; NULL: there is
 * nothing to see, so values are NaN. */
murk_status murk_sweep_measure_coverage(murk_sweep_light *light, size_t k,
                                        murk_study_row *row,
                                        const murk_traced *traced,
                                        murk_error *err);

/* Coverage of a plan: on light that did not choose, where the scene holds some
 * out; else on the light that does. Where there is nothing to see it is NaN. */
murk_status murk_sweep_measure(murk_sweep_light *light, size_t k,
                               const murk_pose *sensor, size_t n,
                               murk_estimate *out, murk_error *err);

#endif
