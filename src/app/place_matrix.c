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
#include "base/number.h"
#include "plan/poses.h"
#include "sensing/views.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MATRIX_SHARE 0.7 /* of the free memory, as for a scene's */
/* The ranges of the keys of a scene with these names: scene/keys_placement.c
 * and scene/keys_sensors.c. */
#define RESTARTS_MAX 1000000
#define NODES_MAX    UINT64_C(1000000000000000)
#define COUNT_MAX    1000000
#define BUDGET_MAX   1e12
#define COST_MAX     1e6

/* ---- the wish ---- */

static murk_status bad_key(const char *name, const char *value,
                           const char *allowed, murk_error *err)
{
    return murk_fail(err, MURK_BAD_VALUE, name, "%s, must be %s", value,
                     allowed);
}

static bool count_in(const char *text, uint64_t low, uint64_t high,
                     uint64_t *out)
{
    return murk_count_parse(text, out) && *out >= low && *out <= high;
}

static murk_status set_method(murk_matrix_plan *p, const char *name,
                              const char *value, murk_error *err)
{
    int method = 0;
    if (murk_scene_word_find("placement.method", value, &method)) {
        p->desc.method = (murk_place_method)method;
        return MURK_OK;
    }
    return bad_key(name, value, "best | spoq | greedy | exact", err);
}

/* One override: of a scene's keys, those that mean something here. */
static murk_status set_key(murk_matrix_plan *p, const char *key,
                           const char *name, const char *value, murk_error *err)
{
    /* The number of sensors, the target or the budget; then the settings of
     * the search. */
    uint64_t n = 0;
    if (strcmp(key, "sensors.count") == 0) {
        if (!count_in(value, 1, COUNT_MAX, &n)) {
            return bad_key(name, value, "a whole number 1..1000000", err);
        }
        p->desc.count = (size_t)n;
    } else if (strcmp(key, "sensors.target") == 0) {
        if (!murk_number_parse(value, &p->target) ||
            !(p->target > 0 && p->target <= 1)) {
            return bad_key(name, value, "more than 0 and at most 1", err);
        }
    } else if (strcmp(key, "sensors.budget") == 0) {
        if (!murk_number_parse(value, &p->budget) ||
            !(p->budget > 0 && p->budget <= BUDGET_MAX)) {
            return bad_key(name, value, "more than 0 and at most 1e12", err);
        }
    } else if (strcmp(key, "seed") == 0) {
        if (!count_in(value, 0, UINT32_MAX, &n)) {
            return bad_key(name, value, "a whole number 0..4294967295", err);
        }
        p->desc.seed = (uint32_t)n;
    } else if (strcmp(key, "placement.restarts") == 0) {
        if (!count_in(value, 1, RESTARTS_MAX, &n)) {
            return bad_key(name, value, "a whole number 1..1000000", err);
        }
        p->desc.restarts = (size_t)n;
    } else if (strcmp(key, "placement.nodes") == 0) {
        if (!count_in(value, 0, NODES_MAX, &p->desc.nodes)) {
            return bad_key(name, value, "a whole number 0..1e15", err);
        }
    } else if (strcmp(key, "placement.redundancy") == 0) {
        if (!count_in(value, 1, MURK_REDUNDANCY_MAX, &n)) {
            return bad_key(name, value, "a whole number 1..16", err);
        }
        p->redundancy = (unsigned)n;
    } else if (strcmp(key, "placement.detection") == 0) {
        if (!murk_detection_find(&p->detection, value) ||
            !murk_detection_is(p->detection, MURK_DETECTION_SMOOTH)) {
            return bad_key(
                name, value,
                murk_detection_list(MURK_DETECTION_SMOOTH, true, " | ").text,
                err);
        }
    } else if (strcmp(key, "placement.method") == 0) {
        return set_method(p, name, value, err);
    } else {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "with --matrix there is no such key; there are seed, "
                         "sensors.count, sensors.target, sensors.budget, "
                         "placement.method, placement.detection, "
                         "placement.redundancy, "
                         "placement.restarts, placement.nodes");
    }
    return MURK_OK;
}

static murk_status read_settings(murk_matrix_plan *p,
                                 const murk_options *options, murk_error *err)
{
    p->desc = murk_place_defaults();
    p->desc.count = 0;
    p->redundancy = 1;
    if (options->light) {
        return murk_fail(err, MURK_BAD_VALUE, "--light",
                         "a matrix has no light; leave it out with --matrix");
    }
    if (murk_option_text(options, "--repeat")) {
        return murk_fail(err, MURK_BAD_VALUE, "--repeat",
                         "a matrix is one sample, other seeds have no other; "
                         "leave it out with --matrix");
    }
    /* The keys that the command line sets. */
    for (size_t i = 0; i < options->n_overrides; ++i) {
        const murk_override *o = &options->overrides[i];
        char key[64], name[96];
        const char *equals = strchr(o->text, '=');
        snprintf(key, sizeof key, "%.*s", (int)(equals - o->text), o->text);
        snprintf(name, sizeof name, "%s%s", o->option ? o->option : "--set ",
                 o->option ? "" : key);
        const murk_status status = set_key(p, key, name, equals + 1, err);
        if (status) {
            return status;
        }
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

/* What the file says a column costs, or 1. */
static murk_status price(murk_matrix_plan *p, murk_error *err)
{
    const murk_sparse_matrix *m = p->matrix;
    p->cost = calloc(m->columns + 1, sizeof *p->cost);
    if (!p->cost) {
        return murk_fail(err, MURK_NO_MEMORY, p->file,
                         "no memory for the costs");
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

/* The target as a value, and the count held against the matrix. */
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

static murk_status set_aside(murk_matrix_plan *p, murk_views *views,
                             murk_error *err)
{
    const size_t n = p->place.count;
    p->covers = (murk_covering){.alone = calloc(n, sizeof(uint64_t)),
                                .only = calloc(n, sizeof(uint64_t)),
                                .seen_by = calloc(n + 1, sizeof(uint64_t))};
    return murk_views_init(views, p->matrix->rows,
                           murk_combining_of(p->detection), p->redundancy) &&
                   p->covers.alone && p->covers.only && p->covers.seen_by
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, p->file,
                           "no memory for the plan");
}

/* What the chosen columns cover, alone and together. */
static murk_status measure(murk_matrix_plan *p, const murk_problem *problem,
                           murk_error *err)
{
    const murk_sparse_matrix *m = p->matrix;
    const size_t n = p->place.count;
    murk_covering *c = &p->covers;
    murk_views views = {0};
    const murk_status status = set_aside(p, &views, err);
    if (status) {
        murk_views_release(&views);
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
        murk_views_add(&views, (uint32_t)k, &row);
        c->sum += c->alone[k];
    }
    /* What only that column covers. */
    for (size_t k = 0; k < n && views.dose; ++k) {
        murk_sparse_row row;
        problem->get_row(problem->context, 0, p->place.sensor[k], &row);
        c->only[k] = murk_views_only_of(&views, m->weight, &row);
    }
    if (!views.dose) {
        murk_views_only(&views, m->weight, c->only);
    }
    /* Weight of the rows that at least so many columns cover. */
    for (size_t i = 0; i < m->rows; ++i) {
        c->whole_rows += m->weight[i];
        if (views.sensors[i]) {
            c->seen_by[views.sensors[i] - 1] += m->weight[i];
        }
    }
    for (size_t k = n - 1; k > 0; --k) {
        c->seen_by[k - 1] += c->seen_by[k];
    }
    murk_views_release(&views);
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
        status = murk_place_known(&p->place, &problem, matrix, &p->desc, err);
    }
    murk_matrix_destroy(matrix);
    p->session.run.place_s = murk_clock_s() - begun_s;
    if (status && err && !err->where[0]) {
        snprintf(err->where, sizeof err->where, "%.300s", p->file);
    }
    return status ? status : measure(p, &problem, err);
}

/* All that the command line asks; the matrix counts by its contents. */
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
            murk_results_json(murk_results_list_matrix_plan, &p), err);
    }
    if (!status && murk_session_speaks(&p.session)) {
        murk_matrix_plan_print(&p);
    }
    if (!status && late.status) {
        status = murk_fail(err, late.status, late.where, "%s", late.text);
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
