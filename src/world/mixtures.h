/* A preset's mixture of phase functions as one table. */
#ifndef MURK_WORLD_MIXTURES_H
#define MURK_WORLD_MIXTURES_H

#include "medium/phase_table.h"
#include "preset/preset.h"

/* Within some MURK_PHASE_TOLERANCE of the sum of shares times densities, except
 * that below .001 degrees the law of the first rows goes on. *out is the
 * caller's: murk_phase_table_destroy(). Fails with MURK_BAD_VALUE at `where`,
 * or at the row of a table. */
murk_status murk_mixture_table(murk_phase_table **out,
                               const murk_mixture *mixture, const char *where,
                               murk_error *err);

#endif
