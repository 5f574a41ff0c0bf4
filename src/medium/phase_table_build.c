/* Makes phase tables from rows of angles and values, and from the
 * Fournier-Forand formula: checks the input, places nodes along the law, and
 * uses a cache of earlier tables. */
#include "medium/phase_table.h"

#include "base/cache.h"
#include "medium/fournier_forand.h"
#include "medium/phase_nodes.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* One degree in radians. */
#define DEGREE 0.017453292519943295

#define FIRST_DEG_MAX 10.0  /* less than 1 % of the sphere is inside */
#define MIN_DEG       1e-6  /* below 6e-7 the cosine is rounded to 1 */
#define LAST_DEG_MIN  150.0 /* less than 7 % of the sphere is beyond */
/* More rows and a wider range of values than any measurement has; the range
 * keeps logarithms and integrals finite. */
#define ROWS_MAX  1000000
#define VALUE_MIN 1e-30
#define VALUE_MAX 1e30

/* Below this s, angle^k is (2 s)^(k/2) to a relative error of angle^2 k / 24,
 * at most 8e-7 for |k| <= 2. */
#define HEAD_S 5e-6

static murk_status fail_row(murk_error *err, const murk_phase_rows *rows,
                            size_t i, const char *column, const char *format,
                            ...) __attribute__((format(printf, 5, 6)));

static murk_status fail_row(murk_error *err, const murk_phase_rows *rows,
                            size_t i, const char *column, const char *format,
                            ...)
{
    char where[320], text[200];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (rows->line) {
        snprintf(where, sizeof where, "%.240s:%d: %s", rows->where,
                 rows->line[i], column);
    } else {
        snprintf(where, sizeof where, "%.240s: row %zu: %s", rows->where, i,
                 column);
    }
    return murk_fail(err, MURK_BAD_VALUE, where, "%s", text);
}

static murk_status check_angle(const murk_phase_rows *rows, size_t i,
                               murk_error *err)
{
    const double angle = rows->angle_deg[i];
    if (!(angle == 0 || (angle >= MIN_DEG && angle <= 180))) {
        return fail_row(err, rows, i, "angle_deg",
                        "%.9g, must be 0 or %g..180 degrees", angle, MIN_DEG);
    }
    if (i > 0 && !(angle > rows->angle_deg[i - 1])) {
        return fail_row(err, rows, i, "angle_deg",
                        "%.9g, must be more than the %.9g degrees before",
                        angle, rows->angle_deg[i - 1]);
    }
    if (i == 0 && angle > FIRST_DEG_MAX) {
        return fail_row(err, rows, i, "angle_deg",
                        "begins at %.9g, must be 0..%g degrees", angle,
                        FIRST_DEG_MAX);
    }
    if (i + 1 == rows->rows && angle < LAST_DEG_MIN) {
        return fail_row(err, rows, i, "angle_deg",
                        "ends at %.9g, must be %g..180 degrees", angle,
                        LAST_DEG_MIN);
    }
    return MURK_OK;
}

static murk_status check_rows(const murk_phase_rows *rows, murk_error *err)
{
    if (rows->rows < 2 || rows->rows > ROWS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, rows->where,
                         "%zu rows, must be 2..%d", rows->rows, ROWS_MAX);
    }
    for (size_t i = 0; i < rows->rows; ++i) {
        const double value = rows->phase_per_sr[i];
        const murk_status status = check_angle(rows, i, err);
        if (status) {
            return status;
        }
        if (!(value == 0 || (value >= VALUE_MIN && value <= VALUE_MAX))) {
            return fail_row(err, rows, i, "phase_per_sr",
                            "%.9g, must be 0 or %g..%g per sr", value,
                            VALUE_MIN, VALUE_MAX);
        }
    }
    return MURK_OK;
}

static double s_of(double angle_rad)
{
    const double half = sin(.5 * angle_rad);
    return 2 * half * half;
}

static double angle_of(double s)
{
    return 2 * asin(sqrt(.5 * s));
}

/* The law between two rows, first * (angle / from)^power, where `first` is the
 * value of the first row and `from` its angle in radians. */
typedef struct stretch {
    double from, first, power;
} stretch;

static double stretch_density(const void *context, double s)
{
    const stretch *st = context;
    return st->first * pow(angle_of(s) / st->from, st->power);
}

/* The law between row i and the next. */
static stretch stretch_of(const murk_phase_rows *rows, size_t i)
{
    const double from = rows->angle_deg[i], to = rows->angle_deg[i + 1];
    const double first = rows->phase_per_sr[i],
                 last = rows->phase_per_sr[i + 1];
    return (stretch){from * DEGREE, first, log(last / first) / log(to / from)};
}

static bool is_straight(const murk_phase_rows *rows, size_t i)
{
    return rows->angle_deg[i] == 0 || rows->phase_per_sr[i] == 0 ||
           rows->phase_per_sr[i + 1] == 0;
}

/* Nodes from angle 0 to the first row. */
static murk_status lay_head(murk_phase_nodes *nodes,
                            const murk_phase_rows *rows, murk_error *err)
{
    const double s = s_of(rows->angle_deg[0] * DEGREE);
    stretch law = {0, 0, 0};
    if (!is_straight(rows, 0)) {
        law = stretch_of(rows, 0);
    }
    /* Without a power law, or with one that does not rise towards angle 0, the
     * value is constant to angle 0. */
    if (!(law.power < 0)) {
        murk_phase_nodes_begin(nodes, 0, rows->phase_per_sr[0], 0);
        murk_phase_nodes_line(nodes, s, rows->phase_per_sr[0]);
        return MURK_OK;
    }
    /* Too steep: the integral to angle 0 diverges. */
    if (law.power <= -2) {
        return fail_row(err, rows, 0, "phase_per_sr",
                        "the first two rows fall as angle^%.4g, which has no "
                        "integral to angle 0: must be less steep than "
                        "angle^-2, or begin with a row at angle 0",
                        law.power);
    }
    /* A falling power law continues to angle 0. */
    const double begin = fmin(s, HEAD_S);
    murk_phase_nodes_begin(nodes, begin, stretch_density(&law, begin),
                           .5 * law.power);
    murk_phase_nodes_law(nodes, s, stretch_density, &law);
    return MURK_OK;
}

static murk_status lay_rows(murk_phase_nodes *nodes,
                            const murk_phase_rows *rows, murk_error *err)
{
    for (size_t i = 0; i + 1 < rows->rows; ++i) {
        const double s = s_of(rows->angle_deg[i + 1] * DEGREE);
        if (is_straight(rows, i)) {
            murk_phase_nodes_line(nodes, s, rows->phase_per_sr[i + 1]);
        } else {
            const stretch law = stretch_of(rows, i);
            murk_phase_nodes_law(nodes, s, stretch_density, &law);
        }
        if (nodes->is_full) {
            return fail_row(err, rows, i + 1, "phase_per_sr",
                            "too many steep rows up to here: no memory, or "
                            "more than %u steps",
                            MURK_PHASE_NODES_MAX);
        }
    }
    return MURK_OK;
}

static murk_status lay_table(murk_phase_table **out,
                             const murk_phase_rows *rows, murk_error *err)
{
    murk_phase_nodes nodes = {0};
    murk_status status = lay_head(&nodes, rows, err);
    const double before = murk_phase_nodes_integral(&nodes);
    double covered = 0;
    if (!status) {
        status = lay_rows(&nodes, rows, err);
        covered = murk_phase_nodes_integral(&nodes);
    }
    if (status) {
        free(nodes.node);
        return status;
    }
    murk_phase_nodes_line(&nodes, 2, rows->phase_per_sr[rows->rows - 1]);
    status = murk_phase_nodes_finish(out, &nodes, rows->where, err);
    if (!status) {
        murk_phase_facts *facts = &(*out)->facts;
        facts->before_first = before / facts->integral;
        facts->behind_last = 1 - covered / facts->integral;
    }
    return status;
}

/* ---- the cache of earlier tables ---- */

/* The same input gives the same table, and computing one takes some ten
 * milliseconds (base/cache.h). */
static murk_cache cache = MURK_CACHE_NONE;

/* The key of a table in the cache, a[n] followed by b[n]: the angles and values
 * of a measured function, or the refractive index and the slope of a
 * Fournier-Forand function (n is 1). The caller frees the key. NULL when out of
 * memory. */
static double *key_of(size_t n, const double *a, const double *b)
{
    double *key = malloc(2 * n * sizeof *key);
    if (key) {
        memcpy(key, a, n * sizeof *key);
        memcpy(key + n, b, n * sizeof *key);
    }
    return key;
}

/* Finds a table in the cache; NULL if it must be computed. */
static murk_phase_table *find_table(const double *key, size_t n)
{
    size_t size;
    murk_phase_table *table =
        key ? murk_cache_find(&cache, key, 2 * n * sizeof *key, &size) : NULL;
    if (table) {
        murk_phase_table_attach(table);
    }
    return table;
}

static void keep_table(const murk_phase_table *table, const double *key,
                       size_t n)
{
    if (key) {
        murk_cache_put(&cache, key, 2 * n * sizeof *key, table,
                       murk_phase_table_bytes(table));
    }
}

murk_status murk_phase_table_create(murk_phase_table **out,
                                    const murk_phase_rows *rows,
                                    murk_error *err)
{
    murk_status status = check_rows(rows, err);
    if (status) {
        return status;
    }
    double *key = key_of(rows->rows, rows->angle_deg, rows->phase_per_sr);
    murk_phase_table *found = find_table(key, rows->rows);
    if (found) {
        *out = found;
    } else {
        status = lay_table(out, rows, err);
        if (!status) {
            keep_table(*out, key, rows->rows);
        }
    }
    free(key);
    return status;
}

typedef struct forand {
    double n, slope;
} forand;

static double forand_density(const void *context, double s)
{
    const forand *f = context;
    return murk_fournier_forand(f->n, f->slope, s);
}

/* An s before which the phase function is a power law to the tolerance, tested
 * at 2^-20 s: the first such number of HEAD_S, HEAD_S / 4, HEAD_S / 16 and so
 * on, or, if there is none, the first of them that is not above 1e-18. */
static double forand_head(const forand *f)
{
    const double power = .5 * (f->slope - 5), far = 0x1p-20;
    double s = HEAD_S;
    for (; s > 1e-18; s *= .25) {
        const double law = forand_density(f, s) * pow(far, power);
        const double want = forand_density(f, far * s);
        if (fabs(law - want) <= MURK_PHASE_TOLERANCE * want) {
            break;
        }
    }
    return s;
}

murk_status murk_phase_table_fournier_forand(murk_phase_table **out, double n,
                                             double slope, const char *where,
                                             murk_error *err)
{
    if (!(n >= 1.001 && n <= 2)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "relative index n of Fournier-Forand is %g, must be "
                         "1.001..2",
                         n);
    }
    if (!(slope >= MURK_FORAND_MIN && slope <= MURK_FORAND_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "slope mu of Fournier-Forand is %g, must be %g..%g",
                         slope, MURK_FORAND_MIN, MURK_FORAND_MAX);
    }
    /* A cached table, or a new one: power law, then nodes along the formula. */
    const forand f = {n, slope};
    const double key[2] = {n, slope};
    murk_phase_table *found = find_table(key, 1);
    if (found) {
        *out = found;
        return MURK_OK;
    }
    const double s = forand_head(&f);
    murk_phase_nodes nodes = {0};
    murk_phase_nodes_begin(&nodes, s, forand_density(&f, s), .5 * (slope - 5));
    murk_phase_nodes_law(&nodes, 2, forand_density, &f);
    const murk_status status = murk_phase_nodes_finish(out, &nodes, where, err);
    if (!status) {
        keep_table(*out, key, 1);
    }
    return status;
}

bool murk_phase_table_is_same(const murk_phase_table *a,
                              const murk_phase_table *b)
{
    return a == b ||
           (a->nodes == b->nodes && a->power == b->power &&
            memcmp(a->node, b->node, a->nodes * sizeof *a->node) == 0);
}
