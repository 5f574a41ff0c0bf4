/* Reads a measured profile of a coefficient from a CSV file, finds its columns
 * by the units in their names, and averages it into layers of equal height,
 * which keep the optical depth. */
#include "app/media_profile.h"

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

/* Upwards or downwards. */
typedef struct direction {
    const char *name;
    double sign;
} direction;

static const direction PLACES[] = {
    {"depth", -1}, {"z", 1}, {"height", 1}, {"altitude", 1}};

/* The number of bytes before the unit, and its factor; 0: none. */
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

static murk_status find_place(const murk_table *t, column *found,
                              murk_error *err)
{
    *found = (column){-1, 0};
    for (size_t i = 0; i < t->columns; ++i) {
        double factor;
        if (!is_place(t->name[i], &factor)) {
            continue;
        }
        if (found->at >= 0) {
            return murk_fail(err, MURK_BAD_VALUE, t->path,
                             "columns %s and %s, must have one of them",
                             t->name[found->at], t->name[i]);
        }
        *found = (column){(long)i, factor};
    }
    return found->at >= 0
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, t->path,
                           "no column of places, must have depth_m (down from "
                           "z = 0), or z_m, height_m or altitude_m (up)");
}

static murk_status find_coefficient(const murk_table *t, const char *wanted,
                                    column *found, murk_error *err)
{
    *found = (column){-1, 0};
    /* The column that the user names must have a unit. */
    if (wanted) {
        found->at = murk_table_column(t, wanted);
        if (found->at < 0) {
            return murk_fail(err, MURK_BAD_VALUE, t->path,
                             "--column %s: not a column of it", wanted);
        }
        return before_unit(wanted, COEFFICIENTS, &found->factor) > 0
                   ? MURK_OK
                   : murk_fail(err, MURK_BAD_VALUE, t->path,
                               "--column %s: no unit in its name, must end in "
                               "_per_m, _per_km, _per_cm, or [1/m], [1/km], "
                               "[1/cm]",
                               wanted);
    }
    /* Otherwise exactly one column may look like a coefficient. */
    for (size_t i = 0; i < t->columns; ++i) {
        double factor;
        if (before_unit(t->name[i], COEFFICIENTS, &factor) == 0) {
            continue;
        }
        if (found->at >= 0) {
            return murk_fail(err, MURK_BAD_VALUE, t->path,
                             "coefficients %s and %s, must choose with "
                             "--column",
                             t->name[found->at], t->name[i]);
        }
        *found = (column){(long)i, factor};
    }
    return found->at >= 0
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, t->path,
                           "no column of a coefficient, must have a name that "
                           "ends in _per_m, _per_km, _per_cm, or [1/m], "
                           "[1/km], [1/cm]");
}

/* Which rows count: those whose cell in a column is a text. */
typedef struct choice {
    long at; /* -1: all */
    const char *value;
} choice;

static murk_status find_choice(const murk_table *t, const char *rows,
                               choice *found, murk_error *err)
{
    *found = (choice){-1, NULL};
    for (size_t i = 0; rows && i < t->columns && found->at < 0; ++i) {
        const size_t n = strlen(t->name[i]);
        if (strncmp(rows, t->name[i], n) == 0 && rows[n] == '=') {
            *found = (choice){(long)i, rows + n + 1};
        }
    }
    return !rows || found->at >= 0
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, t->path,
                           "--rows %s: must be COLUMN=VALUE of a column of it",
                           rows);
}

/* The profile, from the top down. */
typedef struct profile {
    size_t n;
    double *z_m, *per_m; /* [n] each */
} profile;

static murk_status fail_at(const murk_table *t, size_t row, const column *c,
                           const char *text, murk_error *err)
{
    char where[128];
    snprintf(where, sizeof where, "%.80s:%d: %.30s", t->path, t->line[row],
             t->name[c->at]);
    return murk_fail(err, MURK_BAD_VALUE, where, "%s", text);
}

/* One row; *way is that of the rows before: 0 while unknown. */
static murk_status add_row(profile *p, const murk_table *t, size_t row,
                           const column *place, const column *coefficient,
                           int *way, murk_error *err)
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
        const double before = p->z_m[p->n - 1];
        const int step = (z > before) - (z < before);
        const bool is_third = p->n > 1 && z == p->z_m[p->n - 2] && step == 0;
        if ((*way && step && step != *way) || is_third) {
            snprintf(text, sizeof text,
                     "%.9g after %.9g, must go one way, each place twice at "
                     "most%s",
                     0 + z / place->factor, 0 + before / place->factor,
                     *way && step && step != *way
                         ? " (several casts? choose with --rows)"
                         : "");
            return fail_at(t, row, place, text, err);
        }
        *way = step ? step : *way;
    }
    p->z_m[p->n] = z;
    p->per_m[p->n++] = per_m * coefficient->factor;
    return MURK_OK;
}

static void turn_over(profile *p)
{
    for (size_t i = 0; i < p->n / 2; ++i) {
        const size_t k = p->n - 1 - i;
        const double z = p->z_m[i], per_m = p->per_m[i];
        p->z_m[i] = p->z_m[k];
        p->per_m[i] = p->per_m[k];
        p->z_m[k] = z;
        p->per_m[k] = per_m;
    }
}

static murk_status read_profile(profile *p, const murk_table *t,
                                const murk_profile_settings *settings,
                                char name[64], murk_error *err)
{
    column place, coefficient;
    choice rows;
    murk_status status = find_place(t, &place, err);
    if (!status) {
        status = find_coefficient(t, settings->column, &coefficient, err);
    }
    if (!status) {
        status = find_choice(t, settings->rows, &rows, err);
    }
    if (status) {
        return status;
    }
    /* Take the rows that the user chose. */
    snprintf(name, 64, "%.63s", t->name[coefficient.at]);
    p->z_m = calloc(t->rows + 1, sizeof *p->z_m);
    p->per_m = calloc(t->rows + 1, sizeof *p->per_m);
    if (!p->z_m || !p->per_m) {
        return murk_fail(err, MURK_NO_MEMORY, t->path, "no memory for %zu rows",
                         t->rows);
    }
    int way = 0;
    for (size_t row = 0; row < t->rows && !status; ++row) {
        const char *cell =
            rows.at >= 0 ? t->cell[row * t->columns + (size_t)rows.at] : NULL;
        if (!cell || strcmp(cell, rows.value) == 0) {
            status = add_row(p, t, row, &place, &coefficient, &way, err);
        }
    }
    /* A profile needs two places, and runs from the top down. */
    if (!status && !(p->n >= 2 && way)) {
        status = murk_fail(err, MURK_BAD_VALUE, t->path,
                           "%zu rows of a profile%s%s, must be 2 or more at "
                           "different places",
                           p->n, settings->rows ? " where " : "",
                           settings->rows ? settings->rows : "");
    }
    if (way > 0) {
        turn_over(p);
    }
    return status;
}

/* Sums each piece of the profile into the layers that it lies in, from the top
 * down; both go on as the other ends. */
static void fill(murk_profile_layers *out, const profile *p, double *sum)
{
    size_t layer = 0;
    for (size_t i = 0; i + 1 < p->n; ++i) {
        const double top = p->z_m[i], length = top - p->z_m[i + 1];
        double from = 0; /* below the piece's top */
        while (from < length) {
            const double ends =
                top - (out->top_m - (double)(layer + 1) * out->voxel_m);
            const bool is_last = layer + 1 == out->n;
            const double to = is_last ? length : fmin(length, ends);
            if (to > from) {
                const double middle = (from + to) / 2 / length;
                sum[layer] += (to - from) * (p->per_m[i] * (1 - middle) +
                                             p->per_m[i + 1] * middle);
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
    const double length = p->z_m[0] - p->z_m[p->n - 1];
    out->top_m = p->z_m[0];
    out->bottom_m = p->z_m[p->n - 1];
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
        return murk_fail(err, MURK_NO_MEMORY, settings->csv,
                         "no memory for %zu voxels", out->n);
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

static murk_status check_settings(const murk_profile_settings *settings,
                                  murk_error *err)
{
    if (!(settings->voxel_m >= 0 &&
          settings->voxel_m <= MURK_PROFILE_LENGTH_MAX_M)) {
        return murk_fail(err, MURK_BAD_VALUE, "--voxel",
                         "%g, must be more than 0 and at most %g m",
                         settings->voxel_m, MURK_PROFILE_LENGTH_MAX_M);
    }
    if (!(settings->width_m >= 0 &&
          settings->width_m <= MURK_PROFILE_LENGTH_MAX_M)) {
        return murk_fail(err, MURK_BAD_VALUE, "--width",
                         "%g, must be more than 0 and at most %g m",
                         settings->width_m, MURK_PROFILE_LENGTH_MAX_M);
    }
    return MURK_OK;
}

murk_status murk_profile_layers_read(murk_profile_layers *out,
                                     const murk_profile_settings *settings,
                                     murk_error *err)
{
    *out = (murk_profile_layers){.csv = settings->csv};
    profile p = {0};
    murk_table *table = NULL;
    murk_status status = check_settings(settings, err);
    if (!status) {
        status = murk_table_read(&table, settings->csv, err);
    }
    if (!status) {
        status = read_profile(&p, table, settings, out->column, err);
    }
    if (!status) {
        status = make_layers(out, &p, settings, err);
    }
    out->rows = p.n;
    free(p.z_m);
    free(p.per_m);
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
        return murk_fail(err, MURK_NO_MEMORY, path, "no memory for %zu voxels",
                         layers->n);
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
