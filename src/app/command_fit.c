/* murk fit: reads measurements and free keys, calibrates the scene to them or
 * predicts them, and writes the results. */
#include "app/session.h"
#include "calibrate/covered.h"
#include "results/fit.h"
#include "scene/yaml.h"

#include "base/log.h"
#include "base/progress.h"
#include "world/stage_build.h"

#include <stdlib.h>
#include <string.h>

/* What a fit is made from, and comes to. */
typedef struct fit {
    const murk_options *options;
    murk_imported_stages imported;
    murk_readings *measured;
    murk_free_keys *keys;
    murk_calibration found;
    murk_proposals next;
    char *asked[MURK_FREE_MAX]; /* [n_asked] of --predict */
    size_t n_asked;
} fit;

/* The files of all conditions first, then the scene's own world. */
static murk_status begin(fit *f, murk_session *session, murk_error *err)
{
    murk_status status = murk_session_scene(session, f->options, err);
    murk_progress_begin_group("build", 0, "");
    if (!status) {
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

static void release(fit *f)
{
    murk_proposals_release(&f->next);
    murk_calibration_release(&f->found);
    murk_free_keys_destroy(f->keys);
    murk_readings_destroy(f->measured);
    for (size_t i = 0; i < f->n_asked; ++i) {
        free(f->asked[i]);
    }
}

/* ---- --predict: the values of a finished fit ---- */

static murk_status parameters_of(const murk_yaml **out, const murk_yaml *root,
                                 const char *path, murk_error *err)
{
    const murk_yaml *list =
        root->kind == MURK_YAML_MAP ? murk_yaml_get(root, "parameters") : NULL;
    if (!list || list->kind != MURK_YAML_LIST) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "has no list of parameters, must be the fit.json of a "
                         "fit");
    }
    if (list->n < 1 || list->n > MURK_FREE_MAX) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "%zu parameters, must be 1..%d", list->n,
                         MURK_FREE_MAX);
    }
    /* Each parameter needs a key and a number. */
    for (size_t i = 0; i < list->n; ++i) {
        const murk_yaml *item = list->child[i];
        const bool is_map = item->kind == MURK_YAML_MAP;
        const murk_yaml *key = is_map ? murk_yaml_get(item, "key") : NULL;
        const murk_yaml *value = is_map ? murk_yaml_get(item, "value") : NULL;
        double number;
        if (!key || key->kind != MURK_YAML_SCALAR || !value ||
            !murk_yaml_number(value, &number)) {
            char where[320];
            murk_yaml_place(item, where, sizeof where);
            return murk_fail(err, MURK_BAD_FILE, where,
                             "a parameter must have a key and a value");
        }
    }
    *out = list;
    return MURK_OK;
}

/* Asks for the keys of a finished fit: "media.fog.visibility_m@dawn" was asked
 * for as "media.fog.visibility_m@each". */
static murk_status ask_for(fit *f, const murk_yaml *list, murk_error *err)
{
    for (size_t i = 0; i < list->n; ++i) {
        const char *name = murk_yaml_get(list->child[i], "key")->text;
        const size_t length = strcspn(name, "@");
        const size_t size = length + sizeof "@each";
        char *asked = malloc(size);
        if (!asked) {
            return murk_no_memory(err, "", "for the fit");
        }
        snprintf(asked, size, "%.*s%s", (int)length, name,
                 name[length] ? "@each" : "");
        bool is_new = true;
        for (size_t k = 0; is_new && k < f->n_asked; ++k) {
            is_new = strcmp(f->asked[k], asked) != 0;
        }
        if (is_new) {
            f->asked[f->n_asked++] = asked;
        } else {
            free(asked);
        }
    }
    return MURK_OK;
}

static murk_status set_values(fit *f, const murk_yaml *list, murk_error *err)
{
    for (size_t k = 0; k < f->keys->n; ++k) {
        murk_free_key *key = &f->keys->key[k];
        const murk_yaml *found = NULL;
        for (size_t i = 0; i < list->n; ++i) {
            const murk_yaml *item = list->child[i];
            if (strcmp(murk_yaml_get(item, "key")->text, key->name) == 0) {
                found = murk_yaml_get(item, "value");
            }
        }
        if (!found) {
            return murk_fail(err, MURK_BAD_FILE, f->options->fit.predict,
                             "has no value of %s", key->name);
        }
        (void)murk_yaml_number(found, &key->start);
        if (!(key->start >= key->lower && key->start <= key->upper)) {
            return murk_fail(err, MURK_BAD_VALUE, f->options->fit.predict,
                             "%s: %g, must be %g..%g", key->name, key->start,
                             key->lower, key->upper);
        }
    }
    return MURK_OK;
}

/* ---- the command ---- */

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
    murk_progress_text("takes about %.2g GB of %.3g GB free", bytes / 1e9,
                       have_bytes / 1e9);
}

/* Refuses before any trace what would otherwise fail after all of them. */
static murk_status check_before_trace(const fit *f, const murk_session *session,
                                      murk_error *err)
{
    const murk_readings *m = f->measured;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < m->readings && !status; ++i) {
        if (m->reading[i].kind == MURK_READ_COVERAGE) {
            status = murk_covered_check(session->scene, err);
        }
    }
    return !status && murk_option_number(f->options, "--next", 0)
               ? murk_proposals_check(m, session->scene, err)
               : status;
}

static murk_status read_input(fit *f, const murk_session *session,
                              murk_yaml **values, murk_error *err)
{
    const murk_options *o = f->options;
    const murk_yaml *list = NULL;
    murk_status status = MURK_OK;
    /* With --predict the free keys are those of a finished fit. */
    if (o->fit.predict) {
        status = murk_yaml_read(values, o->fit.predict, err);
        if (!status) {
            status = parameters_of(&list, *values, o->fit.predict, err);
        }
        if (!status) {
            status = ask_for(f, list, err);
        }
        bool is_accepted = true;
        const murk_yaml *accepted =
            status ? NULL : murk_yaml_get(*values, "accepted");
        if (accepted && murk_yaml_bool(accepted, &is_accepted) &&
            !is_accepted) {
            murk_fit_warn_refused(o->fit.predict);
        }
    }
    /* The measurements, then the free keys with their bounds and starts. */
    if (!status) {
        status = murk_readings_read(&f->measured, o->fit.data, session->scene,
                                    &session->stage->world.domain, err);
    }
    const murk_free_desc desc = {.scene_path = o->input,
                                 .overrides = o->overrides,
                                 .n_overrides = o->n_overrides,
                                 .asked = list ? (const char *const *)f->asked
                                               : o->fit.free.word,
                                 .n_asked = list ? f->n_asked : o->fit.free.n,
                                 .bounds = o->fit.bounds.word,
                                 .n_bounds = o->fit.bounds.n,
                                 .measured = f->measured,
                                 .domain = &session->stage->world.domain};
    if (!status) {
        status = murk_free_keys_create(&f->keys, &desc, err);
    }
    if (!status && list) {
        status = set_values(f, list, err);
    }
    return status ? status : check_before_trace(f, session, err);
}

static murk_status write_files(const fit *f, murk_session *session,
                               murk_error *err)
{
    const bool only_predicts = f->options->fit.predict != NULL;
    const murk_fit_facts facts = {.scene = session->scene,
                                  .keys = f->keys,
                                  .measured = f->measured,
                                  .found = &f->found,
                                  .next = f->next.place ? &f->next : NULL,
                                  .only_predicts = only_predicts};
    session->run.trace_s = f->found.trace_s;
    murk_status status = murk_session_add_scene(session, err);
    if (!status) {
        status = murk_results_add_csv(&session->results, "fit.csv",
                                      murk_results_list_fit_row, &facts,
                                      facts.measured->rows, err);
    }
    if (!status && !only_predicts) {
        status = murk_add_calibrated(&session->results, &facts, err);
    }
    if (!status) {
        status = murk_session_finish(
            session, only_predicts ? "predict.json" : "fit.json",
            murk_results_json(murk_results_list_fit, &facts), murk_print_fit,
            &facts, err);
    }
    /* where no summary is printed, a warning carries the refusal, with --quiet
     * as well: who uses the values must know */
    if (!status && !only_predicts && !f->found.is_accepted &&
        !murk_session_speaks(session)) {
        murk_message("warning: ", "", f->found.verdict);
    }
    if (!status) {
        murk_print_run(session, NULL, 0);
    }
    return status;
}

static murk_status run(fit *f, murk_session *session, murk_error *err)
{
    const murk_options *o = f->options;
    const murk_calibration_desc desc = {
        .keys = f->keys,
        .measured = f->measured,
        .imported = &f->imported,
        .loss = o->fit.loss,
        .loss_width = o->fit.loss_width,
        .starts = (size_t)murk_option_number(o, "--starts", 0),
        .traces_max = (size_t)murk_option_number(o, "--traces", 0),
        .threads = o->threads,
        .seed = session->scene->seed,
        .only_predicts = o->fit.predict != NULL,
        .watch = tell_step,
        .forecast = tell_memory,
        .context = f};
    /* Fit, or predict. */
    const uint64_t next = murk_option_number(o, "--next", 0);
    murk_progress_begin_group("fit", 0, "steps");
    murk_status status = murk_calibrate(&f->found, &desc, err);
    murk_progress_end();
    /* Propose the next measurements, if asked for. */
    if (!status && next > 0) {
        murk_progress_begin_group("next", 0, "");
        status = murk_proposals_create(&f->next, (size_t)next, &f->found, &desc,
                                       err);
        murk_progress_end();
    }
    return status ? status : write_files(f, session, err);
}

static murk_status check_options(const murk_options *o, murk_error *err)
{
    if (!o->fit.data) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "fit needs --data FILE, a CSV of what was measured");
    }
    if (o->fit.predict && (o->fit.free.n || murk_option_text(o, "--next"))) {
        return murk_fail(err, MURK_BAD_VALUE, "--predict",
                         "fits nothing, so it goes with neither --free nor "
                         "--next");
    }
    if (!o->fit.predict && !o->fit.free.n) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "fit needs --free KEY, the scene's keys to be found "
                         "(or --predict FIT.json)");
    }
    return MURK_OK;
}

murk_status murk_command_fit(const murk_options *options, murk_error *err)
{
    fit f = {.options = options};
    murk_session session = {0};
    murk_yaml *values = NULL;
    murk_status status = check_options(options, err);
    if (!status) {
        status = begin(&f, &session, err);
    }
    if (!status) {
        status = read_input(&f, &session, &values, err);
    }
    if (!status) { /* now that the input is good */
        status = murk_results_begin(&session.results, options->out,
                                    options->force, err);
    }
    if (!status) {
        const char *const names[] = {
            "fit.csv", options->fit.predict ? "predict.json" : "fit.json",
            options->fit.predict ? NULL : "calibrated.yaml", NULL};
        status = murk_session_expect(&session, names, err);
    }
    if (!status) {
        status = run(&f, &session, err);
    }
    murk_yaml_destroy(values);
    release(&f);
    murk_stage_destroy(session.stage); /* borrows of the imported stages */
    session.stage = NULL;
    murk_imported_stages_release(&f.imported);
    murk_session_end(&session);
    return status;
}
