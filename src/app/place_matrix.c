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
#include "sensing/combined_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MATRIX_SHARE 0.7 /* of the free memory, as for a scene's */
#define COST_MAX     1e6 /* as of a scene: scene/keys_sensors.c */

/* ---- the wish ---- */

static murk_status bad_key(const char *name, const char *value,
                           const char *allowed, murk_error *err)
{
    return murk_fail(err, MURK_BAD_VALUE, name, "%s, must be %s", value,
                     allowed);
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

static murk_status set_detection(murk_matrix_plan *p, const char *name,
                                 const char *value, murk_error *err)
{
    const murk_detection_text allowed =
        murk_detection_list(MURK_DETECTION_SMOOTH, true, " | ");
    return murk_detection_find(&p->detection, value) &&
                   murk_detection_is(p->detection, MURK_DETECTION_SMOOTH)
               ? MURK_OK
               : bad_key(name, value, allowed.text, err);
}

/* A key of a scene that has a meaning for a matrix: a whole number min..max, a
 * number above 0 up to number_max, or as `set` reads it. */
typedef struct matrix_key {
    const char *name, *allowed;
    size_t at, size; /* member of murk_matrix_plan */
    uint64_t min, max;
    double number_max; /* 0: a whole number */
    murk_status (*set)(murk_matrix_plan *p, const char *name, const char *value,
                       murk_error *err);
} matrix_key;

#define MEMBER(member)                        \
    .at = offsetof(murk_matrix_plan, member), \
    .size = sizeof(((murk_matrix_plan *)0)->member)

/* The ranges are those of the keys of a scene with these names:
 * scene/keys_placement.c and scene/keys_sensors.c. */
static const matrix_key KEYS[] = {
    {"seed", "a whole number 0..4294967295", MEMBER(desc.seed),
     .max = UINT32_MAX},
    {"sensors.count", "a whole number 1..1000000", MEMBER(desc.count), .min = 1,
     .max = 1000000},
    {"sensors.target", "more than 0 and at most 1", MEMBER(target),
     .number_max = 1},
    {"sensors.budget", "more than 0 and at most 1e12", MEMBER(budget),
     .number_max = 1e12},
    {"placement.method", .set = set_method},
    {"placement.detection", .set = set_detection},
    {"placement.redundancy", "a whole number 1..16", MEMBER(redundancy),
     .min = 1, .max = MURK_REDUNDANCY_MAX},
    {"placement.restarts", "a whole number 1..1000000", MEMBER(desc.restarts),
     .min = 1, .max = 1000000},
    {"placement.nodes", "a whole number 0..1e15", MEMBER(desc.nodes),
     .max = UINT64_C(1000000000000000)},
};
#define N_KEYS (sizeof KEYS / sizeof *KEYS)

static murk_status set_number(murk_matrix_plan *p, const matrix_key *key,
                              const char *name, const char *value,
                              murk_error *err)
{
    char *member = (char *)p + key->at;
    uint64_t n = 0;
    double x = 0;
    const bool is_good =
        key->number_max > 0
            ? murk_number_parse(value, &x) && x > 0 && x <= key->number_max
            : murk_count_parse(value, &n) && n >= key->min && n <= key->max;
    if (!is_good) {
        return bad_key(name, value, key->allowed, err);
    }
    const uint32_t narrow = (uint32_t)n;
    const void *from = key->number_max > 0          ? (const void *)&x
                       : key->size == sizeof narrow ? (const void *)&narrow
                                                    : (const void *)&n;
    memcpy(member, from, key->size);
    return MURK_OK;
}

/* One override: of a scene's keys, those that mean something here. */
static murk_status set_key(murk_matrix_plan *p, const char *key,
                           const char *name, const char *value, murk_error *err)
{
    char list[256] = "";
    size_t length = 0;
    for (size_t i = 0; i < N_KEYS; ++i) {
        if (strcmp(KEYS[i].name, key) == 0) {
            return KEYS[i].set ? KEYS[i].set(p, name, value, err)
                               : set_number(p, &KEYS[i], name, value, err);
        }
        length += (size_t)snprintf(list + length, sizeof list - length, "%s%s",
                                   i ? ", " : "", KEYS[i].name);
    }
    return murk_fail(err, MURK_BAD_VALUE, name,
                     "with --matrix there is no such key; there are %s", list);
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
    /* What only that column covers. */
    for (size_t k = 0; k < n && combined.dose; ++k) {
        murk_sparse_row row;
        problem->get_row(problem->context, 0, p->place.sensor[k], &row);
        c->only[k] = murk_combined_rows_only_of(&combined, m->weight, &row);
    }
    if (!combined.dose) {
        murk_combined_rows_only(&combined, m->weight, c->only);
    }
    /* Weight of the rows that at least so many columns cover. */
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
