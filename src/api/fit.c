/* Fits: the parameters of a scene are calibrated to the readings of a file, or
 * the readings are predicted: at the values of the scene, or of a finished fit.
 */
#include "api/fit_values.h"
#include "api/save.h"
#include "api/scene.h"

#include "base/progress.h"
#include "calibrate/calibrate.h"
#include "calibrate/covered.h"
#include "calibrate/loss.h"
#include "calibrate/proposals.h"
#include "results/fit.h"
#include "world/stage_build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The name of the file in memory (base/memory_files.h) with the text of the
 * scene. The scene is read again for other values of the parameters: from this
 * file, unless murk_scene_read() has read the scene from a file on disk. */
#define SCENE_TEXT "murk-scene"

struct murk_fit {
    murk_scene *scene;
    murk_calibration_desc desired; /* loss, starts, limits */
    size_t wanted_places;          /* proposals; 0: none */
    bool only_predicts;            /* no search */
    char *predict;           /* path of a finished fit, at whose values the
                              * readings are predicted; NULL: none */
    murk_memory_files files; /* of the scene when the fit was made, and
                              * SCENE_TEXT */
    murk_held_arrays held;
    murk_session session;          /* owns the scene and the stage of the fit */
    murk_imported_stages imported; /* session.stage borrows from these stages */
    murk_readings *measured;
    char **text; /* [texts] copies of keys and bounds */
    size_t texts;
    murk_fit_values values; /* of the finished fit `predict`; else empty */
    murk_free_keys *keys;
    murk_calibration found;
    bool has_run;
    murk_proposals next;
    murk_fields fields, saved;
};

/* ---- options ---- */

static murk_status take_options(murk_fit *f, const murk_fit_options *options,
                                murk_error *err)
{
    f->desired.starts = (size_t)options->starts;
    f->desired.traces_max = (size_t)options->traces;
    f->wanted_places = (size_t)options->next;
    if (options->predict) {
        f->predict = strdup(options->predict);
        if (!f->predict) {
            return murk_no_memory(err, options->predict, "for the fit");
        }
    }
    return options->loss
               ? murk_loss_read(&f->desired.loss, &f->desired.loss_width,
                                options->loss, err)
               : MURK_OK;
}

/* ---- reading ---- */

/* Reads the scene, imports the files of the scene and of all its conditions,
 * and then builds the world of the scene without a condition. */
static murk_status build(murk_fit *f, murk_error *err)
{
    murk_session *session = &f->session;
    session->begun_s = murk_clock_s();
    murk_progress_begin_group("build", 0, "");
    murk_status status = murk_scene_describe(&session->scene, f->scene, err);
    if (!status) {
        murk_scene_tell(session->scene);
        status = murk_imported_stages_import(&f->imported, session->scene, err);
    }
    if (!status) {
        status = murk_stage_import_beside(&session->stage, session->scene,
                                          f->imported.stage[0], err);
    }
    if (!status) {
        status = murk_stage_build(session->stage, err);
    }
    murk_progress_end();
    session->run.load_s = murk_clock_s() - session->begun_s;
    return status;
}

/* Checks before light is traced that the scene allows readings of coverage, if
 * the data have any, and proposals of further readings, if any are wanted. */
static murk_status check_before_trace(const murk_fit *f, murk_error *err)
{
    const murk_readings *m = f->measured;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < m->readings && !status; ++i) {
        if (m->reading[i].kind == MURK_READ_COVERAGE) {
            status = murk_covered_check(f->session.scene, err);
        }
    }
    return !status && f->wanted_places > 0
               ? murk_proposals_check(m, f->session.scene, err)
               : status;
}

/* Reads the readings, then finds the free keys with their bounds and starts. To
 * predict at the values of a finished fit, reads that fit before, which gives
 * the free keys and the values at which they start. */
static murk_status read_input(murk_fit *f, const char *data,
                              const char *const *keys, size_t n,
                              const murk_fit_options *options, murk_error *err)
{
    const murk_domain *domain = &f->session.stage->world.domain;
    murk_status status = f->predict
                             ? murk_fit_values_read(&f->values, f->predict, err)
                             : MURK_OK;
    if (!status) {
        status = murk_readings_read(&f->measured, data, f->session.scene,
                                    domain, err);
    }
    if (status) {
        return status;
    }
    murk_free_desc desc = {.scene_path = f->scene->is_file
                                             ? f->scene->name
                                             : MURK_MEMORY_PREFIX SCENE_TEXT,
                           .overrides = f->scene->set,
                           .n_overrides = f->scene->n,
                           .asked = (const char *const *)f->values.asked,
                           .n_asked = f->values.n,
                           .n_bounds = options->n_bounds,
                           .may_be_none = f->only_predicts,
                           .measured = f->measured,
                           .domain = domain,
                           .imported = &f->imported};
    /* One list of texts: the bounds, then the keys. */
    char **all = calloc(options->n_bounds + n + 1, sizeof *all);
    f->text = all;
    for (size_t i = 0; all && i < options->n_bounds + n; ++i) {
        all[i] = strdup(i < options->n_bounds ? options->bounds[i]
                                              : keys[i - options->n_bounds]);
        f->texts += all[i] != NULL;
    }
    if (f->texts < options->n_bounds + n) {
        return murk_no_memory(err, "", "for the fit");
    }
    desc.bounds = (const char *const *)f->text;
    if (!f->predict) {
        desc.asked = desc.bounds + options->n_bounds;
        desc.n_asked = n;
    }
    status = murk_free_keys_create(&f->keys, &desc, err);
    if (!status && f->predict) {
        status = murk_fit_values_set(&f->values, f->keys, err);
    }
    return status ? status : check_before_trace(f, err);
}

/* Fills f->files with the files in memory of the scene, and adds the text of
 * the scene as the file SCENE_TEXT. */
static murk_status keep_files(murk_fit *f, murk_error *err)
{
    char *text = strdup(f->scene->text);
    if (!text || !murk_memory_copy(&f->files, &f->scene->files)) {
        free(text);
        return murk_no_memory(err, f->scene->name, "for the fit");
    }
    const murk_memory_file file = {
        .kind = MURK_MEMORY_TABLE, .data = text, .release = free};
    return murk_memory_add(&f->files, SCENE_TEXT, file, err);
}

static murk_status make(murk_fit *f, murk_scene *scene, const char *data,
                        const char *const *keys, size_t n,
                        const murk_fit_options *given, murk_call *call)
{
    f->scene = scene;
    ++scene->references;
    murk_fit_options options = {0};
    const unsigned threads = f->scene->context->threads;
    f->session =
        (murk_session){.settings.threads = threads, .run.threads = threads};
    /* Check the options and the list of keys, which needs no scene. */
    murk_status status =
        murk_options_copy(&options, sizeof options, given, "options",
                          "murk_fit_options", &call->failure);
    if (!status) {
        status = murk_call_check_texts(&call->failure, "keys", keys, n);
    }
    if (!status) {
        status = murk_call_check_texts(&call->failure, "options->bounds",
                                       options.bounds, options.n_bounds);
    }
    if (!status) {
        status = take_options(f, &options, &call->failure);
    }
    if (!status && f->predict && n > 0) {
        status = murk_fail(&call->failure, MURK_BAD_VALUE, "predict",
                           "fits nothing, so it does not go with free keys");
    }
    f->only_predicts = f->predict || n == 0;
    if (!status && f->only_predicts && f->wanted_places > 0) {
        status = murk_fail(&call->failure, MURK_BAD_VALUE, "next",
                           "proposes places for a fit, and without free keys "
                           "nothing is fitted");
    }
    /* Read and build the scene, then read the input of the fit. */
    if (!status) {
        status = keep_files(f, &call->failure);
        call->host->files = &f->files;
    }
    if (!status) {
        status = build(f, &call->failure);
    }
    return status ? status
                  : read_input(f, data, keys, n, &options, &call->failure);
}

murk_status murk_fit_create(murk_fit **out, murk_scene *scene, const char *data,
                            const char *const *keys, size_t n,
                            const murk_fit_options *options, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !scene || !data) {
        return murk_call_refuse(error, "out, scene or data is NULL");
    }
    murk_fit *f = calloc(1, sizeof *f);
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    murk_status status = MURK_NO_MEMORY;
    if (f) {
        status = make(f, scene, data, keys, n, options, &call);
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_fit_destroy(f);
        return status;
    }
    /* Pages of its results show the arrays of the scene. */
    murk_context_hold_arrays(f->scene->context, &f->held, &f->files,
                             f->session.scene);
    *out = f;
    return MURK_OK;
}

void murk_fit_destroy(murk_fit *f)
{
    if (!f) {
        return;
    }
    murk_context_forget_arrays(f->scene->context, &f->held);
    murk_fields_release(&f->fields);
    murk_fields_release(&f->saved);
    murk_proposals_release(&f->next);
    murk_calibration_release(&f->found);
    murk_free_keys_destroy(f->keys);
    murk_fit_values_release(&f->values);
    for (size_t i = 0; i < f->texts; ++i) {
        free(f->text[i]);
    }
    free(f->text);
    free(f->predict);
    murk_readings_destroy(f->measured);
    murk_stage_destroy(f->session.stage); /* borrows of the imported stages */
    f->session.stage = NULL;
    murk_imported_stages_release(&f->imported);
    murk_session_end(&f->session);
    murk_memory_release(&f->files);
    murk_scene_release(f->scene);
    free(f);
}

/* ---- running ---- */

static void tell_step(void *context, size_t start, size_t traces, int iteration,
                      double chi2, const double *value)
{
    (void)context;
    (void)value;
    murk_progress_add_to_group(1);
    murk_progress_text("start %zu, light %zu, step %d: chi2 %.6g", start + 1,
                       traces, iteration, chi2);
}

static void tell_memory(void *context, double bytes, double have_bytes)
{
    (void)context;
    if (isfinite(have_bytes)) { /* what is free is known */
        murk_progress_text("takes about %.2g GB of %.3g GB free", bytes / 1e9,
                           have_bytes / 1e9);
    } else {
        murk_progress_text("takes about %.2g GB", bytes / 1e9);
    }
}

static murk_calibration_desc desc_of(const murk_fit *f)
{
    murk_calibration_desc desc = f->desired;
    desc.keys = f->keys;
    desc.measured = f->measured;
    desc.imported = &f->imported;
    desc.threads = f->scene->context->threads;
    desc.seed = f->session.scene->seed;
    desc.only_predicts = f->only_predicts;
    desc.watch = tell_step;
    desc.forecast = tell_memory;
    desc.scene = f->session.scene;
    return desc;
}

/* Fits, or predicts; then proposes places for further readings, if any are
 * wanted. path[n]: parts of the fit. */
static murk_status run(murk_fit *f, const char *const *path, size_t n,
                       murk_error *err)
{
    murk_calibration_desc desc = desc_of(f);
    desc.part = path;
    desc.parts = n;
    murk_progress_begin_group("fit", 0, "steps");
    murk_status status = murk_calibrate(&f->found, &desc, err);
    murk_progress_end();
    if (!status && f->wanted_places > 0) {
        murk_progress_begin_group("next", 0, "");
        status = murk_proposals_create(&f->next, f->wanted_places, &f->found,
                                       &desc, err);
        murk_progress_end();
    }
    f->session.run.trace_s = f->found.trace_s;
    f->has_run = !status;
    return status;
}

static murk_status run_fit(murk_fit *f, const char *const *path, size_t n,
                           murk_error *error)
{
    murk_proposals_release(&f->next);
    murk_calibration_release(&f->found);
    f->found = (murk_calibration){0};
    murk_call call = murk_call_begin(f->scene->context, &f->files, error);
    return murk_call_end_long(&call, run(f, path, n, &call.failure));
}

murk_status murk_fit_run(murk_fit *f, murk_error *error)
{
    return f && !f->has_run
               ? run_fit(f, NULL, 0, error)
               : murk_call_refuse(error, "fit is NULL, or has run");
}

murk_status murk_fit_merge(murk_fit *f, const char *const *path, size_t n,
                           murk_error *error)
{
    bool has_paths = path && n > 0;
    for (size_t i = 0; has_paths && i < n; ++i) {
        has_paths = path[i] != NULL;
    }
    return f && !f->has_run && !f->only_predicts && has_paths
               ? run_fit(f, path, n, error)
               : murk_call_refuse(error, "fit or a path is NULL, or the fit "
                                         "has run, or predicts");
}

murk_status murk_fit_run_part(murk_fit *f, uint32_t number, uint32_t count,
                              const char *path, murk_error *error)
{
    if (!f || !path) {
        return murk_call_refuse(error, "fit or path is NULL");
    }
    murk_calibration_desc desc = desc_of(f);
    desc.shard = (murk_shard){number, count};
    murk_call call = murk_call_begin(f->scene->context, &f->files, error);
    murk_progress_begin_group("fit", 0, "steps");
    const murk_status status = murk_calibrate_part(&desc, path, &call.failure);
    murk_progress_end();
    return murk_call_end_long(&call, status);
}

static murk_fit_facts facts_of(const murk_fit *f)
{
    return (murk_fit_facts){.scene = f->session.scene,
                            .keys = f->keys,
                            .measured = f->measured,
                            .found = &f->found,
                            .next = f->next.place ? &f->next : NULL,
                            .only_predicts = f->only_predicts};
}

murk_status murk_fit_fields(murk_fit *f, const murk_fields **fields,
                            murk_error *error)
{
    if (!f || !fields || !f->has_run) {
        return murk_call_refuse(error, "fit or fields is NULL, or the fit has "
                                       "not run");
    }
    const murk_fit_facts facts = facts_of(f);
    murk_call call = murk_call_begin(f->scene->context, NULL, error);
    *fields = &f->fields;
    return murk_call_end(&call,
                         murk_fields_make(&f->fields, murk_results_list_fit,
                                          &facts, &call.failure));
}

/* ---- files ---- */

static murk_status check(const murk_fit *f, murk_session *session,
                         murk_error *err)
{
    const char *const names[] = {
        "fit.csv", f->only_predicts ? "predict.json" : "fit.json",
        f->only_predicts ? NULL : "calibrated.yaml", NULL};
    murk_status status = murk_save_without_exports(session, "a fit", err);
    if (!status) {
        status = murk_results_begin(&session->results, session->settings.folder,
                                    session->settings.force, err);
    }
    return status ? status : murk_session_expect(session, names, err);
}

murk_status murk_fit_check_save(murk_fit *f, const char *folder,
                                const murk_save_options *options,
                                murk_error *error)
{
    if (!f) {
        return murk_call_refuse(error, "fit is NULL");
    }
    murk_call call = murk_call_begin(f->scene->context, &f->files, error);
    murk_session session = f->session;
    murk_status status =
        murk_save_set(&session, folder, options, &call.failure);
    if (!status) {
        status = check(f, &session, &call.failure);
    }
    murk_results_end(&session.results);
    return murk_call_end(&call, status);
}

/* The identity of a fit. Of a mapping the option names the mapping file alone,
 * so the checksum of both files is added. */
static murk_status identify(murk_session *session, const murk_readings *m,
                            const murk_save_options *options, murk_error *err)
{
    char of[80] = "";
    if (m->is_mapped) {
        snprintf(of, sizeof of, "data %s\n", m->sha256);
    }
    return murk_save_identify(session, "fit", options, of, err);
}

static murk_status save(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    const murk_fit *f = of;
    (void)late; /* of exports, which check() refuses */
    const murk_fit_facts facts = facts_of(f);
    murk_status status = check(f, session, err);
    if (!status) {
        status = identify(session, f->measured, options, err);
    }
    if (!status) {
        status = murk_session_add_scene(session, err);
    }
    if (!status) {
        status = murk_results_add_csv(&session->results, "fit.csv",
                                      murk_results_list_fit_row, &facts,
                                      facts.measured->rows, err);
    }
    if (!status && !f->only_predicts) {
        status = murk_add_calibrated(&session->results, &facts, err);
    }
    return status ? status
                  : murk_session_finish(
                        session, f->only_predicts ? "predict.json" : "fit.json",
                        murk_results_json(murk_results_list_fit, &facts),
                        murk_print_fit, &facts, err);
}

murk_status murk_fit_save(murk_fit *f, const char *folder,
                          const murk_save_options *options,
                          const murk_fields **fields, murk_error *error)
{
    if (!f || !f->has_run) {
        return murk_save_refuse(fields, error, "fit is NULL, or has not run");
    }
    murk_call call = murk_call_begin(f->scene->context, &f->files, error);
    return murk_save_results(&call, &f->session, &f->saved, folder, options,
                             fields, save, f);
}
