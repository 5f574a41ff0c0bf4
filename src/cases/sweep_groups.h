/* Which rows of a study share a light, and what each is kept by. Private to the
 * sweep. */
#ifndef MURK_CASES_SWEEP_GROUPS_H
#define MURK_CASES_SWEEP_GROUPS_H

#include "cases/sweep.h"
#include "cases/sweep_keys.h"

/* Fills the groups, and of the rows group and key, from keys[rows]; rows that
 * are done could not be read, and belong to none. */
murk_status murk_sweep_group_rows(murk_sweep *sweep,
                                  const murk_sweep_keys *keys, murk_error *err);

#endif
