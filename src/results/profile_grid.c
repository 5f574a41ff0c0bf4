/* Reads a measured profile of a coefficient from a CSV file, finds the columns
 * by the units in their names, averages the profile into layers of equal
 * height, which keep the optical depth, and writes the layers as a grid. */
#include "results/profile_grid.h"

#include "medium/grid_write.h"
#include "scene/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Layers and width where the user gives none; and an extinction far above that
 * of any matter that light enters. */
#define LAYERS_USUAL  100
#define WIDTH_USUAL_M 1000.0
#define PER_M_MAX     1e9

/* A unit at the end of a column's name, and what one of it is in m or 1/m. */
typedef struct unit {
    const char *text;
    double factor;
} unit;

static const unit LENGTHS[] = {{"_m", 1},      {"[m]", 1},    {"_km", 1000},
                               {"[km]", 1000}, {"_cm", 0.01}, {"[cm]", 0.01}};
static const unit COEFFICIENTS[] = {{"_per_m", 1},     {"[1/m]", 1},
                                    {"_per_km", 1e-3}, {"[1/km]", 1e-3},
                                    {"_per_cm", 100},  {"[1/cm]", 100}};

#define UNITS 6 /* of either */

/* Names of columns of places, and the sign that makes a height of their
 * values. */
static const struct {
    const char *name;
    double sign;
} PLACES[] = {{"depth", -1}, {"z", 1}, {"height", 1}, {"altitude", 1}};

/* Returns the number of bytes of a name before the unit at its end, and the
 * factor of the unit; 0 if the name has no unit. */
static size_t before_unit(const char *name, const unit *units, double *factor)
{
    const size_t length = strlen(name);
    for (int i = 0; i < UNITS; ++i) {
        const size_t n = strlen(units[i].text);
        if (length > n && strcmp(name + length - n, units[i].text) == 0) {
            *factor = units[i].factor;
            return length - n;
        }
    }
    return 0;
}

typedef struct column {
    long at;       /* -1: none */
    double factor; /* to m, upwards, or to 1/m */
} column;

static bool is_place(const char *name, double *factor)
{
    double unit_m;
    const size_t n = before_unit(name, LENGTHS, &unit_m);
    for (size_t i = 0; n > 0 && i < sizeof PLACES / sizeof *PLACES; ++i) {
        if (strlen(PLACES[i].name) == n &&
            strncmp(name, PLACES[i].name, n) == 0) {
            *factor = PLACES[i].sign * unit_m;
            return true;
        }
    }
    return false;
}

static bool is_coefficient(const char *name, double *factor)
{
    return before_unit(name, COEFFICIENTS, factor) > 0;
}

/* Finds the only column whose name `matches`. `two` and `remedy` are the
 * message if there are two such columns, `none` if there is none. */
static murk_status find_only(const murk_table *t,
                             bool (*matches)(const char *, double *),
                             column *found, const char *two, const char *remedy,
                             const char *none, murk_error *err)
{
    *found = (column){-1, 0};
    for (size_t i = 0; i < t->columns; ++i) {
        double factor;
        if (!matches(t->name[i], &factor)) {
            continue;
        }
        if (found->at >= 0) {
            return murk_fail(err, MURK_BAD_VALUE, t->path,
                             "%s %s and %s, must %s", two, t->name[found->at],
                             t->name[i], remedy);
        }
        *found = (column){(long)i, factor};
    }
    return found->at >= 0 ? MURK_OK
                          : murk_fail(err, MURK_BAD_VALUE, t->path, "%s", none);
}

static murk_status find_place(const murk_table *t, column *found,
                              murk_error *err)
{
    return find_only(t, is_place, found, "columns", "have one of them",
                     "no column of places, must have depth_m (down from z = "
                     "0), or z_m, height_m or altitude_m (up)",
                     err);
}

static murk_status find_coefficient(const murk_table *t, const char *wanted,
                                    column *found, murk_error *err)
{
    if (!wanted) {
        return find_only(t, is_coefficient, found, "coefficients",
                         "choose with options->column",
                         "no column of a coefficient, must have a name that "
                         "ends in _per_m, _per_km, _per_cm, or [1/m], [1/km], "
                         "[1/cm]",
                         err);
    }
    /* The column that the user names must have a unit. */
    found->at = murk_table_column(t, wanted);
    if (found->at < 0) {
        return murk_fail(err, MURK_BAD_VALUE, t->path,
                         "options->column %s: not a column of it", wanted);
    }
    return is_coefficient(wanted, &found->factor)
               ? MURK_OK
               : murk_fail(
                     err, MURK_BAD_VALUE, t->path,
                     "options->column %s: no unit in its name, must end in "
                     "_per_m, _per_km, _per_cm, or [1/m], [1/km], "
                     "[1/cm]",
                     wanted);
}

/* Finds the column that "COLUMN=VALUE" names, and the value. */
static murk_status find_choice(const murk_table *t, const char *rows,
                               size_t *at, const char **value, murk_error *err)
{
    for (size_t i = 0; i < t->columns; ++i) {
        const size_t n = strlen(t->name[i]);
        if (strncmp(rows, t->name[i], n) == 0 && rows[n] == '=') {
            *at = i;
            *value = rows + n + 1;
            return MURK_OK;
        }
    }
    return murk_fail(err, MURK_BAD_VALUE, t->path,
                     "options->rows %s: must be COLUMN=VALUE of a column of it",
                     rows);
}

typedef struct knot {
    double z_m, per_m;
} knot;

/* The profile, from the top down. */
typedef struct profile {
    size_t n;
    knot *knot; /* [n] */
} profile;

static murk_status fail_at(const murk_table *t, size_t row, const column *c,
                           const char *text, murk_error *err)
{
    char where[128];
    snprintf(where, sizeof where, "%.80s:%d: %.30s", t->path, t->line[row],
             t->name[c->at]);
    return murk_fail(err, MURK_BAD_VALUE, where, "%s", text);
}

/* Appends a row. *direction is the sign of the steps in height so far, 0 while
 * unknown. */
static murk_status add_row(profile *p, const murk_table *t, size_t row,
                           const column *place, const column *coefficient,
                           int *direction, murk_error *err)
{
    char text[200];
    double z, per_m;
    murk_status status = murk_table_number(t, row, place->at, NAN, &z, err);
    if (!status) {
        status = murk_table_number(t, row, coefficient->at, NAN, &per_m, err);
    }
    if (status) {
        return status;
    }
    if (!(fabs(z * place->factor) <= MURK_PROFILE_LENGTH_MAX_M)) {
        snprintf(text, sizeof text, "%g, must be at most %g m away", z,
                 MURK_PROFILE_LENGTH_MAX_M);
        return fail_at(t, row, place, text, err);
    }
    if (!(per_m >= 0 && per_m * coefficient->factor <= PER_M_MAX)) {
        snprintf(text, sizeof text, "%g, must be 0 to %g [1/m]", per_m,
                 PER_M_MAX);
        return fail_at(t, row, coefficient, text, err);
    }
    z = 0 + z * place->factor; /* and never -0 */
    if (p->n > 0) {
        const double before = p->knot[p->n - 1].z_m;
        const int step = (z > before) - (z < before);
        const bool is_third =
            p->n > 1 && z == p->knot[p->n - 2].z_m && step == 0;
        if ((*direction && step && step != *direction) || is_third) {
            snprintf(text, sizeof text,
                     "%.9g after %.9g, must go one way, each place twice at "
                     "most%s",
                     0 + z / place->factor, 0 + before / place->factor,
                     *direction && step && step != *direction
                         ? " (several casts? choose with options->rows)"
                         : "");
            return fail_at(t, row, place, text, err);
        }
        *direction = step ? step : *direction;
    }
    p->knot[p->n++] = (knot){z, per_m * coefficient->factor};
    return MURK_OK;
}

static void reverse(profile *p)
{
    for (size_t i = 0; i < p->n / 2; ++i) {
        const knot swap = p->knot[i];
        p->knot[i] = p->knot[p->n - 1 - i];
        p->knot[p->n - 1 - i] = swap;
    }
}

static murk_status read_profile(profile *p, const murk_table *t,
                                const murk_profile_settings *settings,
                                char name[64], murk_error *err)
{
    column place, coefficient;
    size_t chosen = 0;
    const char *value = NULL;
    murk_status status = find_place(t, &place, err);
    if (!status) {
        status = find_coefficient(t, settings->column, &coefficient, err);
    }
    if (!status && settings->rows) {
        status = find_choice(t, settings->rows, &chosen, &value, err);
    }
    if (status) {
        return status;
    }
    /* Take the rows that the user chose. */
    snprintf(name, 64, "%.63s", t->name[coefficient.at]);
    p->knot = calloc(t->rows + 1, sizeof *p->knot);
    if (!p->knot) {
        return murk_no_memory(err, t->path, "for %zu rows", t->rows);
    }
    int direction = 0;
    for (size_t row = 0; row < t->rows && !status; ++row) {
        if (!value || strcmp(t->cell[row * t->columns + chosen], value) == 0) {
            status = add_row(p, t, row, &place, &coefficient, &direction, err);
        }
    }
    /* A profile needs two places, and runs from the top down. */
    if (!status && !(p->n >= 2 && direction)) {
        status = murk_fail(err, MURK_BAD_VALUE, t->path,
                           "%zu rows of a profile%s%s, must be 2 or more at "
                           "different places",
                           p->n, settings->rows ? " where " : "",
                           settings->rows ? settings->rows : "");
    }
    if (direction > 0) {
        reverse(p);
    }
    return status;
}

/* Adds the integral of the coefficient over each piece of the profile, between
 * two knots, to the layers that the piece lies in, sum[out->n]. Pieces and
 * layers are followed together from the top down. */
static void fill(murk_profile_layers *out, const profile *p, double *sum)
{
    size_t layer = 0;
    for (size_t i = 0; i + 1 < p->n; ++i) {
        const knot *upper = &p->knot[i], *lower = &p->knot[i + 1];
        const double top = upper->z_m, length = top - lower->z_m;
        double from = 0; /* below the piece's top */
        while (from < length) {
            const double ends =
                top - (out->top_m - (double)(layer + 1) * out->voxel_m);
            const bool is_last = layer + 1 == out->n;
            const double to = is_last ? length : fmin(length, ends);
            if (to > from) {
                const double middle = (from + to) / 2 / length;
                sum[layer] += (to - from) * (upper->per_m * (1 - middle) +
                                             lower->per_m * middle);
                from = to;
            }
            layer += !is_last && ends <= length;
        }
    }
}

static murk_status make_layers(murk_profile_layers *out, const profile *p,
                               const murk_profile_settings *settings,
                               murk_error *err)
{
    const double length = p->knot[0].z_m - p->knot[p->n - 1].z_m;
    out->top_m = p->knot[0].z_m;
    out->bottom_m = p->knot[p->n - 1].z_m;
    out->voxel_m =
        settings->voxel_m > 0 ? settings->voxel_m : length / LAYERS_USUAL;
    out->width_m = settings->width_m > 0 ? settings->width_m : WIDTH_USUAL_M;
    /* rounding must not add a layer of nothing */
    const double layers = ceil(length / out->voxel_m * (1 - 1e-12));
    if (!(layers <= MURK_PROFILE_LAYERS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, settings->csv,
                         "%.3g voxels of %g m over %g m, must be at most %d",
                         layers, out->voxel_m, length, MURK_PROFILE_LAYERS_MAX);
    }
    out->n = layers < 1 ? 1 : (size_t)layers;
    out->per_m = calloc(out->n, sizeof *out->per_m);
    double *sum = calloc(out->n, sizeof *sum);
    if (!out->per_m || !sum) {
        free(sum);
        return murk_no_memory(err, settings->csv, "for %zu voxels", out->n);
    }
    fill(out, p, sum);
    double left = 0;
    for (size_t i = 0; i < out->n; ++i) {
        const double mean = sum[i] / out->voxel_m + left;
        out->per_m[i] = (float)fmax(0, mean);
        left = mean - (double)out->per_m[i];
        out->depth += sum[i];
    }
    free(sum);
    return MURK_OK;
}

murk_status murk_profile_layers_read(murk_profile_layers *out,
                                     const murk_profile_settings *settings,
                                     murk_error *err)
{
    *out = (murk_profile_layers){.n = 0};
    profile p = {0};
    murk_table *table = NULL;
    murk_status status = murk_table_read(&table, settings->csv, err);
    if (!status) {
        status = read_profile(&p, table, settings, out->column, err);
    }
    if (!status) {
        status = make_layers(out, &p, settings, err);
    }
    out->rows = p.n;
    free(p.knot);
    murk_table_destroy(table);
    return status;
}

void murk_profile_layers_release(murk_profile_layers *layers)
{
    free(layers->per_m);
    layers->per_m = NULL;
}

murk_status murk_profile_layers_write(const murk_profile_layers *layers,
                                      const char *path, murk_error *err)
{
    const size_t size[3] = {1, 1, layers->n};
    float *upwards = malloc(layers->n * sizeof *upwards);
    if (!upwards) {
        return murk_no_memory(err, path, "for %zu voxels", layers->n);
    }
    for (size_t i = 0; i < layers->n; ++i) {
        upwards[i] = layers->per_m[layers->n - 1 - i];
    }
    const char *const notes[] = {"unit", "1/m", "column", layers->column, NULL};
    const murk_grid_field field = {
        .name = "density", .value = upwards, .notes = notes};
    murk_affine place = murk_affine_identity();
    place.matrix[0][0] = place.matrix[1][1] = layers->width_m;
    place.matrix[2][2] = layers->voxel_m;
    place.shift = murk_vec(
        0, 0, layers->top_m - ((double)layers->n - 0.5) * layers->voxel_m);
    const murk_status status =
        murk_grid_write(path, &field, 1, size, &place, err);
    free(upwards);
    return status;
}
