/* Groups of rows that share one trace, and the key of each row. Inside this
 * room only. */
#ifndef MURK_CASES_SWEEP_GROUPS_H
#define MURK_CASES_SWEEP_GROUPS_H

#include "cases/sweep.h"
#include "cases/sweep_keys.h"

/* Fills the groups of the sweep, and group and key of each row, from
 * keys[rows]. Rows that are done already are those whose scene could not be
 * read; they belong to no group. */
murk_status murk_sweep_group_rows(murk_sweep *sweep,
                                  const murk_sweep_keys *keys, murk_error *err);

#endif
