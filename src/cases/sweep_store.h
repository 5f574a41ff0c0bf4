/* The stored rows of a study: FOLDER/rows has one small file for each row,
 * named by the key of the row; and rows as messages between processes. Inside
 * this room only. */
#ifndef MURK_CASES_SWEEP_STORE_H
#define MURK_CASES_SWEEP_STORE_H

#include "base/isolated.h"
#include "cases/sweep.h"

/* Fails if an output needs a folder and the study has none. */
murk_status murk_sweep_check_folder(const murk_sweep *sweep, murk_error *err);
/* Makes the folder and rows/ in it. Without a folder nothing is stored. */
murk_status murk_sweep_open(const murk_sweep *sweep, murk_error *err);

/* Reads the stored row of a key. False if there is no usable file; *out is
 * empty then. */
bool murk_sweep_load(const murk_sweep *sweep, const char *key,
                     murk_study_row *out);
/* Stores the text of a row under a key. */
murk_status murk_sweep_keep(const murk_sweep *sweep, const char *key,
                            const char *text, size_t size, murk_error *err);

/* The name of the file, within the folder, that a row writes the grid of its
 * fluence rate to; and whether that file is the one that this row wrote. */
#define MURK_SWEEP_NAME_SIZE 32
void murk_sweep_fluence_name(char out[MURK_SWEEP_NAME_SIZE], size_t row);
bool murk_sweep_has_fluence(const murk_sweep *sweep, size_t i,
                            const murk_study_row *row);
/* Fails if the row may not write that file: files that murk did not write are
 * only replaced by force. */
murk_status murk_sweep_check_fluence(const murk_sweep *sweep, size_t i,
                                     murk_error *err);
/* The checksum of a file, for the member fluence of murk_study_row. */
murk_status murk_sweep_sum(char out[MURK_ROW_SUM_SIZE], const char *path,
                           murk_error *err);

/* Sends a message: a number, a line end, the text of a row. */
murk_status murk_sweep_send(murk_isolated *isolated, size_t number,
                            const murk_study_row *row, murk_error *err);
/* Reads such a message: *number is below max, and *text points into bytes.
 * Release *out also after a failure. */
murk_status murk_sweep_receive(murk_study_row *out, size_t *number, size_t max,
                               const char *bytes, size_t size,
                               const char **text, murk_error *err);

#endif
