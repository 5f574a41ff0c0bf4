/* murk study: runs the rows of a study, writes its table and its JSON, and
 * prints a summary. */
#include "api/log_once.h"
#include "app/identity.h"
#include "app/session.h"
#include "results/study.h"
#include "results/study_print.h"
#include "results/summary.h"
#include "results/version.h"

#include "base/log.h"
#include "cases/sweep.h"
#include "cases/sweep_store.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define VERSION_SIZE 128 /* bytes of a version and a commit */

typedef struct study_run {
    const murk_options *options;
    murk_study_file *study;
    murk_sweep *sweep;
    murk_session session; /* of results; its scene is the base scene, NULL if
                             that cannot stand alone */
    char *seen;           /* notes that were shown */
    bool is_interrupted;
} study_run;

static void warn_of_failure(const study_run *s, size_t row)
{
    char where[64];
    snprintf(where, sizeof where, "row %zu of %zu", row + 1, s->study->rows);
    if (s->sweep->row[row].found.failed[0]) {
        murk_warn(where, "failed: %s", s->sweep->row[row].found.failed);
    }
}

/* Reports a finished row on standard error. */
static void report_row(void *context, size_t row)
{
    study_run *s = context;
    char news[MURK_ROW_TEXT_SIZE], where[64];
    warn_of_failure(s, row);
    snprintf(where, sizeof where, "row %zu of %zu", row + 1, s->study->rows);
    if (murk_log_once_news(&s->seen, s->sweep->row[row].found.note, news,
                           sizeof news)) {
        murk_note(where, "%s", news);
    }
}

/* The scene that rows differ from; none, where it cannot stand without a row's
 * own values. */
static void read_base(study_run *s)
{
    murk_error why = {0};
    const murk_warn_sink sink = murk_warn_to(NULL); /* by the rows */
    (void)murk_scene_desc_read(&s->session.scene, s->study->base,
                               s->options->overrides, s->options->n_overrides,
                               &why);
    murk_warn_to(sink);
}

/* The rows' keys say all that rows follow from. */
static murk_status identify(study_run *s, murk_error *err)
{
    const size_t size = sizeof s->sweep->row->key, rows = s->study->rows;
    char *keys = calloc(rows + 2, size);
    if (!keys) {
        return murk_no_memory(err, "", "for the rows");
    }
    size_t n = (size_t)snprintf(keys, size, "%s", s->study->sha256);
    for (size_t i = 0; i < rows; ++i) {
        n += (size_t)snprintf(keys + n, size, "%s", s->sweep->row[i].key);
    }
    const murk_status status = murk_identity(s->session.identity, s->options,
                                             keys, s->sweep->seed, err);
    free(keys);
    return status;
}

static murk_status begin(study_run *s, murk_error *err)
{
    static const char *const names[] = {"study.json", "table.csv", NULL};
    static char version[VERSION_SIZE];
    const murk_options *o = s->options;
    murk_session_set(&s->session, o);
    snprintf(version, sizeof version, "%s %s", MURK_VERSION,
             murk_version_commit());
    /* Read the study and the scenes of its rows. */
    murk_status status = murk_study_file_read(&s->study, o->input, err);
    if (status) {
        return status;
    }
    const murk_sweep_desc desc = {.study = s->study,
                                  .overrides = o->overrides,
                                  .n_overrides = o->n_overrides,
                                  .folder = o->out,
                                  .force = o->force,
                                  .version = version,
                                  .threads = o->threads,
                                  .row_done = report_row,
                                  .context = s};
    status = murk_sweep_create(&s->sweep, &desc, err);
    if (!status) {
        status = murk_results_begin(&s->session.results, o->out, o->force, err);
    }
    /* Judge the files that will be written before any row runs. */
    if (!status) {
        read_base(s);
        status = murk_session_expect(&s->session, names, err);
    }
    if (!status) {
        status = identify(s, err);
    }
    /* Rows whose scenes could not be read have failed already. */
    for (size_t i = 0; i < s->study->rows && !status; ++i) {
        if (s->sweep->row[i].is_done) {
            warn_of_failure(s, i);
        }
    }
    return status;
}

/* Rows write their grids themselves. */
static murk_status note_fluence(study_run *s, murk_error *err)
{
    murk_status status = MURK_OK;
    const bool wants = s->sweep->outputs.wants[MURK_OUTPUT_FLUENCE];
    for (size_t i = 0; wants && i < s->study->rows && !status; ++i) {
        char name[MURK_SWEEP_NAME_SIZE];
        murk_sweep_fluence_name(name, i);
        if (s->sweep->row[i].is_done && !s->sweep->row[i].found.failed[0]) {
            status = murk_results_note(&s->session.results, name, err);
        }
    }
    return status;
}

/* Prints the lines of the run, which name the folder of rows, too. */
static void print_run(const study_run *s)
{
    murk_print_time(&s->session.run, NULL, 0);
    if (s->options->out) {
        murk_print("files       %s: study.json table.csv %s %srows/\n",
                   s->options->out, MURK_SCENE_NAME,
                   s->sweep->outputs.wants[MURK_OUTPUT_FLUENCE]
                       ? "fluence_*.vdb "
                       : "");
    } else {
        murk_print(
            "files       none: -o DIR writes them, and keeps rows that are "
            "done\n");
    }
}

static murk_status write_files(study_run *s, murk_error *err)
{
    /* The table, the base scene and the grids. */
    murk_status status = murk_add_table(&s->session.results, s->sweep, err);
    if (!status) {
        status = murk_session_add_scene(&s->session, err);
    }
    if (!status) {
        status = note_fluence(s, err);
    }
    /* The JSON comes last and names the other files. */
    if (!status) {
        const murk_study_results study = {s->sweep, s->is_interrupted,
                                          s->options->out};
        cJSON *root = murk_results_json(murk_results_list_study, &study);
        status = (s->is_interrupted ? murk_session_keep : murk_session_finish)(
            &s->session, "study.json", root, murk_print_study, &study, err);
    }
    return status;
}

murk_status murk_command_study(const murk_options *options, murk_error *err)
{
    study_run s = {.options = options};
    murk_status status = begin(&s, err);
    if (!status) {
        status = murk_sweep_run(s.sweep, err);
        if (status == MURK_INTERRUPTED && murk_sweep_done(s.sweep) > 0) {
            murk_error late = {0}; /* the interrupt is the message */
            s.is_interrupted = true;
            (void)write_files(&s, &late);
        }
    }
    if (!status) {
        status = write_files(&s, err);
    }
    if (!status && murk_session_speaks(&s.session)) {
        print_run(&s);
    }
    if (!status && murk_sweep_failed(s.sweep) > 0) {
        status = murk_fail(err, MURK_RUN_FAILED, options->input,
                           "%zu of %zu rows failed (column failed)",
                           murk_sweep_failed(s.sweep), s.study->rows);
    } else if (!status && murk_sweep_why_no_plan(s.sweep)) {
        status = murk_fail(err, MURK_RUN_FAILED, options->input,
                           "no plan for all rows: %s",
                           murk_sweep_why_no_plan(s.sweep));
    }
    free(s.seen);
    murk_session_end(&s.session);
    murk_sweep_destroy(s.sweep);
    murk_study_file_destroy(s.study);
    return status;
}
