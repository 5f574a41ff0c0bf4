/* Coverage of sensors in one row of a study. For use inside src/cases only. */
#ifndef MURK_CASES_SWEEP_COVERAGE_H
#define MURK_CASES_SWEEP_COVERAGE_H

#include "cases/sweep_light.h"

/* True if targets take the place of light: the scene has targets, and detection
 * is not by power. */
bool murk_sweep_needs_no_light(const murk_scene_desc *scene);

/* True if there is something to see in row k: light, or targets in place of
 * it. */
bool murk_sweep_can_see(const murk_sweep_light *light, size_t k);

/* True if the traced light left records, or targets take the place of light. */
bool murk_sweep_has_seen(const murk_stage *stage, const murk_traced *traced);

/* Adds coverage_fixed and coverage_best, as far as they are asked for, and the
 * sensors of the best plan. `traced` is the light that chooses; if it is NULL
 * or nothing is stored, there is nothing to see and the values are NaN. */
murk_status murk_sweep_measure_coverage(murk_sweep_light *light, size_t k,
                                        murk_study_row *row,
                                        const murk_traced *traced,
                                        murk_error *err);

/* Coverage of a plan on held-out light, or on the light that chose the plan if
 * the scene holds nothing out. NaN if there is nothing to see. */
murk_status murk_sweep_measure(murk_sweep_light *light, size_t k,
                               const murk_pose *sensor, size_t n,
                               murk_estimate *out, murk_error *err);

#endif
