/* The rows of a study that are done, stored in FOLDER/rows in one file for
 * each key, the grids of the fluence rate beside them, and rows as messages
 * between processes. */
#include "cases/sweep_store.h"

#include "base/file.h"
#include "base/staging.h"
#include "medium/grid_write.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A row has a few values for each tally and band and a line for each sensor: a
 * longer file is not one of murk. */
#define ROW_BYTES_MAX 16000000
/* 64 GB: more than any grid that fits in the memory of a workstation. */
#define FLUENCE_BYTES_MAX (UINT64_C(64) << 30)

static murk_status too_long(const murk_sweep *sweep, murk_error *err)
{
    return murk_fail(err, MURK_BAD_VALUE, sweep->desc.folder,
                     "too long a path");
}

murk_status murk_sweep_check_folder(const murk_sweep *sweep, murk_error *err)
{
    return !sweep->desc.folder && sweep->outputs.wants[MURK_OUTPUT_FLUENCE]
               ? murk_fail(err, MURK_BAD_VALUE,
                           sweep->desc.study->outputs_where,
                           "fluence_vdb needs a folder to write into: -o DIR")
               : MURK_OK;
}

murk_status murk_sweep_open(const murk_sweep *sweep, murk_error *err)
{
    char path[4096];
    if (!sweep->desc.folder) {
        return MURK_OK;
    }
    if (snprintf(path, sizeof path, "%s/rows", sweep->desc.folder) >=
        (int)sizeof path) {
        return too_long(sweep, err);
    }
    const murk_status status = murk_folder_make(path, err);
    if (!status) {
        murk_staging_clean(path, true);
    }
    return status;
}

/* ---- files ---- */

/* False where the path is too long. */
static bool path_of(const murk_sweep *sweep, const char *key, char *out,
                    size_t size)
{
    return snprintf(out, size, "%s/rows/%.32s.yaml", sweep->desc.folder, key) <
           (int)size;
}

/* A file that cannot be read, or is not a row's, is no row kept. */
bool murk_sweep_load(const murk_sweep *sweep, const char *key,
                     murk_study_row *out)
{
    char path[4096];
    char *text = NULL;
    size_t size = 0;
    bool is_read = false;
    *out = (murk_study_row){0};
    if (sweep->desc.folder && path_of(sweep, key, path, sizeof path) &&
        access(path, F_OK) == 0 &&
        !murk_file_read_own(&text, &size, path, ROW_BYTES_MAX, NULL)) {
        is_read = murk_study_row_read(out, text, size, path, NULL) == MURK_OK;
        if (!is_read) {
            murk_study_row_release(out);
        }
    }
    free(text);
    return is_read;
}

murk_status murk_sweep_keep(const murk_sweep *sweep, const char *key,
                            const char *text, size_t size, murk_error *err)
{
    char path[4096];
    return !sweep->desc.folder ? MURK_OK
           : path_of(sweep, key, path, sizeof path)
               ? murk_file_write(path, text, size, err)
               : too_long(sweep, err);
}

/* ---- fluence ---- */

void murk_sweep_fluence_name(char out[MURK_SWEEP_NAME_SIZE], size_t row)
{
    snprintf(out, MURK_SWEEP_NAME_SIZE, "fluence_%04zu.vdb", row + 1);
}

murk_status murk_sweep_sum(char out[MURK_ROW_SUM_SIZE], const char *path,
                           murk_error *err)
{
    uint64_t sum[2];
    const murk_status status =
        murk_file_checksum_own(path, FLUENCE_BYTES_MAX, sum, err);
    if (!status) {
        snprintf(out, MURK_ROW_SUM_SIZE, "%016" PRIx64 "%016" PRIx64, sum[1],
                 sum[0]);
    }
    return status;
}

bool murk_sweep_has_fluence(const murk_sweep *sweep, size_t i,
                            const murk_study_row *row)
{
    char name[MURK_SWEEP_NAME_SIZE], path[4096], sum[MURK_ROW_SUM_SIZE];
    if (!sweep->outputs.wants[MURK_OUTPUT_FLUENCE]) {
        return true;
    }
    murk_sweep_fluence_name(name, i);
    return snprintf(path, sizeof path, "%s/%s", sweep->desc.folder, name) <
               (int)sizeof path &&
           access(path, R_OK) == 0 && !murk_sweep_sum(sum, path, NULL) &&
           strcmp(sum, row->fluence) == 0;
}

murk_status murk_sweep_check_fluence(const murk_sweep *sweep, size_t i,
                                     murk_error *err)
{
    char name[MURK_SWEEP_NAME_SIZE], path[4096];
    if (!sweep->outputs.wants[MURK_OUTPUT_FLUENCE]) {
        return MURK_OK;
    }
    murk_sweep_fluence_name(name, i);
    return snprintf(path, sizeof path, "%s/%s", sweep->desc.folder, name) <
                   (int)sizeof path
               ? murk_file_check_owner(path, MURK_GRID_MARK,
                                       sizeof MURK_GRID_MARK - 1,
                                       sweep->desc.force, err)
               : too_long(sweep, err);
}

/* ---- messages ---- */

murk_status murk_sweep_send(murk_isolated *isolated, size_t number,
                            const murk_study_row *row, murk_error *err)
{
    char *text = murk_study_row_print(row), *message = NULL;
    const size_t size = text ? strlen(text) + 32 : 0;
    murk_status status = MURK_OK;
    if (text) {
        message = malloc(size);
    }
    if (!message) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for a row");
    } else {
        const int n = snprintf(message, size, "%zu\n%s", number, text);
        status = murk_isolated_send(isolated, message, (size_t)n, err);
    }
    free(message);
    free(text);
    return status;
}

murk_status murk_sweep_receive(murk_study_row *out, size_t *number, size_t max,
                               const char *bytes, size_t size,
                               const char **text, murk_error *err)
{
    char *end = NULL;
    const unsigned long i = strtoul(bytes, &end, 10);
    *out = (murk_study_row){0};
    if (*end != '\n' || i >= max) {
        return murk_fail(err, MURK_RUN_FAILED, "", "not a row's message");
    }
    *number = i;
    *text = end + 1;
    return murk_study_row_read(out, *text, size - (size_t)(*text - bytes),
                               "a row's process", err);
}
