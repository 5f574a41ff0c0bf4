/* murk place --matrix: places for a coverage matrix from a file, without any
 * scene. */
#include "app/place_matrix.h"

#include "app/identity.h"
#include "app/session.h"
#include "results/exports.h"
#include "results/matrix.h"
#include "results/plan.h"

#include "base/log.h"
#include "base/machine.h"
#include "plan/poses.h"
#include "sensing/combined_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MATRIX_SHARE 0.7 /* of the free memory, as in plan/plan.c */
#define COST_MAX     1e6 /* as of a scene: scene/keys_sensors.c */

/* ---- the settings ---- */

/* The keys of a scene that have a meaning for a matrix. */
static const char *const KEYS[] = {
    "seed",
    "sensors.count",
    "sensors.target",
    "sensors.budget",
    "placement.method",
    "placement.detection",
    "placement.redundancy",
    "placement.restarts",
    "placement.nodes",
};
#define N_KEYS (sizeof KEYS / sizeof *KEYS)

/* Fails unless the key of an override is one of KEYS. */
static murk_status check_key(const murk_override *override, murk_error *err)
{
    const size_t length = strcspn(override->text, "=");
    char list[256] = "", name[96];
    for (size_t i = 0, n = 0; i < N_KEYS; ++i) {
        if (strlen(KEYS[i]) == length &&
            strncmp(KEYS[i], override->text, length) == 0) {
            return MURK_OK;
        }
        n += (size_t)snprintf(list + n, sizeof list - n, "%s%s", i ? ", " : "",
                              KEYS[i]);
    }
    snprintf(name, sizeof name, "%s%.*s",
             override->option ? override->option : "--set ",
             override->option ? 0 : (int)length, override->text);
    return murk_fail(err, MURK_BAD_VALUE, name,
                     "with --matrix there is no such key; there are %s", list);
}

/* Reads the keys that the command line sets, by the key table of scenes. */
static murk_status read_overrides(murk_matrix_plan *p,
                                  const murk_options *options, murk_error *err)
{
    murk_place_desc *desc = &p->desc;
    murk_scene_desc asked = {.seed = desc->seed,
                             .placement = {.method = desc->method,
                                           .redundancy = 1,
                                           .restarts = desc->restarts,
                                           .nodes = desc->nodes}};
    murk_status status = MURK_OK;
    for (size_t i = 0; i < options->n_overrides && !status; ++i) {
        status = check_key(&options->overrides[i], err);
        if (!status) {
            status =
                murk_scene_override_read(&asked, &options->overrides[i], err);
        }
    }
    if (!status &&
        !murk_detection_is(asked.placement.detection, MURK_DETECTION_SMOOTH)) {
        status = murk_fail(
            err, MURK_BAD_VALUE, "placement.detection",
            "%s, must be %s with --matrix",
            murk_detection_name(asked.placement.detection),
            murk_detection_list(MURK_DETECTION_SMOOTH, true, ", ").text);
    }
    /* The settings of the search. */
    desc->seed = asked.seed;
    desc->count = (size_t)asked.sensors.count;
    desc->method = asked.placement.method;
    desc->restarts = (size_t)asked.placement.restarts;
    desc->nodes = asked.placement.nodes;
    p->detection = asked.placement.detection;
    p->redundancy = (unsigned)asked.placement.redundancy;
    p->target = asked.sensors.target;
    p->budget = asked.sensors.budget;
    return status;
}

static murk_status read_settings(murk_matrix_plan *p,
                                 const murk_options *options, murk_error *err)
{
    p->desc = murk_place_defaults();
    if (options->light) {
        return murk_fail(err, MURK_BAD_VALUE, "--light",
                         "a matrix has no light; leave it out with --matrix");
    }
    if (murk_option_text(options, "--repeat")) {
        return murk_fail(err, MURK_BAD_VALUE, "--repeat",
                         "a matrix is one sample, other seeds have no other; "
                         "leave it out with --matrix");
    }
    const murk_status status = read_overrides(p, options, err);
    if (status) {
        return status;
    }
    /* One goal, and only one. */
    const int goals = (p->desc.count > 0) + (p->target > 0) + (p->budget > 0);
    if (goals != 1) {
        return murk_fail(err, MURK_BAD_VALUE, "--matrix",
                         "needs one of --count N, --target C and --budget B, "
                         "%d are given",
                         goals);
    }
    return MURK_OK;
}

/* Sets the cost of each column, that of the file or else 1, and the constraint
 * of the budget. */
static murk_status price(murk_matrix_plan *p, murk_error *err)
{
    const murk_sparse_matrix *m = p->matrix;
    p->cost = calloc(m->columns + 1, sizeof *p->cost);
    if (!p->cost) {
        return murk_no_memory(err, p->file, "for the costs");
    }
    for (size_t j = 0; j < m->columns; ++j) {
        const double cost = m->cost ? m->cost[j] : 1;
        if (!(cost >= 0 && cost <= COST_MAX)) {
            return murk_fail(err, MURK_BAD_VALUE, p->file,
                             "column %zu costs %g, must be 0..1e6", j + 1,
                             cost);
        }
        p->cost[j] = llround(cost / MURK_COST_UNIT);
    }
    p->constraints = (murk_constraints){
        .cost = p->cost, .budget = llround(p->budget / MURK_COST_UNIT)};
    p->desc.constraints = &p->constraints;
    return MURK_OK;
}

/* Turns the target into a value of the problem, or sets the costs for the
 * budget, or checks the count against the number of columns. */
static murk_status fit_settings(murk_matrix_plan *p,
                                const murk_problem *problem, murk_error *err)
{
    if (p->target > 0) {
        p->desc.target = murk_plan_value_of(p->target, problem);
        p->desc.count = problem->candidates;
    } else if (p->budget > 0) {
        return price(p, err);
    } else if (p->desc.count > problem->candidates) {
        return murk_fail(err, MURK_BAD_VALUE, "--count",
                         "%zu, but %s has %zu columns", p->desc.count, p->file,
                         problem->candidates);
    }
    return MURK_OK;
}

/* ---- the plan ---- */

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

/* What the chosen columns cover, alone and together. */
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
    /* What each column covers alone. */
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
    /* The weight that of the chosen columns only this one covers. */
    for (size_t k = 0; k < n && combined.dose; ++k) {
        murk_sparse_row row;
        problem->get_row(problem->context, 0, p->place.sensor[k], &row);
        c->only[k] = murk_combined_rows_only_of(&combined, m->weight, &row);
    }
    if (!combined.dose) {
        murk_combined_rows_only(&combined, m->weight, c->only);
    }
    /* seen_by[k]: the weight of the rows that at least k + 1 columns cover. */
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

static murk_status choose(murk_matrix_plan *p, murk_error *err)
{
    murk_problem problem =
        murk_sparse_matrix_problem(p->matrix, p->session.settings.threads);
    problem.combining = murk_combining_of(p->detection);
    problem.redundancy = p->redundancy;
    murk_matrix *matrix = NULL;
    murk_status status = fit_settings(p, &problem, err);
    const double max = MATRIX_SHARE * fmin(murk_machine_memory_bytes(), 1e18);
    double begun_s = murk_clock_s();
    if (!status) {
        status = murk_matrix_create(&matrix, &problem, (uint64_t)max, err);
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

/* Sets the identity of the results, which follows from the settings of the
 * command line and the contents of the matrix file. */
static murk_status identify(murk_matrix_plan *p, const murk_options *options,
                            murk_error *err)
{
    char settings[256];
    snprintf(settings, sizeof settings,
             "count %zu target %.17g budget %.17g restarts %zu nodes %llu "
             "method %d combining %d redundancy %u",
             p->desc.count, p->target, p->budget, p->desc.restarts,
             (unsigned long long)p->desc.nodes, (int)p->desc.method,
             (int)p->detection, p->redundancy);
    return murk_identity(p->session.identity, options, settings, p->desc.seed,
                         err);
}

static murk_status load(murk_matrix_plan *p, const murk_options *options,
                        murk_error *err)
{
    murk_status status = read_settings(p, options, err);
    if (!status) {
        status = murk_exports_check(options->exports, p->detection, err);
    }
    if (!status) {
        status = murk_sparse_matrix_read(&p->matrix, options->matrix, err);
    }
    if (!status) {
        status = identify(p, options, err);
    }
    if (!status) {
        status = murk_results_begin(&p->session.results, options->out,
                                    options->force, err);
    }
    if (!status) {
        static const char *const names[] = {"plan.json", NULL};
        status = murk_session_expect(&p->session, names, err);
    }
    p->session.run.load_s = murk_clock_s() - p->session.begun_s;
    return status;
}

murk_status murk_place_matrix(const murk_options *options, murk_error *err)
{
    murk_matrix_plan p = {.file = options->matrix};
    murk_session_set(&p.session, options);
    murk_status status = load(&p, options, err);
    if (!status) {
        status = choose(&p, err);
    }
    /* Exports, results, summary. */
    murk_error late = {0};
    if (!status && options->exports) {
        const murk_lp_goal goal = {p.desc.target ? 0 : p.desc.count,
                                   p.desc.target, p.desc.constraints,
                                   p.redundancy};
        murk_exports_add(&p.session.results, options->exports, p.matrix, &goal,
                         &late);
    }
    if (!status) {
        status = murk_session_finish(
            &p.session, "plan.json",
            murk_results_json(murk_results_list_matrix_plan, &p),
            murk_matrix_plan_print, &p, err);
    }
    if (!status) {
        const double read_s = p.session.run.sense_s;
        p.session.run.sense_s = 0;
        murk_print_run(&p.session, "matrix", read_s);
    }
    if (!status && late.code) {
        status = murk_fail(err, late.code, late.where, "%s", late.text);
    }
    murk_session_end(&p.session);
    murk_place_release(&p.place);
    murk_sparse_matrix_destroy(p.matrix);
    free(p.covers.alone);
    free(p.covers.only);
    free(p.covers.seen_by);
    free(p.cost);
    return status;
}
