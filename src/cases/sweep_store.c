/* The rows of a study that are done, stored in FOLDER/rows in one file for
 * each key, the grids of the fluence rate beside them, and the subprocesses
 * that send rows as messages. */
#include "cases/sweep_store.h"

#include "base/file.h"
#include "base/interrupt.h"
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

murk_status murk_sweep_path(char out[MURK_SWEEP_PATH_SIZE],
                            const murk_sweep *sweep, const char *name,
                            murk_error *err)
{
    return snprintf(out, MURK_SWEEP_PATH_SIZE, "%s/%s", sweep->desc.folder,
                    name) < MURK_SWEEP_PATH_SIZE
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, sweep->desc.folder,
                           "too long a path");
}

murk_status murk_sweep_check_folder(const murk_sweep *sweep, murk_error *err)
{
    if (!sweep->desc.folder && sweep->desc.shard.count) {
        return murk_fail(err, MURK_BAD_VALUE, sweep->desc.study->path,
                         "a part needs a folder to write into");
    }
    return !sweep->desc.folder && sweep->outputs.wants[MURK_OUTPUT_FLUENCE]
               ? murk_fail(err, MURK_BAD_VALUE,
                           sweep->desc.study->outputs_where,
                           "fluence_vdb needs a folder to write into")
               : MURK_OK;
}

murk_status murk_sweep_open(const murk_sweep *sweep, murk_error *err)
{
    char path[MURK_SWEEP_PATH_SIZE];
    if (!sweep->desc.folder) {
        return MURK_OK;
    }
    murk_status status = murk_sweep_path(path, sweep, "rows", err);
    if (!status) {
        status = murk_folder_make(path, err);
    }
    if (!status) {
        murk_staging_clean(path, true);
    }
    return status;
}

/* ---- rows ---- */

static murk_status row_path(char out[MURK_SWEEP_PATH_SIZE],
                            const murk_sweep *sweep, const char *key,
                            murk_error *err)
{
    char name[64];
    snprintf(name, sizeof name, "rows/%.32s.yaml", key);
    return murk_sweep_path(out, sweep, name, err);
}

bool murk_sweep_load(const murk_sweep *sweep, const char *key,
                     murk_study_row *out)
{
    char path[MURK_SWEEP_PATH_SIZE];
    char *text = NULL;
    size_t size = 0;
    bool is_read = false;
    *out = (murk_study_row){0};
    if (sweep->desc.folder && !row_path(path, sweep, key, NULL) &&
        access(path, F_OK) == 0 &&
        !murk_file_read_own(&text, &size, path, ROW_BYTES_MAX, NULL)) {
        is_read = !murk_study_row_read(out, text, size, path, NULL);
    }
    if (!is_read) {
        murk_study_row_release(out);
    }
    free(text);
    return is_read;
}

static murk_status sum_of(char out[MURK_ROW_SUM_SIZE], const char *path,
                          uint64_t max, murk_error *err)
{
    uint64_t sum[2];
    const murk_status status = murk_file_checksum_own(path, max, sum, err);
    if (!status) {
        snprintf(out, MURK_ROW_SUM_SIZE, "%016" PRIx64 "%016" PRIx64, sum[1],
                 sum[0]);
    }
    return status;
}

murk_status murk_sweep_sum_row(char out[MURK_ROW_SUM_SIZE],
                               const murk_sweep *sweep, const char *key,
                               murk_error *err)
{
    char path[MURK_SWEEP_PATH_SIZE];
    const murk_status status = row_path(path, sweep, key, err);
    return status ? status : sum_of(out, path, ROW_BYTES_MAX, err);
}

void murk_sweep_load_row(murk_sweep *sweep, size_t i)
{
    murk_sweep_row *row = &sweep->row[i];
    if (!row->is_done && murk_sweep_load(sweep, row->key, &row->found)) {
        row->is_done = row->is_reused =
            murk_sweep_has_fluence(sweep, i, &row->found);
        if (!row->is_reused) {
            murk_study_row_release(&row->found);
        }
    }
}

murk_status murk_sweep_keep(murk_sweep *sweep, const char *key,
                            const murk_sweep_message *message, murk_error *err)
{
    char path[MURK_SWEEP_PATH_SIZE];
    if (!sweep->desc.folder || message->row.failed[0] ||
        sweep->found.is_received) { /* the rank that ran the row stores it */
        return MURK_OK;
    }
    murk_status status = row_path(path, sweep, key, err);
    if (!status) {
        status = murk_file_write(path, message->text, message->size, err);
    }
    sweep->cannot_keep = status != MURK_OK;
    return status;
}

/* ---- fluence ---- */

void murk_sweep_fluence_name(char out[MURK_SWEEP_NAME_SIZE], size_t row)
{
    snprintf(out, MURK_SWEEP_NAME_SIZE, "fluence_%04zu.vdb", row + 1);
}

murk_status murk_sweep_fluence_path(char out[MURK_SWEEP_PATH_SIZE],
                                    const murk_sweep *sweep, size_t row,
                                    murk_error *err)
{
    char name[MURK_SWEEP_NAME_SIZE];
    murk_sweep_fluence_name(name, row);
    return murk_sweep_path(out, sweep, name, err);
}

murk_status murk_sweep_sum(char out[MURK_ROW_SUM_SIZE], const char *path,
                           murk_error *err)
{
    return sum_of(out, path, MURK_SWEEP_GRID_BYTES_MAX, err);
}

bool murk_sweep_has_fluence(const murk_sweep *sweep, size_t row,
                            const murk_study_row *found)
{
    char path[MURK_SWEEP_PATH_SIZE], sum[MURK_ROW_SUM_SIZE];
    return !sweep->outputs.wants[MURK_OUTPUT_FLUENCE] ||
           (!murk_sweep_fluence_path(path, sweep, row, NULL) &&
            access(path, R_OK) == 0 && !murk_sweep_sum(sum, path, NULL) &&
            strcmp(sum, found->fluence) == 0);
}

murk_status murk_sweep_check_fluence(const murk_sweep *sweep, size_t row,
                                     murk_error *err)
{
    char path[MURK_SWEEP_PATH_SIZE];
    if (!sweep->outputs.wants[MURK_OUTPUT_FLUENCE]) {
        return MURK_OK;
    }
    const murk_status status = murk_sweep_fluence_path(path, sweep, row, err);
    return status ? status
                  : murk_file_check_owner(path, MURK_GRID_MARK,
                                          sizeof MURK_GRID_MARK - 1,
                                          sweep->desc.force, err);
}

/* ---- messages ---- */

murk_status murk_sweep_send(murk_isolated *isolated, size_t number,
                            const murk_study_row *row, murk_error *err)
{
    char *message = murk_study_row_print(row, number);
    const murk_status status =
        message ? murk_isolated_send(isolated, message, strlen(message), err)
                : murk_no_memory(err, "", "for a row");
    free(message);
    return status;
}

/* The context of receive(). */
typedef struct receiving {
    murk_sweep *sweep;
    size_t numbers;
    murk_sweep_put put;
} receiving;

/* A murk_isolated_receive: reads a message and hands it on. */
static murk_status receive(void *context, const char *bytes, size_t size,
                           murk_error *err)
{
    const receiving *r = context;
    char *end = NULL;
    murk_sweep_message message = {.number = strtoul(bytes, &end, 10)};
    if (*end != '\n' || message.number >= r->numbers) {
        return murk_fail(err, MURK_RUN_FAILED, "", "not a row's message");
    }
    message.text = end + 1;
    message.size = size - (size_t)(message.text - bytes);
    murk_status status = murk_study_row_read(
        &message.row, message.text, message.size, "a row's process", err);
    if (!status) {
        status = r->put(r->sweep, &message, err);
    }
    murk_study_row_release(&message.row);
    return status;
}

murk_status murk_sweep_process(murk_sweep *sweep, const murk_isolated_job *job,
                               void *context, size_t numbers,
                               murk_sweep_put put, murk_error *why,
                               murk_error *err)
{
    receiving r = {sweep, numbers, put};
    const murk_status status =
        murk_isolated_do(job, context, sweep->desc.version, receive, &r, why);
    if (status == MURK_INTERRUPTED || murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    return status && sweep->cannot_keep
               ? murk_fail(err, why->code, why->where, "%s", why->text)
               : MURK_OK;
}
