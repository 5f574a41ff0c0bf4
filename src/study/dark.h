/* Scenes in which nothing shines: lamps off, the sun below the horizon. Nothing
 * is emitted, so maps are empty, tallies 0, and of what share sensors see there
 * is nothing to say: coverage is NaN all through, which results show as null.
 */
#ifndef MURK_STUDY_DARK_H
#define MURK_STUDY_DARK_H

#include "study/plan.h"

bool murk_stage_is_dark(const murk_stage *stage);

/* Whether plans would look at photons, of which there are none: it is dark, and
 * no targets stand in for light. */
bool murk_plan_is_dark(const murk_stage *stage);

/* Of n sensors: release as any other. Fails with MURK_NO_MEMORY. */
murk_status murk_dark_coverage(murk_coverage_result *out,
                               const murk_stage *stage, size_t n,
                               murk_error *err);

/* From a prepared plan on, as murk_plan_result_make(): the fixed sensors, and
 * no others, since none is better than another. */
murk_status murk_dark_plan(murk_plan_result *plan, const murk_stage *stage,
                           murk_error *err);

#endif
