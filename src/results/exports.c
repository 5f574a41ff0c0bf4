/* Adds the files of --export: the coverage matrix in its formats (CSV,
 * OR-Library text, LP), candidates.csv, fields, photons and surfaces; and
 * plan.ply. If a file cannot be made, the error goes to `late`, which is
 * reported after the results are written. */
#include "results/exports.h"

#include "base/log.h"
#include "base/progress.h"
#include "results/coverage.h"
#include "results/geo.h"
#include "results/photons.h"
#include "results/plan_ply.h"
#include "results/surfaces.h"
#include "results/tallies.h"
#include "results/voxel_fields.h"

#include <stdlib.h>
#include <string.h>

/* Limit on entries of the exported matrix: each takes 6 bytes of memory, and up
 * to some 20 bytes of text in the files. */
#define ENTRIES_MAX 100000000

#define COST_DIGITS 10 /* significant, in candidates.csv */

/* A file of the problem, and what it is written from. */
typedef struct problem_file {
    murk_export format;
    const char *name;
    const murk_sparse_matrix *matrix;
    const murk_lp_goal *goal;
} problem_file;

static murk_status write_problem(const char *path, const void *context,
                                 murk_error *err)
{
    const problem_file *f = context;
    return f->format == MURK_EXPORT_MATRIX
               ? murk_sparse_matrix_write_csv(f->matrix, path, err)
           : f->format == MURK_EXPORT_OR_LIBRARY
               ? murk_sparse_matrix_write_or_library(f->matrix, path, err)
               : murk_sparse_matrix_write_lp(f->matrix, f->goal, path, err);
}

void murk_exports_add(murk_results *results, unsigned exports,
                      const murk_sparse_matrix *matrix,
                      const murk_lp_goal *goal, murk_error *late)
{
    const problem_file files[] = {
        {MURK_EXPORT_MATRIX, "matrix.csv", matrix, goal},
        {MURK_EXPORT_OR_LIBRARY, "matrix.txt", matrix, goal},
        {MURK_EXPORT_LP, "problem.lp", matrix, goal}};
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        if (exports & files[i].format) {
            (void)murk_results_add(results, files[i].name, write_problem,
                                   &files[i], late);
        }
    }
}

murk_status murk_exports_check(unsigned exports, murk_detection detection,
                               murk_error *err)
{
    return murk_detection_is(detection, MURK_DETECTION_BY_CHANCE) &&
                   exports & MURK_EXPORT_LP
               ? murk_fail(err, MURK_BAD_VALUE, "exports",
                           "lp, but independent chances make no linear "
                           "problem; detection must be %s",
                           murk_detection_list(MURK_DETECTION_BY_CHANCE, false,
                                               " or ")
                               .text)
               : MURK_OK;
}

typedef struct candidate_list {
    const murk_poses *poses;
    const murk_scene_desc *scene;
} candidate_list;

/* candidates.csv: a line for each column of the matrix. */
void murk_results_list_candidate(murk_results_fields *f, const void *of,
                                 size_t j)
{
    const candidate_list *list = of;
    const murk_posed p = list ? (murk_posed){list->scene, &list->poses->pose[j]}
                              : (murk_posed){NULL, NULL};
    MURK_COUNT(f, "column", "number, from 1", j + 1);
    murk_results_list_position(f, p);
    murk_results_list_type(f, p);
    murk_results_list_heading(f, p);
    MURK_ROUNDED(f, "cost", "", "of the sensor type",
                 p.scene->sensors.type[p.pose->type].cost, COST_DIGITS);
}

/* Adds the files of the problem. If the matrix has more than ENTRIES_MAX
 * entries, the error goes to *late, as for a file that cannot be made, and the
 * result is MURK_OK; other failures of the matrix go to err. */
static murk_status add_matrix(murk_session *session,
                              const murk_plan_result *plan, murk_sight *sight,
                              murk_error *late, murk_error *err)
{
    const murk_scene_sensors *settings = &session->scene->sensors;
    /* Compute the coverage of all candidates. */
    murk_sparse_matrix *matrix = NULL;
    murk_sight_problem seen;
    murk_sight_problem_init(&seen, sight, plan->poses->pose,
                            plan->poses->count);
    murk_error why = {0};
    const murk_status status =
        murk_sparse_matrix_collect(&matrix, &seen.problem, ENTRIES_MAX, &why);
    if (status) {
        return murk_fail(status == MURK_RUN_FAILED ? late : err, status,
                         "exports", "%s", why.text) == MURK_RUN_FAILED
                   ? MURK_OK
                   : status;
    }
    /* Write the matrix and the problem that the plan is a solution of. */
    murk_lp_goal goal = {.count = (size_t)settings->count,
                         .constraints = murk_poses_constraints(plan->poses),
                         .redundancy = seen.problem.redundancy};
    if (settings->target > 0) {
        murk_problem problem = murk_sparse_matrix_problem(matrix, 1);
        problem.redundancy = seen.problem.redundancy;
        goal.target = murk_plan_value_of(settings->target, &problem);
    }
    const unsigned exports = session->settings.exports;
    murk_exports_add(&session->results, exports, matrix, &goal, late);
    if (exports & MURK_EXPORT_MATRIX) {
        const candidate_list list = {plan->poses, session->scene};
        (void)murk_results_add_csv(&session->results, "candidates.csv",
                                   murk_results_list_candidate, &list,
                                   plan->poses->count, late);
    }
    murk_sparse_matrix_destroy(matrix);
    return MURK_OK;
}

/* ---- of any scene ---- */

/* Fails if the files of a grid tally would have the names of other files. */
static murk_status check_names(const murk_session *session, murk_error *err)
{
    static const char *const taken[] = {"extinction", "coverage",
                                        "optical_depth", "fields", "surfaces"};
    const murk_scene_desc *scene = session->scene;
    for (size_t i = 0; i < scene->n_tallies; ++i) {
        const murk_scene_tally *tally = &scene->tallies[i];
        bool is_taken = false;
        /* NAME.vti and NAME.vdb of this tally might be files of the domain or
         * of surfaces, or NAME.vdb the photon density of another tally. */
        for (size_t k = 0; k < sizeof taken / sizeof *taken; ++k) {
            is_taken |= strcmp(tally->name, taken[k]) == 0;
        }
        for (size_t k = 0; k < scene->n_tallies; ++k) {
            const char *other = scene->tallies[k].name;
            const size_t length = strlen(other);
            is_taken |= strncmp(tally->name, other, length) == 0 &&
                        strcmp(tally->name + length, "_photons") == 0;
        }
        if (is_taken && tally->type == MURK_TALLY_GRID) {
            return murk_fail(err, MURK_BAD_VALUE, tally->where,
                             "name: %s, which a file of the export fields has; "
                             "must be another",
                             tally->name);
        }
    }
    return MURK_OK;
}

murk_status murk_exports_begin(const murk_session *session, murk_error *err)
{
    const unsigned exports = session->settings.exports;
    murk_field_box box;
    murk_status status = murk_geo_check(session, err);
    if (!status && exports & MURK_EXPORT_FIELDS) {
        status = check_names(session, err);
        status = status ? status : murk_fields_box(&box, session, err);
    }
    if (!status && exports & MURK_EXPORT_SURFACES) {
        status = murk_surfaces_check(session, err);
    }
    return status;
}

void murk_exports_add_scene(murk_session *session, murk_sight *sight,
                            const murk_pose *sensor, size_t n, murk_error *late)
{
    const unsigned exports = session->settings.exports;
    murk_progress_begin_group("export", 0, "");
    if (exports & MURK_EXPORT_FIELDS) {
        murk_add_tally_fields(session, late);
        murk_fields_add(session, sight, sensor, n, late);
    }
    if (exports & MURK_EXPORT_PHOTONS) {
        murk_photons_add(session, late);
    }
    if (exports & MURK_EXPORT_SURFACES) {
        murk_surfaces_add(session, sight, sensor, n, late);
    }
    murk_progress_end();
}

murk_status murk_exports_add_plan(murk_session *session,
                                  const murk_plan_result *plan,
                                  murk_error *late, murk_error *err)
{
    const unsigned exports = session->settings.exports;
    if (!session->results.folder) {
        return MURK_OK;
    }
    /* In the dark no sensor sees anything. */
    if (plan->is_dark) {
        if (exports & MURK_EXPORTS_OF_PROBLEM) {
            murk_note("exports", "it is dark: there is no coverage to write");
        }
        murk_exports_add_scene(session, NULL, NULL, 0, late);
        return MURK_OK;
    }
    /* The sightlines of the plan, computed again. */
    murk_sight *sight = NULL;
    murk_status status =
        murk_plan_sight(&sight, session->stage, session->traced,
                        session->settings.threads, err);
    if (!status) {
        status =
            murk_add_plan_ply(&session->results, "plan.ply", session->stage,
                              sight, plan->sensor, plan->place.count, err);
    }
    if (!status && exports & MURK_EXPORTS_OF_PROBLEM) {
        murk_progress_begin_group("export", 0, "");
        status = add_matrix(session, plan, sight, late, err);
        murk_progress_end();
    }
    if (!status) {
        murk_exports_add_scene(session, sight, plan->sensor, plan->place.count,
                               late);
    }
    murk_sight_destroy(sight);
    return status;
}
