/* Reads a study. */
#ifndef MURK_CASES_SWEEP_READ_H
#define MURK_CASES_SWEEP_READ_H

#include "cases/sweep.h"

/* Reads the scenes of all rows, and the stored rows of earlier runs; traces
 * nothing. A row whose scene cannot be read has failed; the study fails if all
 * rows have. *out is the caller's: murk_sweep_destroy(). The desc is copied;
 * the objects that it points to must outlive *out. */
murk_status murk_sweep_create(murk_sweep **out, const murk_sweep_desc *desc,
                              murk_error *err);
void murk_sweep_destroy(murk_sweep *sweep); /* NULL is fine */

#endif
