/* Reads a study: the scenes of all rows, the outputs, and the stored rows of an
 * earlier run; puts rows whose light differs only in the power of the light
 * sources together in groups. */
#include "cases/sweep.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "cases/sweep_coverage.h"
#include "cases/sweep_keys.h"
#include "cases/sweep_part.h"
#include "cases/sweep_store.h"
#include "plan/placement_in.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- rows and groups ---- */

/* While rows are read. */
typedef struct reading {
    murk_sweep *sweep;
    murk_file_sums sums;
    murk_sweep_keys *keys; /* [rows] */
    bool has_outputs;
    murk_error first; /* the failure of the first row that failed */
} reading;

/* Fails if the file of the given placement cannot be read as a placement,
 * because then all rows would fail. A sensor type that a row does not have, and
 * a sensor outside of the domain of a row, fail that row only, later. */
static murk_status check_plan(const murk_sweep_desc *desc,
                              const murk_scene_desc *scene, murk_error *err)
{
    const murk_domain everywhere = {
        .box = {murk_vec(-INFINITY, -INFINITY, -INFINITY),
                murk_vec(INFINITY, INFINITY, INFINITY)}};
    murk_pose *sensor = NULL;
    murk_error why = {0};
    size_t n = 0;
    if (!desc->study->plan) {
        return MURK_OK;
    }
    const murk_status status = murk_placement_read(
        &sensor, &n, desc->study->plan, 1, scene, &everywhere, &why);
    free(sensor);
    return status && status != MURK_BAD_VALUE
               ? murk_fail(err, why.code, why.where, "%s", why.text)
               : MURK_OK;
}

/* Reads the outputs of the study by the first scene that can be read. Wrong
 * outputs fail the study. */
static murk_status read_first(reading *r, const murk_scene_desc *scene,
                              murk_error *err)
{
    murk_sweep *sweep = r->sweep;
    memcpy(sweep->scene_sha256, scene->sha256, sizeof scene->sha256);
    sweep->seed = scene->seed;
    sweep->sees_in_the_dark = murk_sweep_needs_no_light(scene);
    r->has_outputs = true;
    murk_status status = check_plan(&sweep->desc, scene, err);
    if (!status) {
        status =
            murk_outputs_choose(&sweep->outputs, sweep->desc.study, scene, err);
    }
    /* A shard makes no plans for all rows. */
    const bool is_whole = sweep->desc.shard.count == 0;
    sweep->plan[MURK_SWEEP_MEAN].is_wanted =
        is_whole && sweep->outputs.wants[MURK_OUTPUT_ONE_MEAN];
    sweep->plan[MURK_SWEEP_WORST].is_wanted =
        is_whole && sweep->outputs.wants[MURK_OUTPUT_ONE_WORST];
    return status;
}

static murk_status read_row(reading *r, size_t i, murk_error *err)
{
    murk_sweep *sweep = r->sweep;
    const murk_sweep_desc *desc = &sweep->desc;
    murk_scene_desc *scene = NULL;
    murk_error why = {0};
    murk_status status = MURK_OK;
    /* The scene of the row; a failure fails this row alone. */
    if (murk_study_row_scene(&scene, desc->study, i, desc->overrides,
                             desc->n_overrides, &why)) {
        goto done;
    }
    /* The first scene that can be read decides which outputs there are. */
    if (!r->has_outputs) {
        status = read_first(r, scene, err);
    }
    if (!status) {
        murk_sweep_keys_of(&r->keys[i], &r->sums, scene, &sweep->outputs,
                           desc->version, &why);
    }
done:
    if (!status && why.code) {
        murk_study_row_fail(&sweep->row[i].found, &why);
        sweep->row[i].is_done = true;
        r->first = r->first.code ? r->first : why;
    }
    murk_scene_desc_destroy(scene);
    return status;
}

/* Fails if the command line sets a key (--set) that an axis of the study sets
 * as well: the value of the command line would be lost. */
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

/* If a plan for all rows is asked for, fails unless all rows have the same
 * sensors and placement: the plan needs one list of candidates. */
static murk_status check_placement(const reading *r, murk_error *err)
{
    const murk_sweep *sweep = r->sweep;
    const murk_study_file *study = sweep->desc.study;
    size_t first = study->rows;
    if (!murk_outputs_plan_for_all(&sweep->outputs)) {
        return MURK_OK;
    }
    for (size_t i = 0; i < study->rows; ++i) {
        if (sweep->row[i].is_done) { /* it has failed */
            continue;
        }
        first = first == study->rows ? i : first;
        if (strcmp(r->keys[i].placement, r->keys[first].placement) != 0) {
            return murk_fail(err, MURK_BAD_VALUE, study->outputs_where,
                             "one plan for all rows needs sensors and "
                             "placement to be the same in all, and those of "
                             "row %zu differ from those of row %zu",
                             i + 1, first + 1);
        }
    }
    return MURK_OK;
}

static murk_status read_rows(reading *r, murk_error *err)
{
    murk_sweep *sweep = r->sweep;
    const size_t rows = sweep->desc.study->rows;
    murk_status status = MURK_OK;
    murk_progress_begin_group("read", rows, "rows");
    for (size_t i = 0; i < rows && !status; ++i) {
        murk_progress_add_to_group(i > 0);
        status = murk_interrupt_check(err);
        status = status ? status : read_row(r, i, err);
    }
    murk_progress_end();
    if (!status && murk_sweep_done(sweep) == rows) {
        status =
            murk_fail(err, r->first.code, r->first.where, "%s", r->first.text);
    }
    if (!status) {
        status = check_placement(r, err);
    }
    if (!status) {
        status = murk_sweep_group_rows(sweep, r->keys, err);
    }
    return status;
}

murk_status murk_sweep_create(murk_sweep **out, const murk_sweep_desc *desc,
                              murk_error *err)
{
    /* Allocate the rows and their keys. */
    const size_t rows = desc->study->rows;
    murk_sweep *sweep = calloc(1, sizeof *sweep);
    reading r = {.sweep = sweep, .keys = calloc(rows, sizeof *r.keys)};
    if (sweep) {
        sweep->desc = *desc;
        sweep->row = calloc(rows, sizeof *sweep->row);
    }
    murk_status status =
        sweep && sweep->row && r.keys
            ? MURK_OK
            : murk_no_memory(err, desc->study->path, "for %zu rows",
                             desc->study->rows);
    /* Check the study and read the scenes of all rows. */
    if (!status) {
        status = check_overrides(desc, err);
    }
    if (!status) {
        status = read_rows(&r, err);
    }
    if (!status) {
        status = murk_sweep_check_folder(sweep, err);
    }
    /* Take over finished rows of parts, and of an earlier run. */
    if (!status && desc->shard.count) {
        status = murk_sweep_part_check(sweep, err);
    }
    if (!status) {
        status = murk_sweep_parts_read(sweep, err);
    }
    for (size_t i = 0; !status && desc->folder && i < rows; ++i) {
        if (!murk_sweep_owns(sweep, i)) {
            continue;
        }
        murk_sweep_load_row(sweep, i);
        if (!sweep->row[i].is_done || sweep->row[i].part) {
            status = murk_sweep_check_fluence(sweep, i, err);
        }
    }
    murk_file_sums_release(&r.sums);
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
        murk_study_row_release(&sweep->row[i].found);
    }
    for (size_t g = 0; g < sweep->groups; ++g) {
        free(sweep->group[g].row);
    }
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        murk_study_row_release(&sweep->plan[p].found);
    }
    free(sweep->found.text);
    free(sweep->group);
    free(sweep->row);
    free(sweep);
}
