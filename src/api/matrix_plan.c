/* Chooses columns of a coverage matrix from a file, without any world, and
 * writes the choice as murk place --matrix does. The columns are the candidates
 * of a placement problem, the rows are the photons that the candidates cover.
 */
#include "api/matrix_plan.h"

#include "api/matrix_settings.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "results/exports.h"
#include "results/identity.h"
#include "sensing/combined_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the choice ---- */

/* Makes the arrays of p->covers, and *combined without any column yet, which is
 * released by the caller, also after a failure. */
static murk_status set_aside(murk_matrix_plan *p, murk_combined_rows *combined,
                             murk_error *err)
{
    const size_t n = p->place.count;
    p->covers = (murk_covering){.alone = calloc(n, sizeof(uint64_t)),
                                .only = calloc(n, sizeof(uint64_t)),
                                .seen_by = calloc(n + 1, sizeof(uint64_t))};
    return murk_combined_rows_init(combined, p->matrix->rows,
                                   murk_combining_of(p->detection),
                                   p->redundancy) &&
                   p->covers.alone && p->covers.only && p->covers.seen_by
               ? MURK_OK
               : murk_no_memory(err, p->file, "for the plan");
}

/* Fills p->covers (results/matrix.h): what the chosen columns cover, alone and
 * together. */
static murk_status measure(murk_matrix_plan *p, const murk_problem *problem,
                           murk_error *err)
{
    const murk_sparse_matrix *m = p->matrix;
    const size_t n = p->place.count;
    murk_covering *c = &p->covers;
    murk_combined_rows combined = {0};
    const murk_status status = set_aside(p, &combined, err);
    if (status) {
        murk_combined_rows_release(&combined);
        return status;
    }
    /* The weight that each column covers alone, in units of 1 / MURK_CLEAR. */
    for (size_t k = 0; k < n; ++k) {
        murk_sparse_row row;
        problem->get_row(problem->context, 0, p->place.sensor[k], &row);
        for (size_t i = 0; i < row.seen; ++i) {
            c->alone[k] += (uint64_t)m->weight[row.photon[i]] *
                           (row.clarity ? row.clarity[i] : MURK_CLEAR);
        }
        murk_combined_rows_add(&combined, (uint32_t)k, &row);
        c->sum += c->alone[k];
    }
    /* The weight that would be lost without a column: from the row of each
     * column if detection is by probability, else for all columns at once. */
    for (size_t k = 0; k < n && combined.dose; ++k) {
        murk_sparse_row row;
        problem->get_row(problem->context, 0, p->place.sensor[k], &row);
        c->only[k] = murk_combined_rows_only_of(&combined, m->weight, &row);
    }
    if (!combined.dose) {
        murk_combined_rows_only(&combined, m->weight, c->only);
    }
    /* The weight of the rows that at least 1, 2, ... columns cover. */
    for (size_t i = 0; i < m->rows; ++i) {
        c->whole_rows += m->weight[i];
        if (combined.sensors[i]) {
            c->seen_by[combined.sensors[i] - 1] += m->weight[i];
        }
    }
    for (size_t k = n - 1; k > 0; --k) {
        c->seen_by[k - 1] += c->seen_by[k];
    }
    murk_combined_rows_release(&combined);
    return MURK_OK;
}

/* Chooses the columns and measures what they cover. run.sense_s is the time to
 * make the matrix of the solver, run.place_s the time to choose. */
static murk_status choose(murk_matrix_plan *p, murk_error *err)
{
    murk_problem problem =
        murk_sparse_matrix_problem(p->matrix, p->session.settings.threads);
    problem.combining = murk_combining_of(p->detection);
    problem.redundancy = p->redundancy;
    murk_matrix *matrix = NULL;
    murk_status status = murk_matrix_goal(p, &problem, err);
    double begun_s = murk_clock_s();
    if (!status) {
        status = murk_matrix_create(&matrix, &problem, p->desc.row_memory, err);
    }
    p->session.run.sense_s = murk_clock_s() - begun_s;
    begun_s = murk_clock_s();
    if (!status) {
        status = murk_place_sensors(&p->place, &problem, matrix, &p->desc, err);
    }
    murk_matrix_destroy(matrix);
    p->session.run.place_s = murk_clock_s() - begun_s;
    if (status && err && !err->where[0]) {
        snprintf(err->where, sizeof err->where, "%.300s", p->file);
    }
    return status ? status : measure(p, &problem, err);
}

/* ---- what would be refused ---- */

static murk_status check_exports(const murk_matrix_plan *p,
                                 const murk_session *session, murk_error *err)
{
    const unsigned exports = session->settings.exports;
    return exports & ~(unsigned)MURK_EXPORTS_OF_PROBLEM
               ? murk_fail(err, MURK_BAD_VALUE, "exports",
                           "fields, photons and surfaces are of a world; a "
                           "plan for a matrix has matrix, or-library and lp")
               : murk_exports_check(exports, p->detection, err);
}

/* Begins the folder of the session, which murk_results_end() ends, also after a
 * failure, and fails if plan.json may not be written to it. */
static murk_status begin_folder(murk_session *session, murk_error *err)
{
    static const char *const names[] = {"plan.json", NULL};
    const murk_status status =
        murk_results_begin(&session->results, session->settings.folder,
                           session->settings.force, err);
    return status ? status : murk_session_expect(session, names, err);
}

/* ---- the handle ---- */

/* Reads settings and matrix, and fails if murk_plan_save() would refuse the
 * folder or the options; then chooses. */
static murk_status make(murk_matrix_plan *p, const murk_scene *scene,
                        const char *folder, const murk_save_options *options,
                        murk_error *err)
{
    murk_session check = p->session;
    /* Check all that was asked for before the matrix is read. */
    murk_status status = murk_matrix_settings(p, scene, err);
    if (!status) {
        status = murk_save_set(&check, folder, options, err);
    }
    if (!status) {
        status = check_exports(p, &check, err);
    }
    if (!status) {
        status = murk_sparse_matrix_read(&p->matrix, p->file, err);
    }
    if (!status) {
        status = begin_folder(&check, err);
    }
    murk_results_end(&check.results);
    p->session.run.load_s = murk_clock_s() - p->session.begun_s;
    if (!status) {
        status =
            murk_call_limit_search(p->time_limit_s, p->session.begun_s, err);
    }
    return status ? status : choose(p, err);
}

void murk_matrix_plan_release(murk_matrix_plan *p)
{
    if (p) {
        murk_place_release(&p->place);
        murk_sparse_matrix_destroy(p->matrix);
        free(p->covers.alone);
        free(p->covers.only);
        free(p->covers.seen_by);
        free(p->cost);
        free((char *)p->file);
        free(p);
    }
}

murk_status murk_plan_for_matrix(murk_plan **out, murk_scene *scene,
                                 const char *path, const char *folder,
                                 const murk_save_options *options,
                                 murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !scene || !path) {
        return murk_call_refuse(error, "out, scene or path is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    murk_plan *plan = calloc(1, sizeof *plan);
    murk_matrix_plan *p = calloc(1, sizeof *p);
    char *file = strdup(path);
    murk_status status = MURK_NO_MEMORY;
    if (plan && p && file) {
        /* The plan keeps the scene, and with it the context. */
        plan->scene = scene;
        ++scene->references;
        plan->matrix = p;
        p->file = file;
        p->session = (murk_session){.settings.threads = scene->context->threads,
                                    .run.threads = scene->context->threads,
                                    .begun_s = murk_clock_s()};
        murk_finish_allow(true);
        status = make(p, scene, folder, options, &call.failure);
        murk_finish_allow(false);
        murk_finish_set_deadline(INFINITY);
    } else {
        free(file);
        free(p);
        free(plan);
        plan = NULL;
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_plan_destroy(plan);
        return status;
    }
    *out = plan;
    return MURK_OK;
}

/* ---- files ---- */

/* Sets the identity of the results: a hash that covers all settings and
 * options->asked; if options->asked is NULL, also the checksum of the matrix.
 * If it is not NULL, the caller has named the contents of the matrix there. */
static murk_status identify(const murk_matrix_plan *p, murk_session *session,
                            const murk_save_options *options, murk_error *err)
{
    const murk_save_options all = murk_save_known(options);
    char settings[320];
    snprintf(settings, sizeof settings,
             "count %zu target %.17g budget %.17g restarts %zu nodes %llu "
             "method %d combining %d redundancy %u%s%s",
             p->desc.count, p->target, p->budget, p->desc.restarts,
             (unsigned long long)p->desc.nodes, (int)p->desc.method,
             (int)p->detection, p->redundancy, all.asked ? "" : " matrix ",
             all.asked ? "" : p->matrix->sha256);
    return murk_identity_of(session->identity, "place",
                            all.asked ? all.asked : "", NULL, settings,
                            p->desc.seed, err);
}

murk_status murk_matrix_plan_save(void *of, murk_session *session,
                                  const murk_save_options *options,
                                  murk_error *late, murk_error *err)
{
    murk_matrix_plan *p = of;
    /* Judge the options and the folder. */
    murk_status status = check_exports(p, session, err);
    if (!status) {
        status = begin_folder(session, err);
    }
    if (!status) {
        status = identify(p, session, options, err);
    }
    /* Add the exports; plan.json comes last. */
    if (!status && session->settings.exports) {
        const murk_lp_goal goal = {p->desc.target ? 0 : p->desc.count,
                                   p->desc.target, p->desc.constraints,
                                   p->redundancy};
        murk_exports_add(&session->results, session->settings.exports,
                         p->matrix, &goal, late);
    }
    murk_matrix_plan shown = *p;
    shown.session = *session;
    return status ? status
                  : murk_session_finish(
                        session, "plan.json",
                        murk_results_json(murk_results_list_matrix_plan, p),
                        murk_matrix_plan_print, &shown, err);
}
