/* Coverage of sensors in one row of a study. For use inside src/cases only. */
#ifndef MURK_CASES_SWEEP_COVERAGE_H
#define MURK_CASES_SWEEP_COVERAGE_H

#include "cases/sweep_light.h"

/* True if sensors are measured by targets alone, so that no light must be
 * traced for them: the scene has targets (given or drawn points that take the
 * place of photon records, plan/targets.h), and the mode of detection is not
 * `power`, which needs light. */
bool murk_sweep_needs_no_light(const murk_scene_desc *scene);

/* True if there is something to see in row k of the study: a light shines
 * (murk_sweep_light_shines()), or no light is needed. */
bool murk_sweep_can_see(const murk_sweep_light *light, size_t k);

/* True if the traced light left a record in either map, or no light is needed
 * (murk_sweep_needs_no_light()). */
bool murk_sweep_has_seen(const murk_stage *stage, const murk_traced *traced);

/* Adds the columns coverage_fixed and coverage_best to the row, as far as they
 * are asked for, and with coverage_best the sensors of the best plan. `traced`
 * is the light that chooses the best plan. The columns are NaN if `traced` is
 * NULL or murk_sweep_has_seen() is false for `traced`. */
murk_status murk_sweep_measure_coverage(murk_sweep_light *light, size_t k,
                                        murk_study_row *row,
                                        const murk_traced *traced,
                                        murk_error *err);

/* Coverage of a plan on the held-out stream of light or of drawn targets
 * (hold_out of the scene); on the stream that chose the plan if the scene holds
 * nothing out or lists all targets. NaN if there is nothing to see. */
murk_status murk_sweep_measure(murk_sweep_light *light, size_t k,
                               const murk_pose *sensor, size_t n,
                               murk_estimate *out, murk_error *err);

#endif
