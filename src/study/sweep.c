#include "study/sweep.h"

#include "base/file.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "study/sweep_keys.h"
#include "study/sweep_work.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define ROW_BYTES_MAX 16000000

static murk_status no_memory(const murk_sweep_desc *desc, murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, desc->study->path,
                     "no memory for %zu rows", desc->study->rows);
}

/* ---- rows and groups ---- */

/* While rows are read. */
typedef struct reading {
    murk_sweep *sweep;
    murk_sweep_sums sums;
    murk_sweep_keys *keys; /* [rows] */
    bool has_outputs;
    murk_error first; /* the first row's failure */
} reading;

static void tell_failure(murk_sweep_row *row, const murk_error *why)
{
    snprintf(row->found.failed, sizeof row->found.failed, "%s%s%s", why->where,
             why->where[0] ? ": " : "", why->text);
    row->is_done = true;
}

/* What is wrong with the outputs is wrong with the study; else the row alone
 * fails. */
static murk_status read_row(reading *r, size_t i, murk_error *err)
{
    murk_sweep *sweep = r->sweep;
    const murk_sweep_desc *desc = &sweep->desc;
    murk_scene *scene = NULL;
    murk_error why = {0};
    murk_status status = MURK_OK;
    if (murk_study_row_scene(&scene, desc->study, i, desc->overrides,
                             desc->n_overrides, &why)) {
        goto done;
    }
    if (!r->has_outputs) {
        status = murk_outputs_choose(&sweep->outputs, desc->study, scene, err);
        memcpy(sweep->scene_sha256, scene->sha256, sizeof scene->sha256);
        sweep->seed = scene->seed;
        r->has_outputs = true;
    }
    if (!status) {
        murk_sweep_keys_of(&r->keys[i], &r->sums, scene, &sweep->outputs,
                           desc->version, &why);
    }
done:
    if (!status && why.status) {
        tell_failure(&sweep->row[i], &why);
        r->first = r->first.status ? r->first : why;
    }
    murk_scene_destroy(scene);
    return status;
}

static murk_status group_rows(reading *r, murk_error *err)
{
    murk_sweep *sweep = r->sweep;
    const size_t rows = sweep->desc.study->rows;
    sweep->group = calloc(rows + 1, sizeof *sweep->group);
    if (!sweep->group) {
        return no_memory(&sweep->desc, err);
    }
    for (size_t i = 0; i < rows; ++i) {
        size_t g = 0;
        if (sweep->row[i].is_done) { /* it cannot be read */
            sweep->row[i].group = SIZE_MAX;
            continue;
        }
        while (g < sweep->groups &&
               strcmp(r->keys[sweep->group[g].row[0]].world,
                      r->keys[i].world) != 0) {
            ++g;
        }
        murk_sweep_group *group = &sweep->group[g];
        size_t *grown = realloc(group->row, (group->n + 1) * sizeof *grown);
        if (!grown) {
            return no_memory(&sweep->desc, err);
        }
        group->row = grown;
        group->row[group->n++] = i;
        sweep->groups += g == sweep->groups;
        sweep->row[i].group = g;
    }
    return MURK_OK;
}

/* A row is known by itself, and by the different lights in its group: how many
 * photons its light got hangs on them. */
static murk_status sign_rows(const reading *r, murk_error *err)
{
    murk_sweep *sweep = r->sweep;
    for (size_t g = 0; g < sweep->groups; ++g) {
        murk_sweep_group *group = &sweep->group[g];
        char *lights = malloc(group->n * 64 + 1);
        if (!lights) {
            return no_memory(&sweep->desc, err);
        }
        for (size_t k = 0; k < group->n; ++k) {
            const char *own = r->keys[group->row[k]].light;
            bool is_new = true;
            for (size_t j = 0; j < group->lights && is_new; ++j) {
                is_new = memcmp(lights + 64 * j, own, 64) != 0;
            }
            if (is_new) {
                memcpy(lights + 64 * group->lights++, own, 64);
            }
        }
        for (size_t k = 0; k < group->n; ++k) {
            char text[130], all[65];
            murk_sha256_hex(lights, 64 * group->lights, all);
            snprintf(text, sizeof text, "%s\n%s", r->keys[group->row[k]].own,
                     all);
            murk_sha256_hex(text, strlen(text), sweep->row[group->row[k]].key);
        }
        free(lights);
    }
    return MURK_OK;
}

/* ---- what is kept ---- */

/* Of a row's file; false where the path is too long. */
static bool row_path(const murk_sweep *sweep, size_t i, char *out, size_t size)
{
    return snprintf(out, size, "%s/rows/%.32s.yaml", sweep->desc.folder,
                    sweep->row[i].key) < (int)size;
}

static bool has_fluence(const murk_sweep *sweep, size_t i)
{
    char name[MURK_SWEEP_NAME_SIZE], path[4096];
    if (!sweep->outputs.wants[MURK_OUTPUT_FLUENCE]) {
        return true;
    }
    murk_sweep_fluence_name(name, i);
    return snprintf(path, sizeof path, "%s/%s", sweep->desc.folder, name) <
               (int)sizeof path &&
           access(path, R_OK) == 0;
}

/* A file that cannot be read, or is not a row's, is no row kept. */
static void load_row(murk_sweep *sweep, size_t i)
{
    murk_sweep_row *row = &sweep->row[i];
    char path[4096];
    char *text = NULL;
    size_t size = 0;
    if (!row->is_done && row_path(sweep, i, path, sizeof path) &&
        access(path, F_OK) == 0 && has_fluence(sweep, i) &&
        !murk_file_read(&text, &size, path, ROW_BYTES_MAX, NULL)) {
        row->is_kept =
            murk_row_read(&row->found, text, size, path, NULL) == MURK_OK;
        row->is_done = row->is_kept;
        if (!row->is_kept) {
            murk_row_release(&row->found);
        }
    }
    free(text);
}

/* Only what has not failed: that is tried again. */
static murk_status keep_row(const murk_sweep *sweep, size_t i, const char *text,
                            size_t size, murk_error *err)
{
    char path[4096];
    if (!sweep->desc.folder || sweep->row[i].found.failed[0]) {
        return MURK_OK;
    }
    if (!row_path(sweep, i, path, sizeof path)) {
        return murk_fail(err, MURK_BAD_VALUE, sweep->desc.folder,
                         "too long a path");
    }
    return murk_file_write(path, text, size, err);
}

static murk_status open_folder(const murk_sweep *sweep, murk_error *err)
{
    char path[4096];
    if (!sweep->desc.folder) {
        return sweep->outputs.wants[MURK_OUTPUT_FLUENCE]
                   ? murk_fail(err, MURK_BAD_VALUE,
                               sweep->desc.study->outputs_where,
                               "fluence_vdb needs a folder to write into: -o "
                               "DIR")
                   : MURK_OK;
    }
    if (snprintf(path, sizeof path, "%s/rows", sweep->desc.folder) >=
        (int)sizeof path) {
        return murk_fail(err, MURK_BAD_VALUE, sweep->desc.folder,
                         "too long a path");
    }
    return murk_folder_make(path, err);
}

/* ---- all ---- */

/* --set of a key that an axis sets would be lost. */
static murk_status check_overrides(const murk_sweep_desc *desc, murk_error *err)
{
    for (size_t i = 0; i < desc->n_overrides; ++i) {
        const char *text = desc->overrides[i].text;
        const size_t n = strcspn(text, "=");
        for (size_t a = 0; a < desc->study->axes; ++a) {
            const murk_study_axis *axis = &desc->study->axis[a];
            if (axis->kind == MURK_STUDY_AXIS_KEY && strlen(axis->path) == n &&
                strncmp(axis->path, text, n) == 0) {
                return murk_fail(err, MURK_BAD_VALUE, axis->where,
                                 "is set on the command line, too: must be one "
                                 "of them");
            }
        }
    }
    return MURK_OK;
}

static murk_status check_plan(const murk_sweep_desc *desc, murk_error *err)
{
    return desc->study->plan && access(desc->study->plan, R_OK) != 0
               ? murk_fail(err, MURK_BAD_FILE, desc->study->plan,
                           "cannot be read (plan)")
               : MURK_OK;
}

static murk_status read_rows(reading *r, murk_error *err)
{
    murk_sweep *sweep = r->sweep;
    const size_t rows = sweep->desc.study->rows;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < rows && !status; ++i) {
        status = murk_interrupted()
                     ? murk_fail(err, MURK_INTERRUPTED, "", "interrupted")
                     : read_row(r, i, err);
    }
    if (!status && murk_sweep_done(sweep) == rows) {
        status = murk_fail(err, r->first.status, r->first.where, "%s",
                           r->first.text);
    }
    if (!status) {
        status = group_rows(r, err);
    }
    return status ? status : sign_rows(r, err);
}

murk_status murk_sweep_create(murk_sweep **out, const murk_sweep_desc *desc,
                              murk_error *err)
{
    const size_t rows = desc->study->rows;
    murk_sweep *sweep = calloc(1, sizeof *sweep);
    reading r = {.sweep = sweep, .keys = calloc(rows, sizeof *r.keys)};
    if (sweep) {
        sweep->desc = *desc;
        sweep->row = calloc(rows, sizeof *sweep->row);
    }
    murk_status status =
        sweep && sweep->row && r.keys ? MURK_OK : no_memory(desc, err);
    if (!status) {
        status = check_overrides(desc, err);
    }
    if (!status) {
        status = check_plan(desc, err);
    }
    if (!status) {
        status = read_rows(&r, err);
    }
    if (!status) {
        status = open_folder(sweep, err);
    }
    for (size_t i = 0; !status && desc->folder && i < rows; ++i) {
        load_row(sweep, i);
    }
    murk_sweep_sums_release(&r.sums);
    free(r.keys);
    if (status) {
        murk_sweep_destroy(sweep);
        return status;
    }
    *out = sweep;
    return MURK_OK;
}

void murk_sweep_destroy(murk_sweep *sweep)
{
    if (!sweep) {
        return;
    }
    for (size_t i = 0; sweep->row && i < sweep->desc.study->rows; ++i) {
        murk_row_release(&sweep->row[i].found);
    }
    for (size_t g = 0; g < sweep->groups; ++g) {
        free(sweep->group[g].row);
    }
    free(sweep->group);
    free(sweep->row);
    free(sweep);
}

/* One row's message: its number, a line end, its text. */
static murk_status take_row(void *context, const char *bytes, size_t size,
                            murk_error *err)
{
    murk_sweep *sweep = context;
    char *text = NULL;
    const unsigned long i = strtoul(bytes, &text, 10);
    if (*text != '\n' || i >= sweep->desc.study->rows) {
        return murk_fail(err, MURK_RUN_FAILED, "", "not a row's message");
    }
    ++text;
    const size_t length = size - (size_t)(text - bytes);
    murk_sweep_row *row = &sweep->row[i];
    murk_status status =
        murk_row_read(&row->found, text, length, "a row's process", err);
    row->is_done = !status;
    if (!status) {
        status = keep_row(sweep, i, text, length, err);
        sweep->cannot_keep = status != MURK_OK;
    }
    if (!status && sweep->desc.row_done) {
        sweep->desc.row_done(sweep->desc.context, i);
    }
    return status;
}

/* What its process did not bring to an end. */
static void fail_rest(murk_sweep *sweep, const murk_sweep_group *group,
                      const murk_error *why)
{
    for (size_t k = 0; k < group->n; ++k) {
        murk_sweep_row *row = &sweep->row[group->row[k]];
        if (!row->is_done) {
            tell_failure(row, why);
            if (sweep->desc.row_done) {
                sweep->desc.row_done(sweep->desc.context, group->row[k]);
            }
        }
    }
}

static bool is_done(const murk_sweep *sweep, const murk_sweep_group *group)
{
    size_t done = 0;
    for (size_t k = 0; k < group->n; ++k) {
        done += sweep->row[group->row[k]].is_done;
    }
    return done == group->n;
}

murk_status murk_sweep_run(murk_sweep *sweep, murk_error *err)
{
    for (size_t g = 0; g < sweep->groups; ++g) {
        murk_sweep_group *group = &sweep->group[g];
        murk_sweep_job job = {sweep, group};
        murk_error why = {0};
        if (is_done(sweep, group)) {
            continue;
        }
        group->was_traced = true;
        const murk_status status =
            murk_apart_run(murk_sweep_work, &job, take_row, sweep, &why);
        if (status == MURK_INTERRUPTED || murk_interrupted()) {
            return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
        }
        if (status && sweep->cannot_keep) {
            return murk_fail(err, why.status, why.where, "%s", why.text);
        }
        if (status) {
            fail_rest(sweep, group, &why);
        }
    }
    return MURK_OK;
}

size_t murk_sweep_done(const murk_sweep *sweep)
{
    size_t done = 0;
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        done += sweep->row[i].is_done;
    }
    return done;
}

size_t murk_sweep_failed(const murk_sweep *sweep)
{
    size_t failed = 0;
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        failed += sweep->row[i].is_done && sweep->row[i].found.failed[0];
    }
    return failed;
}
