/* The mixture of phase functions of a preset, tabulated as one phase function.
 */
#ifndef MURK_WORLD_MIXTURES_H
#define MURK_WORLD_MIXTURES_H

#include "medium/phase_table.h"
#include "preset/preset.h"

/* Tabulates the sum of share times phase function over the parts of the
 * mixture. The table agrees with the sum within about MURK_PHASE_TOLERANCE;
 * below 0.001 degrees the power law of the first two rows is continued. The
 * caller owns *out (murk_phase_table_destroy()). Fails with MURK_BAD_VALUE at
 * `where`, or with MURK_NO_MEMORY. */
murk_status murk_mixture_table(murk_phase_table **out,
                               const murk_mixture *mixture, const char *where,
                               murk_error *err);

#endif
