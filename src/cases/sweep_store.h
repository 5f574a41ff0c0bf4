/* What a study keeps of what is done: FOLDER/rows, a small file each, by a
 * checksum of all that it follows from; and how rows travel between processes.
 * Private to the sweep. */
#ifndef MURK_CASES_SWEEP_STORE_H
#define MURK_CASES_SWEEP_STORE_H

#include "base/isolated.h"
#include "cases/sweep.h"

/* Whether there is a folder where one is needed; and makes it, with rows/ in
 * it. Without one, nothing is kept. */
murk_status murk_sweep_check_folder(const murk_sweep *sweep, murk_error *err);
murk_status murk_sweep_open(const murk_sweep *sweep, murk_error *err);

/* What is kept under a key; false: nothing that could be used, and *out is
 * empty. */
bool murk_sweep_load(const murk_sweep *sweep, const char *key,
                     murk_study_row *out);
murk_status murk_sweep_keep(const murk_sweep *sweep, const char *key,
                            const char *text, size_t size, murk_error *err);

/* The file of a row's fluence within the folder; and whether it is the one that
 * this row wrote. */
#define MURK_SWEEP_NAME_SIZE 32
void murk_sweep_fluence_name(char out[MURK_SWEEP_NAME_SIZE], size_t row);
bool murk_sweep_has_fluence(const murk_sweep *sweep, size_t i,
                            const murk_study_row *row);
/* Whether a row may write it: another's file is replaced by force alone. */
murk_status murk_sweep_check_fluence(const murk_sweep *sweep, size_t i,
                                     murk_error *err);
/* The checksum of a file, for murk_study_row. */
murk_status murk_sweep_sum(char out[MURK_ROW_SUM_SIZE], const char *path,
                           murk_error *err);

/* A message: a number, a line end, a row's text. */
murk_status murk_sweep_send(murk_isolated *isolated, size_t number,
                            const murk_study_row *row, murk_error *err);
/* And back: number below `most`, *text within bytes. Release *out, also after a
 * failure. */
murk_status murk_sweep_receive(murk_study_row *out, size_t *number, size_t max,
                               const char *bytes, size_t size,
                               const char **text, murk_error *err);

#endif
