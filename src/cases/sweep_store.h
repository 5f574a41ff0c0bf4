/* The stored rows of a study: FOLDER/rows has one small file for each row,
 * named by the first 32 digits of the key of the row, one for each plan for all
 * rows, and one for the coverages of these plans in each row. Also runs the
 * subprocesses that send rows. For use inside src/cases only. */
#ifndef MURK_CASES_SWEEP_STORE_H
#define MURK_CASES_SWEEP_STORE_H

#include "base/isolated.h"
#include "cases/sweep.h"

/* A row as a subprocess sends it. */
typedef struct murk_sweep_message {
    size_t number; /* of the row in the study, or of a plan for all rows */
    murk_study_row row;
    const char *text; /* [size] the row as text, to be stored */
    size_t size;
} murk_sweep_message;

/* 64 GiB: more than any grid that fits in the memory of a workstation. */
#define MURK_SWEEP_GRID_BYTES_MAX (UINT64_C(64) << 30)

/* Bytes of the path of a file in the folder: as long as Linux allows. */
#define MURK_SWEEP_PATH_SIZE 4096

/* Fails if the part or an output needs a folder and the study has none. */
murk_status murk_sweep_check_folder(const murk_sweep *sweep, murk_error *err);
/* Makes the folder and rows/ in it. Without a folder nothing is stored. */
murk_status murk_sweep_open(const murk_sweep *sweep, murk_error *err);

/* Reads the stored row of a key. False if there is no usable file; *out is
 * empty then. */
bool murk_sweep_load(const murk_sweep *sweep, const char *key,
                     murk_study_row *out);
/* Takes over row i of the study from the store, unless the row is done. A row
 * is only taken over with the grid of its fluence rate, if there is one. */
void murk_sweep_load_row(murk_sweep *sweep, size_t i);
/* The checksum of the file of a stored row. Fails as murk_file_read_own(). */
murk_status murk_sweep_sum_row(char out[MURK_ROW_SUM_SIZE],
                               const murk_sweep *sweep, const char *key,
                               murk_error *err);
/* The path of a file in the folder. Fails if it is too long. */
murk_status murk_sweep_path(char out[MURK_SWEEP_PATH_SIZE],
                            const murk_sweep *sweep, const char *name,
                            murk_error *err);
/* Stores a row under a key, unless the row failed: the next run tries a failed
 * row again. Without a folder nothing is stored. Sets sweep->cannot_keep if the
 * file cannot be written. */
murk_status murk_sweep_keep(murk_sweep *sweep, const char *key,
                            const murk_sweep_message *message, murk_error *err);

/* The file that a row writes the grid of its fluence rate to, by name within
 * the folder and by path; and whether that file is the one that this row wrote
 * (true, too, if the study does not ask for the grid). */
#define MURK_SWEEP_NAME_SIZE 32
void murk_sweep_fluence_name(char out[MURK_SWEEP_NAME_SIZE], size_t row);
murk_status murk_sweep_fluence_path(char out[MURK_SWEEP_PATH_SIZE],
                                    const murk_sweep *sweep, size_t row,
                                    murk_error *err);
bool murk_sweep_has_fluence(const murk_sweep *sweep, size_t row,
                            const murk_study_row *found);
/* Fails if the row may not write that file: files that murk did not write are
 * only replaced by force. */
murk_status murk_sweep_check_fluence(const murk_sweep *sweep, size_t row,
                                     murk_error *err);
/* The checksum of a file, for the member fluence of murk_study_row. */
murk_status murk_sweep_sum(char out[MURK_ROW_SUM_SIZE], const char *path,
                           murk_error *err);

/* Sends a row from a subprocess. */
murk_status murk_sweep_send(murk_isolated *isolated, size_t number,
                            const murk_study_row *row, murk_error *err);

/* Takes over a row that was sent; it may move the contents of message->row. */
typedef murk_status (*murk_sweep_put)(murk_sweep *sweep,
                                      murk_sweep_message *message,
                                      murk_error *err);

/* Does the job in a subprocess, or in the process that the host chooses, and
 * put() for each row that the job sends, whose number must be below `numbers`.
 * If the job ends early, *why has the reason. Fails if the study must end: it
 * was interrupted, or a row cannot be stored. */
murk_status murk_sweep_process(murk_sweep *sweep, const murk_isolated_job *job,
                               void *context, size_t numbers,
                               murk_sweep_put put, murk_error *why,
                               murk_error *err);

#endif
