/* Tallies of planes and spheres (tallies.csv) as data of the page.
 *
 * The rows of a tally are a full grid: bins along two axes of space and of
 * angle, bands, directions. A tally of one bin is sent as values; one with bins
 * along a single axis as lines; others as a map for each direction, summed over
 * angles and bands, in which neighbouring bins are added up if there are too
 * many. */
#include "report/sections.h"

#include "base/quantile.h"
#include "report/data.h"
#include "report/fields.h"
#include "transport/tallies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TALLIES_MAX    40 /* of the page */
#define LINES_MAX      8  /* in one plot */
#define BANDS_MAX      16 /* of a scene */
#define DIRECTIONS_MAX 2  /* forward and backward, up and down */
#define TITLE_SIZE     40 /* of the title of an axis: add_axis() */

/* The consecutive rows of one tally. */
typedef struct part {
    const murk_table *table;
    const murk_scene_tally *asked; /* of the scene; NULL: not known, or no
                                      plane */
    const murk_scene_desc *scene;  /* NULL: not known */
    size_t begin, end;
    size_t size[3]; /* bins along two axes of space, and by angle */
    size_t bands, directions;
    double band_nm[BANDS_MAX];
    const char *direction[DIRECTIONS_MAX];
    const char *name, *unit;
} part;

/* A cell as a whole number from 0 to below 1e6; SIZE_MAX: it is none. */
static size_t index_of(const murk_table *t, size_t row, const char *column)
{
    const double value = murk_table_value(t, row, column);
    return value >= 0 && value < 1e6 && value == floor(value) ? (size_t)value
                                                              : SIZE_MAX;
}

static size_t band_of(const part *p, double nm)
{
    size_t b = 0;
    while (b < p->bands && p->band_nm[b] != nm) {
        ++b;
    }
    return b;
}

static size_t direction_of(const part *p, const char *text)
{
    size_t d = 0;
    while (d < p->directions && strcmp(p->direction[d], text) != 0) {
        ++d;
    }
    return d;
}

/* ---- reading ---- */

/* The consecutive rows from `begin` on that have the same name of a tally. */
static part part_at(const murk_table *t, size_t begin,
                    const murk_scene_desc *scene)
{
    part p = {.table = t,
              .scene = scene,
              .begin = begin,
              .end = begin,
              .name = murk_table_text(t, begin, "tally"),
              .unit = murk_table_text(t, begin, "unit")};
    while (p.end < t->rows &&
           strcmp(murk_table_text(t, p.end, "tally"), p.name) == 0) {
        ++p.end;
    }
    for (size_t i = 0; scene && i < scene->n_tallies; ++i) {
        if (strcmp(scene->tallies[i].name, p.name) == 0 &&
            scene->tallies[i].type == MURK_TALLY_PLANE) {
            p.asked = &scene->tallies[i];
        }
    }
    return p;
}

/* Finds bins, bands and directions. False if the number of rows is not that of
 * a full grid of these, if a cell is not what a tally has, or if there are more
 * bands or directions than the limits above. */
static bool measure(part *p)
{
    static const char *const bins[] = {"bin_i", "bin_j", "bin_k"};
    for (size_t row = p->begin; row < p->end; ++row) {
        const double nm = murk_table_value(p->table, row, "band_nm");
        const char *direction = murk_table_text(p->table, row, "direction");
        for (size_t k = 0; k < 3; ++k) {
            const size_t i = index_of(p->table, row, bins[k]);
            if (i == SIZE_MAX) {
                return false;
            }
            p->size[k] = i + 1 > p->size[k] ? i + 1 : p->size[k];
        }
        /* Add a new band or direction; fail if there is no room for it. */
        if (band_of(p, nm) == p->bands) {
            if (p->bands == BANDS_MAX || !isfinite(nm)) {
                return false;
            }
            p->band_nm[p->bands++] = nm;
        }
        if (direction_of(p, direction) == p->directions) {
            if (p->directions == DIRECTIONS_MAX) {
                return false;
            }
            p->direction[p->directions++] = direction;
        }
    }
    const double cells = (double)p->size[0] * (double)p->size[1] *
                         (double)p->size[2] * (double)p->bands *
                         (double)p->directions;
    return p->end > p->begin && cells == (double)(p->end - p->begin);
}

/* Values, then standard errors, each as [direction][band][k][j][i]. The caller
 * frees the array; NULL when out of memory. */
static double *values_of(const part *p)
{
    const size_t n = p->end - p->begin;
    double *out = malloc(2 * n * sizeof *out);
    for (size_t i = 0; out && i < 2 * n; ++i) {
        out[i] = NAN;
    }
    for (size_t row = p->begin; out && row < p->end; ++row) {
        const murk_table *t = p->table;
        const size_t d = direction_of(p, murk_table_text(t, row, "direction"));
        const size_t b = band_of(p, murk_table_value(t, row, "band_nm"));
        size_t at = d * p->bands + b;
        at = at * p->size[2] + index_of(t, row, "bin_k");
        at = at * p->size[1] + index_of(t, row, "bin_j");
        at = at * p->size[0] + index_of(t, row, "bin_i");
        out[at] = murk_table_value(t, row, "value");
        out[n + at] = murk_table_value(t, row, "standard_error");
    }
    return out;
}

/* ---- axes ---- */

/* The axis of space along which bins i (which 0) or j (1) lie, and its ends.
 * False if the scene does not tell. */
static bool find_extent(const part *p, int which, char *axis, double range[2])
{
    if (!p->asked || !p->scene->has_domain) {
        return false;
    }
    int axes[2];
    const murk_tally_desc desc = {.type = MURK_TALLY_PLANE,
                                  .normal = p->asked->normal};
    const murk_box box = murk_scene_user_box(p->scene, p->scene->domain.box);
    murk_tally_axes(&desc, axes);
    const int a = axes[which];
    *axis = "xyz"[a];
    range[0] = a == 0 ? box.min.x : a == 1 ? box.min.y : box.min.z;
    range[1] = a == 0 ? box.max.x : a == 1 ? box.max.y : box.max.z;
    return range[1] > range[0];
}

/* Adds title, ends and number of bins of the axis of bins i (which 0), j (1) or
 * of angle (2), `by` of which are added up to one. Returns whether the axis is
 * a length. */
static bool add_axis(murk_data *data, const part *p, int which, size_t by)
{
    char axis = 'x', title[TITLE_SIZE];
    double range[2] = {0, 1};
    const bool is_place = which < 2 && find_extent(p, which, &axis, range);
    if (which == 2) {
        snprintf(title, sizeof title, "cosine with the plane's normal");
    } else if (is_place) {
        snprintf(title, sizeof title, "%c, m", axis);
    } else {
        snprintf(title, sizeof title, which == 0 ? "bin i" : "bin j");
        range[0] = -0.5;
        range[1] = (double)p->size[which] - 0.5;
    }
    murk_data_begin(data, NULL, '{');
    murk_data_text(data, "title", title);
    murk_data_numbers(data, "range", range, 2);
    murk_data_number(data, "bins", (double)((p->size[which] + by - 1) / by));
    murk_data_end(data, '}');
    return is_place;
}

/* ---- values ---- */

/* Adds the maps of all directions, summed over angles and bands, with by[0] *
 * by[1] bins added up to one. False when out of memory. */
static bool add_maps(murk_data *data, const part *p, const double *values,
                     const size_t by[2])
{
    const size_t cells = p->size[0] * p->size[1];
    const size_t layers = p->size[2] * p->bands;
    const size_t size[2] = {(p->size[0] + by[0] - 1) / by[0],
                            (p->size[1] + by[1] - 1) / by[1]};
    double *sum = calloc(p->directions * size[0] * size[1], sizeof *sum);
    for (size_t at = 0; sum && at < p->directions * layers * cells; ++at) {
        const size_t i = at % p->size[0] / by[0];
        const size_t j = at % cells / p->size[0] / by[1];
        const size_t direction = at / (layers * cells);
        sum[(direction * size[1] + j) * size[0] + i] += values[at];
    }
    if (sum) {
        murk_data_floats(data, "values", sum,
                         p->directions * size[0] * size[1]);
    }
    free(sum);
    return sum != NULL;
}

/* Adds the number of values, the number of those above 0 with a known error,
 * and the median relative error of these. False when out of memory. */
static bool add_errors(murk_data *data, const part *p, const double *values)
{
    const size_t n = p->end - p->begin;
    double *share = malloc(n * sizeof *share);
    size_t lit = 0;
    for (size_t i = 0; share && i < n; ++i) {
        if (values[i] > 0 && isfinite(values[n + i])) {
            share[lit++] = values[n + i] / values[i];
        }
    }
    if (lit > 0) {
        murk_sort(share, lit);
    }
    murk_data_number(data, "rows", (double)n);
    murk_data_number(data, "lit", (double)lit);
    murk_data_number(data, "known", lit > 0 ? share[(lit - 1) / 2] : NAN);
    free(share);
    return share != NULL;
}

static bool add_part(murk_data *data, const part *p, const double *values)
{
    const size_t n = p->end - p->begin, lines = p->bands * p->directions;
    const bool has[3] = {p->size[0] > 1, p->size[1] > 1, p->size[2] > 1};
    const int axes = has[0] + has[1] + has[2];
    const int along = has[0] ? 0 : has[1] ? 1 : 2;
    murk_data_begin(data, NULL, '{');
    murk_data_text(data, "name", p->name);
    murk_data_text(data, "unit", p->unit);
    murk_data_text(data, "kind",
                   axes == 0   ? "values"
                   : axes == 1 ? "lines"
                               : "maps");
    murk_data_numbers(data, "bands_nm", p->band_nm, p->bands);
    murk_data_begin(data, "directions", '[');
    for (size_t d = 0; d < p->directions; ++d) {
        murk_data_text(data, NULL, p->direction[d]);
    }
    murk_data_end(data, ']');
    murk_data_number(data, "layers", (double)(p->size[2] * p->bands));
    /* axes, and the number of bins that are added up along them */
    const size_t by[2] = {(p->size[0] - 1) / MURK_REPORT_CELLS_MAX + 1,
                          (p->size[1] - 1) / MURK_REPORT_CELLS_MAX + 1};
    bool is_place = false;
    murk_data_begin(data, "axes", '[');
    if (axes == 1) {
        (void)add_axis(data, p, along, 1);
    } else if (axes > 1) {
        is_place = add_axis(data, p, 0, by[0]);
        (void)add_axis(data, p, 1, by[1]);
    }
    murk_data_end(data, ']');
    murk_data_bool(data, "is_place", is_place);
    bool is_whole = add_errors(data, p, values);
    if (axes > 1) {
        is_whole = is_whole && add_maps(data, p, values, by);
    } else {
        const size_t shown = lines < LINES_MAX || axes == 0 ? lines : LINES_MAX;
        murk_data_floats(data, "values", values, n / lines * shown);
        murk_data_floats(data, "errors", values + n, n / lines * shown);
    }
    murk_data_end(data, '}');
    return is_whole;
}

murk_status murk_report_tallies(murk_data *data, const murk_results_in *results,
                                murk_error *err)
{
    murk_table *table = NULL;
    const murk_status status =
        murk_results_table(&table, results->folder, "tallies.csv", err);
    if (status || !table) {
        return status;
    }
    /* rows of one tally are consecutive; a tally whose rows are not a full grid
     * is left out */
    bool is_whole = true;
    size_t drawn = 0;
    murk_data_begin(data, "tallies", '[');
    for (size_t row = 0;
         is_whole && row < table->rows && drawn < TALLIES_MAX;) {
        part p = part_at(table, row, results->scene);
        row = p.end;
        if (measure(&p)) {
            double *values = values_of(&p);
            is_whole = values && add_part(data, &p, values);
            free(values);
            ++drawn;
        }
    }
    murk_data_end(data, ']');
    murk_table_destroy(table);
    return is_whole ? MURK_OK : murk_no_memory(err, "", "for the plots");
}
