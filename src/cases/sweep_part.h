/* Parts of a study: what the shards of a run did, and how a study takes it
 * over. The folder of a part is a store of rows (cases/sweep_store.h) with one
 * more file, study.part, which says of which study the part is, and which rows
 * it has. For use inside src/cases only. */
#ifndef MURK_CASES_SWEEP_PART_H
#define MURK_CASES_SWEEP_PART_H

#include "cases/sweep.h"

/* Fails with MURK_BAD_VALUE if study.part in the folder of the shard may not be
 * replaced: only desc.force replaces a file that murk did not write. */
murk_status murk_sweep_part_check(const murk_sweep *sweep, murk_error *err);

/* Writes study.part for a shard whose rows have been run. */
murk_status murk_sweep_part_write(const murk_sweep *sweep, murk_error *err);

/* Takes over the rows of the folders desc.part; writes nothing. The same part
 * may be given several times. Missing parts, and rows whose files are damaged,
 * are named in warnings, and stay to be run. Fails with MURK_BAD_FILE if a
 * folder has no part of a study or study.part is damaged; with MURK_BAD_VALUE
 * if a part is of another study, version or number of parts, with the first
 * difference, or if two parts have different results of a row; or with
 * MURK_NO_MEMORY. */
murk_status murk_sweep_parts_read(murk_sweep *sweep, murk_error *err);

/* Copies the rows that were taken over, with their grids, into the folder of
 * the study, if there is one. */
murk_status murk_sweep_parts_copy(murk_sweep *sweep, murk_error *err);

#endif
