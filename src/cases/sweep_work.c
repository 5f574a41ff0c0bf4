/* The work on one group of rows, in the process that the host chooses: imports
 * the scenes of the rows, traces the light, and measures and sends each row.
 * Warnings become notes of the row that they concern; those of the imports
 * become notes of all rows. */
#include "cases/sweep_work.h"

#include "base/log.h"
#include "base/progress.h"
#include "cases/sweep_coverage.h"
#include "cases/sweep_store.h"
#include "plan/plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The state of the work on one group. */
typedef struct group_work {
    const murk_sweep_job *job;
    murk_isolated *isolated;
    murk_sweep_light light;
    /* Warnings of the imports (of_world), those of building the first world
     * (of_first), and those that were not taken yet (warnings). */
    char of_world[MURK_ROW_TEXT_SIZE], of_first[MURK_ROW_TEXT_SIZE];
    char warnings[MURK_ROW_TEXT_SIZE];
    size_t done; /* rows of the study */
} group_work;

/* ---- warnings ---- */

/* A murk_log_sink. Warnings and notes count alike. */
static void add_warning(void *work, bool is_warning, const char *where,
                        const char *text)
{
    group_work *w = work;
    char line[MURK_ROW_TEXT_SIZE];
    (void)is_warning;
    snprintf(line, sizeof line, "%s: %s", where, text);
    if (!strstr(w->warnings, line)) {
        murk_study_add_note(w->warnings, line);
    }
}

static void take_warnings(group_work *w, char out[MURK_ROW_TEXT_SIZE])
{
    memcpy(out, w->warnings, sizeof w->warnings);
    w->warnings[0] = '\0';
}

/* ---- what a row measures ---- */

static void add_stored(murk_study_row *row, const murk_traced *traced)
{
    murk_estimate surface = {0, NAN}, volume = {0, NAN};
    if (traced) {
        surface.value = (double)murk_photon_map_count(traced->surface);
        volume.value = (double)murk_photon_map_count(traced->volume);
    }
    murk_study_row_add(row, "stored_surface", "", surface);
    murk_study_row_add(row, "stored_volume", "", volume);
}

/* Writes the grid of the fluence rate of a row, and stores the checksum of the
 * file in the row, because another study may write a file of the same name. */
static murk_status write_fluence(const group_work *w, size_t k,
                                 murk_study_row *row,
                                 const murk_row_light *light, murk_error *err)
{
    const murk_sweep_light *l = &w->light;
    char path[MURK_SWEEP_PATH_SIZE];
    murk_status status =
        murk_sweep_fluence_path(path, l->sweep, l->group->row[k], err);
    if (!status) {
        status = murk_row_tallies_write_fluence(path, &l->row_tallies,
                                                l->scene[k], light, err);
    }
    return status ? status : murk_sweep_sum(row->fluence, path, err);
}

static murk_status measure_light(const group_work *w, size_t k,
                                 murk_study_row *row, const murk_traced *traced,
                                 murk_error *err)
{
    const murk_sweep_light *l = &w->light;
    const bool *wants = l->sweep->outputs.wants;
    murk_row_light light = {0};
    if (traced) {
        row->emitted = traced->emitted;
        light =
            (murk_row_light){l->traced[0]->tallies,
                             l->traced[0]->ledger->emitted, traced->packet_w};
    }
    murk_status status = murk_row_tallies_read(
        row, &l->row_tallies, l->stage[k], &light, l->sweep->desc.threads, err);
    if (!status && wants[MURK_OUTPUT_STORED]) {
        add_stored(row, traced);
    }
    if (!status && wants[MURK_OUTPUT_FLUENCE]) {
        status = write_fluence(w, k, row, &light, err);
    }
    return status;
}

static murk_status measure_row(group_work *w, size_t k, murk_study_row *row,
                               murk_error *err)
{
    murk_sweep_light *l = &w->light;
    murk_traced *traced = NULL;
    bool is_own = false;
    const bool shines = murk_sweep_light_shines(l, k);
    murk_status status = MURK_OK;
    murk_study_add_note(row->note, l->row_tallies.note);
    if (shines) {
        status = murk_sweep_light_of(l, k, 0, &traced, &is_own, err);
    } else {
        murk_study_add_note(row->note, "dark: no light shines");
    }
    if (!status) {
        status = measure_light(w, k, row, traced, err);
    }
    if (!status && !shines && murk_sweep_can_see(l, k)) { /* targets */
        is_own = true;
        status = murk_plan_trace_stream(&traced, l->stage[k], 0,
                                        l->sweep->desc.threads, err);
    }
    if (!status) {
        status = murk_sweep_measure_coverage(l, k, row, traced, err);
    }
    if (is_own) {
        murk_traced_destroy(traced);
    }
    return status;
}

/* Measures the coverage of the plans for all rows in one row. */
static murk_status measure_plans(group_work *w, size_t k, murk_study_row *row,
                                 murk_error *err)
{
    murk_sweep_light *l = &w->light;
    murk_status status = MURK_OK;
    for (int p = 0; p < MURK_SWEEP_PLANS && !status; ++p) {
        const murk_sweep_plan *plan = &l->sweep->plan[p];
        murk_estimate value = {NAN, NAN};
        murk_pose *sensor = NULL;
        if (!murk_sweep_plan_stands(plan)) {
            continue;
        }
        status = murk_study_row_poses(&sensor, &plan->found, l->scene[k], err);
        if (!status && murk_sweep_can_see(l, k)) {
            status = murk_sweep_measure(l, k, sensor, plan->found.sensors,
                                        &value, err);
        }
        if (!status) {
            murk_study_row_add(row, murk_sweep_plan_name(p), "", value);
        }
        free(sensor);
    }
    return status;
}

/* ---- rows ---- */

static murk_status send_row(const group_work *w, size_t k,
                            const murk_study_row *row, murk_error *err)
{
    return murk_sweep_send(w->isolated, w->light.group->row[k], row, err);
}

static murk_status send_failure(const group_work *w, size_t k,
                                const murk_error *why, murk_error *err)
{
    murk_study_row row = {0};
    murk_study_row_fail(&row, why);
    return send_row(w, k, &row, err);
}

/* Builds what is imported, measures and sends. */
static murk_status do_row(group_work *w, size_t k, murk_error *err)
{
    murk_sweep_light *l = &w->light;
    murk_study_row row = {0};
    murk_error why = {0};
    char own[MURK_ROW_TEXT_SIZE];
    murk_progress_part(l->group->row[k] + 1, l->sweep->desc.study->rows,
                       w->done++);
    /* Build and measure; a failure is a row that has failed. */
    murk_status status = murk_sweep_light_build(l, k, &why);
    if (!status) {
        status = w->job->work == MURK_SWEEP_MEASURE
                     ? measure_plans(w, k, &row, &why)
                     : measure_row(w, k, &row, &why);
    }
    if (status || murk_study_row_check(&row, &why)) {
        murk_study_row_fail(&row, &why);
    }
    /* Warnings of the import, of the first world and of the row. */
    murk_study_add_note(row.note, w->of_world);
    murk_study_add_note(row.note, l->stage[k] == l->first ? w->of_first : "");
    take_warnings(w, own);
    murk_study_add_note(row.note, own);
    status = send_row(w, k, &row, err);
    if (murk_isolated_is_subprocess(w->isolated)) { /* the caller counts */
        murk_progress_add_to_group(1);
    }
    murk_study_row_release(&row);
    murk_sweep_light_drop(l, k);
    return status;
}

/* ---- the group ---- */

static murk_status import_wanted(group_work *w, murk_error *err)
{
    murk_status status = murk_sweep_light_import(&w->light, w->job, err);
    for (size_t k = 0; k < w->job->group->n && !status; ++k) {
        if (w->light.why[k].code) {
            status = send_failure(w, k, &w->light.why[k], err);
        }
    }
    return status;
}

/* Prepares the light of the group. If that fails, all imported rows of the
 * group have failed. */
static murk_status light_up(group_work *w, murk_error *err)
{
    murk_sweep_light *l = &w->light;
    murk_error why = {0};
    murk_status status = MURK_OK;
    if (!murk_sweep_light_prepare(l, w->job->work == MURK_SWEEP_RUN, &why)) {
        return MURK_OK;
    }
    for (size_t k = 0; k < l->n && !status; ++k) {
        if (murk_sweep_light_has(l, k)) {
            status = send_failure(w, k, &why, err);
        }
    }
    l->first = NULL;
    return status;
}

murk_status murk_sweep_work(murk_isolated *isolated, void *context,
                            murk_error *err)
{
    const murk_sweep_job *job = context;
    group_work w = {
        .job = job, .isolated = isolated, .done = murk_sweep_done(job->sweep)};
    murk_sweep_light *l = &w.light;
    murk_log_to(add_warning, &w);
    murk_status status = import_wanted(&w, err);
    take_warnings(&w, w.of_world);
    if (!status) {
        status = light_up(&w, err);
    }
    take_warnings(&w, w.of_first);
    for (size_t k = 0; l->first && k < l->n && !status; ++k) {
        if (murk_sweep_light_has(l, k)) {
            status = do_row(&w, k, err);
        }
    }
    murk_sweep_light_release(l);
    return status;
}
