/* Coverage in a scene in which no light source emits: lamps are off, the sun is
 * below the horizon. No photon is emitted, so the maps are empty and a share of
 * the photons is undefined: every coverage is NaN, which results show as null.
 */
#ifndef MURK_PLAN_DARK_H
#define MURK_PLAN_DARK_H

#include "sensing/sight.h"
#include "world/stage.h"

/* Sets all coverage of n sensors to NaN. Release the result as any other
 * coverage. Fails with MURK_NO_MEMORY. */
murk_status murk_dark_coverage(murk_coverage_result *out,
                               const murk_stage *stage, size_t n,
                               murk_error *err);

#endif
