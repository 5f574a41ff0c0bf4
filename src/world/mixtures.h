/* The mixture of phase functions of a preset, tabulated as one phase function.
 */
#ifndef MURK_WORLD_MIXTURES_H
#define MURK_WORLD_MIXTURES_H

#include "medium/phase_table.h"
#include "preset/preset.h"

/* Tabulates the sum of share times phase function over the parts of the
 * mixture. The relative error of the table is some 1e-5 for smooth parts, which
 * is about MURK_PHASE_TOLERANCE; below 0.001 degrees the table is extended as
 * murk_phase_table_create() extends rows (medium/phase_table.h). If the only
 * part is a table of given rows, *out is made from these rows alone. The caller
 * owns *out (murk_phase_table_destroy()). Fails with MURK_BAD_VALUE at `where`
 * if a number of a part or a given row is out of range, or with MURK_NO_MEMORY.
 */
murk_status murk_mixture_table(murk_phase_table **out,
                               const murk_mixture *mixture, const char *where,
                               murk_error *err);

#endif
