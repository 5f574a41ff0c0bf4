#include "study/sweep_work.h"

#include "base/log.h"
#include "base/progress.h"
#include "study/gauges.h"
#include "study/machine.h"
#include "study/placement_in.h"
#include "study/plan.h"
#include "study/relight.h"
#include "study/tallies.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STREAMS 2u /* the light that chooses, and the held out */

/* A group under way. */
typedef struct group_work {
    const murk_sweep_job *job;
    murk_apart *apart;
    unsigned threads;
    size_t n;
    murk_scene **scene;      /* [n] all of the group's, done or not */
    murk_stage **stage;      /* [n] NULL where the row is done, or failed */
    double **power_w;        /* [n][channels] */
    const murk_stage *first; /* built: its world is everyone's */
    murk_gauges gauges;
    /* The light of all: traced on `first` with these lights. */
    murk_lights *lights; /* NULL: all rows have the same light, their own */
    murk_scene lit_scene;
    murk_stage lit_stage;
    murk_traced *traced[STREAMS];
    /* Warnings of the imports, and of building `first`. */
    char of_world[MURK_ROW_TEXT_SIZE], of_first[MURK_ROW_TEXT_SIZE];
} group_work;

/* ---- warnings ---- */

/* Warnings are the row's: the sink of base/log.h knows of nobody else. */
static char heard[MURK_ROW_TEXT_SIZE];

static void hear(const char *where, const char *text)
{
    char line[MURK_ROW_TEXT_SIZE];
    snprintf(line, sizeof line, "%s: %s", where, text);
    const size_t n = strlen(heard);
    if (!strstr(heard, line)) {
        snprintf(heard + n, sizeof heard - n, "%s%.1000s", n ? "; " : "", line);
    }
}

static void take_heard(char out[MURK_ROW_TEXT_SIZE])
{
    memcpy(out, heard, sizeof heard);
    heard[0] = '\0';
}

static void add_note(murk_row *row, const char *text)
{
    const size_t n = strlen(row->note);
    if (text[0]) {
        snprintf(row->note + n, sizeof row->note - n, "%s%s", n ? "; " : "",
                 text);
    }
}

/* ---- light of the group ---- */

static bool all_alike(const group_work *w, size_t channels)
{
    for (size_t k = 1; k < w->n; ++k) {
        if (memcmp(w->power_w[0], w->power_w[k],
                   channels * sizeof **w->power_w) != 0) {
            return false;
        }
    }
    return true;
}

static bool is_lit(const group_work *w, size_t k)
{
    const murk_scene *scene = w->scene[k];
    for (size_t c = 0; c < scene->n_lights * (size_t)scene->bands; ++c) {
        if (w->power_w[k][c] > 0) {
            return true;
        }
    }
    return false;
}

static uint64_t grown(uint64_t photons, double grow)
{
    const double n = floor((double)photons * grow + .5);
    return n < 4294967295. ? (uint64_t)n : 4294967295u;
}

/* What is traced: the first stage under the group's lights, with tallies for
 * what is measured. */
static murk_status prepare_light(group_work *w, murk_error *err)
{
    const murk_domain *domain = &w->first->world.domain;
    const murk_scene *scene = w->first->scene;
    const size_t channels = scene->n_lights * (size_t)scene->bands;
    double grow = 1;
    bool any = false;
    murk_status status = MURK_OK;
    for (size_t k = 0; k < w->n && !status; ++k) {
        status = murk_relight_powers(&w->power_w[k], w->scene[k], domain, err);
        any |= !status && is_lit(w, k);
    }
    if (!status && any && !all_alike(w, channels)) {
        status = murk_relight_lights(
            &w->lights, &grow, (const murk_scene *const *)w->scene,
            (double *const *)w->power_w, w->n, domain, err);
    }
    if (!status) {
        status = murk_gauges_create(&w->gauges, w->first,
                                    &w->job->sweep->outputs, err);
    }
    w->lit_scene = *scene;
    w->lit_scene.n_tallies = w->gauges.n;
    w->lit_scene.photons.emit = grown(scene->photons.emit, grow);
    w->lit_scene.photons.store = grown(scene->photons.store, grow);
    w->lit_stage = *w->first;
    w->lit_stage.scene = &w->lit_scene;
    w->lit_stage.tally = w->gauges.n > 0 ? w->gauges.desc : NULL;
    if (w->lights) {
        w->lit_stage.lights = w->lights;
        w->lit_stage.world.lights = w->lights;
    }
    return status;
}

/* The row's light of a stream; *is_own: for murk_traced_destroy(). */
static murk_status light_of(group_work *w, size_t k, uint32_t stream,
                            murk_traced **out, bool *is_own, murk_error *err)
{
    murk_status status = MURK_OK;
    *is_own = w->lights != NULL;
    if (!w->traced[stream]) {
        status = murk_light_trace(&w->traced[stream], &w->lit_stage, stream,
                                  w->threads, err);
    }
    if (!status && !w->lights) {
        *out = w->traced[stream];
    } else if (!status) {
        status = murk_relight(out, w->traced[stream], w->lights, w->power_w[k],
                              w->scene[k]->bands, w->threads, err);
    }
    return status;
}

/* ---- coverage ---- */

static murk_status add_coverage(murk_row *row, const char *name,
                                murk_estimate of, murk_error *err)
{
    return murk_row_add(row, name, "", of, err);
}

static murk_status no_coverage(murk_row *row, const murk_outputs *outputs,
                               murk_error *err)
{
    const murk_estimate none = {NAN, NAN};
    murk_status status = MURK_OK;
    if (outputs->wants[MURK_OUTPUT_FIXED]) {
        status = add_coverage(row, "coverage_fixed", none, err);
    }
    if (!status && outputs->wants[MURK_OUTPUT_BEST]) {
        status = add_coverage(row, "coverage_best", none, err);
    }
    return status;
}

static murk_status measure_fixed(const group_work *w, size_t k, murk_row *row,
                                 murk_sight *sight, murk_error *err)
{
    const murk_stage *stage = w->stage[k];
    murk_pose *sensor = NULL;
    murk_coverage coverage = {0};
    size_t n = 0;
    murk_status status =
        murk_placement_read(&sensor, &n, w->job->sweep->desc.study->plan, 1,
                            stage->scene, &stage->world.domain, err);
    if (!status) {
        status = murk_coverage_measure(&coverage, sight, sensor, n, err);
    }
    if (!status) {
        status = add_coverage(row, "coverage_fixed", coverage.total, err);
    }
    murk_coverage_release(&coverage);
    free(sensor);
    return status;
}

/* On light that did not choose. */
static murk_status measure_held_out(group_work *w, size_t k,
                                    const murk_plan *plan, murk_estimate *out,
                                    murk_error *err)
{
    const murk_stage *stage = w->stage[k];
    const murk_scene_placement *wish = &stage->scene->placement;
    const bool is_lit_anew =
        !wish->targets.given || wish->detection == MURK_SCENE_POWER;
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    murk_coverage coverage = {0};
    bool is_own = true;
    murk_status status =
        is_lit_anew
            ? light_of(w, k, MURK_HELD_OUT_STREAM, &traced, &is_own, err)
            : murk_plan_see_anew(&traced, stage, MURK_HELD_OUT_STREAM,
                                 w->threads, err);
    if (!status) {
        status = murk_plan_sight(&sight, stage, traced, w->threads, err);
    }
    if (!status) {
        status = murk_coverage_measure(&coverage, sight, plan->sensor,
                                       plan->place.count, err);
    }
    *out = coverage.total;
    murk_coverage_release(&coverage);
    murk_sight_destroy(sight);
    if (is_own) {
        murk_traced_destroy(traced);
    }
    return status;
}

static murk_status measure_best(group_work *w, size_t k, murk_row *row,
                                murk_sight *sight, murk_error *err)
{
    const murk_stage *stage = w->stage[k];
    murk_plan plan = {.without_curve = true};
    murk_coverage coverage = {0};
    murk_estimate value = {NAN, NAN};
    murk_status status = murk_plan_prepare(&plan, stage, w->threads, err);
    if (!status) {
        status = murk_plan_choose(&plan, stage, sight, err);
    }
    if (!status) {
        status = murk_row_set_sensors(row, stage->scene, plan.sensor,
                                      plan.place.count, err);
    }
    const bool holds_out = stage->scene->placement.hold_out &&
                           murk_plan_can_see_anew(stage->scene);
    if (!status && holds_out) {
        status = measure_held_out(w, k, &plan, &value, err);
    } else if (!status) {
        status = murk_coverage_measure(&coverage, sight, plan.sensor,
                                       plan.place.count, err);
        value = coverage.total;
    }
    if (!status) {
        status = add_coverage(row, "coverage_best", value, err);
    }
    murk_coverage_release(&coverage);
    murk_plan_release(&plan);
    return status;
}

static murk_status measure_coverage(group_work *w, size_t k, murk_row *row,
                                    const murk_traced *traced, murk_error *err)
{
    const murk_stage *stage = w->stage[k];
    const murk_outputs *outputs = &w->job->sweep->outputs;
    const bool has_photons = murk_photon_map_count(traced->surface) +
                                 murk_photon_map_count(traced->volume) >
                             0;
    murk_sight *sight = NULL;
    if (!has_photons && !stage->scene->placement.targets.given) {
        add_note(row, "no photon is stored: nothing to cover");
        return no_coverage(row, outputs, err);
    }
    murk_status status =
        murk_plan_sight(&sight, stage, traced, w->threads, err);
    if (!status && outputs->wants[MURK_OUTPUT_FIXED]) {
        status = measure_fixed(w, k, row, sight, err);
    }
    if (!status && outputs->wants[MURK_OUTPUT_BEST]) {
        status = measure_best(w, k, row, sight, err);
    }
    murk_sight_destroy(sight);
    return status;
}

/* ---- rows ---- */

static murk_status add_stored(murk_row *row, const murk_traced *traced,
                              murk_error *err)
{
    const murk_estimate surface = {
        traced ? (double)murk_photon_map_count(traced->surface) : 0, NAN};
    const murk_estimate volume = {
        traced ? (double)murk_photon_map_count(traced->volume) : 0, NAN};
    murk_status status = murk_row_add(row, "stored_surface", "", surface, err);
    return status ? status
                  : murk_row_add(row, "stored_volume", "", volume, err);
}

void murk_sweep_fluence_name(char out[MURK_SWEEP_NAME_SIZE], size_t row)
{
    snprintf(out, MURK_SWEEP_NAME_SIZE, "fluence_%04zu.vdb", row + 1);
}

static murk_status write_fluence(const group_work *w, size_t k,
                                 const murk_tallies *tallies,
                                 const murk_traced *traced, murk_error *err)
{
    const murk_sweep *sweep = w->job->sweep;
    char name[MURK_SWEEP_NAME_SIZE], path[4096];
    murk_sweep_fluence_name(name, w->job->group->row[k]);
    if (snprintf(path, sizeof path, "%s/%s", sweep->desc.folder, name) >=
        (int)sizeof path) {
        return murk_fail(err, MURK_BAD_VALUE, sweep->desc.folder,
                         "too long a path");
    }
    return murk_gauges_write_fluence(path, &w->gauges, w->scene[k], tallies,
                                     traced ? w->traced[0]->ledger->emitted
                                            : NULL,
                                     traced ? traced->packet_w : NULL, err);
}

static murk_status measure_row(group_work *w, size_t k, murk_row *row,
                               murk_error *err)
{
    const murk_outputs *outputs = &w->job->sweep->outputs;
    murk_traced *traced = NULL;
    bool is_own = false;
    murk_status status = MURK_OK;
    add_note(row, w->gauges.note);
    if (is_lit(w, k)) {
        status = light_of(w, k, 0, &traced, &is_own, err);
    } else {
        add_note(row, "dark: no light shines");
    }
    const murk_tallies *tallies =
        !status && traced ? w->traced[0]->tallies : NULL;
    if (!status) {
        row->emitted = traced ? traced->emitted : 0;
        status =
            murk_gauges_read(row, &w->gauges, w->stage[k], tallies,
                             traced ? w->traced[0]->ledger->emitted : NULL,
                             traced ? traced->packet_w : NULL, w->threads, err);
    }
    if (!status && outputs->wants[MURK_OUTPUT_STORED]) {
        status = add_stored(row, traced, err);
    }
    if (!status && outputs->wants[MURK_OUTPUT_FLUENCE]) {
        status = write_fluence(w, k, tallies, traced, err);
    }
    if (!status && murk_outputs_look(outputs)) {
        status = traced ? measure_coverage(w, k, row, traced, err)
                        : no_coverage(row, outputs, err);
    }
    if (is_own) {
        murk_traced_destroy(traced);
    }
    return status;
}

static murk_status send_row(const group_work *w, size_t k, const murk_row *row,
                            murk_error *err)
{
    char *text = murk_row_print(row), *message = NULL;
    const size_t size = text ? strlen(text) + 32 : 0;
    murk_status status = MURK_OK;
    if (text) {
        message = malloc(size);
    }
    if (!message) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for a row");
    } else {
        const int n =
            snprintf(message, size, "%zu\n%s", w->job->group->row[k], text);
        status = murk_apart_send(w->apart, message, (size_t)n, err);
    }
    free(message);
    free(text);
    return status;
}

static void tell_failure(murk_row *row, const murk_error *why)
{
    snprintf(row->failed, sizeof row->failed, "%s%s%s", why->where,
             why->where[0] ? ": " : "", why->text);
}

static murk_status send_failure(const group_work *w, size_t k,
                                const murk_error *why, murk_error *err)
{
    murk_row row = {0};
    tell_failure(&row, why);
    return send_row(w, k, &row, err);
}

static bool is_done(const group_work *w, size_t k)
{
    return w->job->sweep->row[w->job->group->row[k]].is_done;
}

/* Builds what is imported, measures and sends. */
static murk_status do_row(group_work *w, size_t k, murk_error *err)
{
    murk_row row = {0};
    murk_error why = {0};
    murk_status status = MURK_OK;
    char own[MURK_ROW_TEXT_SIZE];
    murk_progress_part(w->job->group->row[k] + 1,
                       w->job->sweep->desc.study->rows);
    if (w->stage[k] != w->first) {
        status = murk_stage_build(w->stage[k], &why);
    }
    if (!status) {
        status = measure_row(w, k, &row, &why);
    }
    if (status) {
        tell_failure(&row, &why);
    }
    add_note(&row, w->of_world);
    add_note(&row, w->stage[k] == w->first ? w->of_first : "");
    take_heard(own);
    add_note(&row, own);
    status = send_row(w, k, &row, err);
    murk_row_release(&row);
    if (w->stage[k] != w->first) {
        murk_stage_destroy(w->stage[k]);
        w->stage[k] = NULL;
    }
    return status;
}

/* ---- the group ---- */

static murk_status make_room(group_work *w, murk_error *err)
{
    w->n = w->job->group->n;
    w->scene = calloc(w->n, sizeof *w->scene);
    w->stage = calloc(w->n, sizeof *w->stage);
    w->power_w = calloc(w->n, sizeof *w->power_w);
    return w->scene && w->stage && w->power_w
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, "", "no memory for rows");
}

/* The scenes of all rows, and the imports of those not done: before any ray
 * device. */
static murk_status import_all(group_work *w, murk_error *err)
{
    const murk_sweep_desc *desc = &w->job->sweep->desc;
    const murk_stage *other = NULL;
    murk_status status = MURK_OK;
    for (size_t k = 0; k < w->n && !status; ++k) {
        status = murk_study_row_scene(&w->scene[k], desc->study,
                                      w->job->group->row[k], desc->overrides,
                                      desc->n_overrides, err);
        if (status || is_done(w, k)) {
            continue;
        }
        murk_error why = {0};
        if (other ? murk_stage_import_beside(&w->stage[k], w->scene[k], other,
                                             &why)
                  : murk_stage_import(&w->stage[k], w->scene[k], &why)) {
            w->stage[k] = NULL;
            status = send_failure(w, k, &why, err);
        } else if (!other) {
            other = w->stage[k];
        }
    }
    return status;
}

static void release(group_work *w)
{
    for (uint32_t s = 0; s < STREAMS; ++s) {
        murk_traced_destroy(w->traced[s]);
    }
    murk_gauges_release(&w->gauges);
    murk_lights_destroy(w->lights);
    for (size_t k = w->n; k-- > 0;) { /* those that borrow come later */
        murk_stage_destroy(w->stage ? w->stage[k] : NULL);
        murk_scene_destroy(w->scene ? w->scene[k] : NULL);
        free(w->power_w ? w->power_w[k] : NULL);
    }
    free(w->scene);
    free(w->stage);
    free(w->power_w);
}

/* The first one that was imported carries the light; where it cannot be built
 * or lit, no row of the group can. */
static murk_status light_up(group_work *w, murk_error *err)
{
    size_t k = 0;
    while (k < w->n && !w->stage[k]) {
        ++k;
    }
    if (k == w->n) {
        return MURK_OK;
    }
    murk_error why = {0};
    murk_status status = murk_stage_build(w->stage[k], &why);
    w->first = w->stage[k];
    if (!status) {
        status = prepare_light(w, &why);
    }
    if (!status) {
        return MURK_OK;
    }
    status = MURK_OK;
    for (; k < w->n && !status; ++k) {
        if (w->stage[k]) {
            status = send_failure(w, k, &why, err);
        }
    }
    w->first = NULL;
    return status;
}

murk_status murk_sweep_work(murk_apart *apart, void *context, murk_error *err)
{
    const murk_sweep_job *job = context;
    group_work w = {
        .job = job, .apart = apart, .threads = job->sweep->desc.threads};
    murk_warn_to(hear);
    murk_status status = make_room(&w, err);
    if (!status) {
        status = import_all(&w, err);
    }
    take_heard(w.of_world);
    if (!status) {
        status = light_up(&w, err);
    }
    take_heard(w.of_first);
    for (size_t k = 0; w.first && k < w.n && !status; ++k) {
        if (w.stage[k]) {
            status = do_row(&w, k, err);
        }
    }
    release(&w);
    return status;
}
