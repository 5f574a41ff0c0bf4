/* Tallies of planes and spheres, in the report: tallies.csv. */
#include "transport/tallies.h"
#include "base/number.h"
#include "report/chart.h"
#include "report/chart_heat.h"
#include "report/html.h"
#include "report/sections.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TITLE_SIZE (2 * TEXT_SIZE)

#define TALLIES_MAX 40 /* that are drawn */
#define TEXT_SIZE   200

/* Rows of one tally, which follow each other. */
typedef struct part {
    const murk_table *table;
    const murk_scene_tally *asked; /* NULL: not known */
    const murk_scene_desc *scene;  /* NULL: likewise */
    size_t begin, end;
    size_t size[3]; /* bins along two axes of space, and by angle */
    size_t bands, directions;
    double band_nm[16];
    const char *direction[2];
    const char *name, *unit;
} part;

static const char *cell(const murk_table *t, size_t row, const char *column)
{
    const long c = murk_table_column(t, column);
    return c < 0 ? "" : t->cell[row * t->columns + (size_t)c];
}

static double number(const murk_table *t, size_t row, const char *column)
{
    double value = NAN;
    return murk_number_parse(cell(t, row, column), &value) ? value : NAN;
}

/* A whole number from 0 on, or SIZE_MAX. */
static size_t index_of(const murk_table *t, size_t row, const char *column)
{
    const double value = number(t, row, column);
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

/* What the rows hold; false where they are not a tally's. */
static bool measure(part *p)
{
    static const char *const bins[] = {"bin_i", "bin_j", "bin_k"};
    for (size_t row = p->begin; row < p->end; ++row) {
        const double nm = number(p->table, row, "band_nm");
        const char *direction = cell(p->table, row, "direction");
        for (size_t k = 0; k < 3; ++k) {
            const size_t i = index_of(p->table, row, bins[k]);
            if (i == SIZE_MAX) {
                return false;
            }
            p->size[k] = i + 1 > p->size[k] ? i + 1 : p->size[k];
        }
        if (band_of(p, nm) == p->bands) {
            if (p->bands == 16 || !isfinite(nm)) {
                return false;
            }
            p->band_nm[p->bands++] = nm;
        }
        if (direction_of(p, direction) == p->directions) {
            if (p->directions == 2) {
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

/* ---- values ---- */

/* Values and errors by [direction][band][k][j][i]; NULL when out of memory. */
static double *values_of(const part *p)
{
    const size_t n = p->end - p->begin;
    const size_t *size = p->size;
    double *out = malloc(2 * n * sizeof *out);
    for (size_t i = 0; out && i < 2 * n; ++i) {
        out[i] = NAN;
    }
    for (size_t row = p->begin; out && row < p->end; ++row) {
        const murk_table *t = p->table;
        const size_t d = direction_of(p, cell(t, row, "direction"));
        const size_t b = band_of(p, number(t, row, "band_nm"));
        size_t at = d * p->bands + b;
        at = at * size[2] + index_of(t, row, "bin_k");
        at = at * size[1] + index_of(t, row, "bin_j");
        at = at * size[0] + index_of(t, row, "bin_i");
        out[at] = number(t, row, "value");
        out[n + at] = number(t, row, "standard_error");
    }
    return out;
}

/* ---- axes ---- */

/* Which axis of space bins 0 or 1 lie along, and from where to where; false
 * where the scene does not say. */
static bool find_extent(const part *p, int which, char *axis, double range[2])
{
    if (!p->asked || !p->scene || !p->scene->has_domain) {
        return false;
    }
    int axes[2];
    const murk_tally_desc desc = {.type = MURK_TALLY_PLANE,
                                  .normal = p->asked->normal};
    const murk_box *box = &p->scene->domain.box;
    murk_tally_axes(&desc, axes);
    const int a = axes[which];
    *axis = "xyz"[a];
    range[0] = a == 0 ? box->min.x : a == 1 ? box->min.y : box->min.z;
    range[1] = a == 0 ? box->max.x : a == 1 ? box->max.y : box->max.z;
    return range[1] > range[0];
}

/* The name and ends of the axis along bins 0, 1 (space) or 2 (angle). */
static bool name_axis(char *out, size_t room, double range[2], const part *p,
                      int which)
{
    char axis = 'x';
    if (which == 2) {
        snprintf(out, room, "cosine with the plane's normal");
        range[0] = 0;
        range[1] = 1;
        return true;
    }
    if (find_extent(p, which, &axis, range)) {
        snprintf(out, room, "%c, m", axis);
        return true;
    }
    snprintf(out, room, which == 0 ? "bin i" : "bin j");
    range[0] = -0.5;
    range[1] = (double)p->size[which] - 0.5;
    return false;
}

/* ---- plots ---- */

/* Lines along the one axis that has bins: of each direction and band. */
static bool draw_lines(FILE *to, const part *p, const double *values, int along)
{
    const size_t n = p->size[along], all = p->end - p->begin;
    const size_t lines = p->bands * p->directions;
    const size_t shown =
        lines < MURK_CHART_SERIES_MAX ? lines : MURK_CHART_SERIES_MAX;
    char names[MURK_CHART_SERIES_MAX][TEXT_SIZE], axis[TEXT_SIZE];
    char title[TITLE_SIZE], y_title[TEXT_SIZE];
    double range[2];
    murk_chart_series series[MURK_CHART_SERIES_MAX] = {0};
    double *room = malloc(4 * n * shown * sizeof *room);
    if (!room) {
        return false;
    }
    name_axis(axis, sizeof axis, range, p, along);
    for (size_t k = 0; k < shown; ++k) {
        double *x = room + 4 * n * k, *y = x + n, *low = y + n, *high = low + n;
        for (size_t i = 0; i < n; ++i) {
            const double error = values[all + k * n + i];
            x[i] = range[0] +
                   ((double)i + 0.5) / (double)n * (range[1] - range[0]);
            y[i] = values[k * n + i];
            low[i] = y[i] - 1.96 * error;
            high[i] = y[i] + 1.96 * error;
        }
        snprintf(names[k], TEXT_SIZE, "%s%s%.6g nm", p->direction[k / p->bands],
                 p->direction[k / p->bands][0] ? ", " : "",
                 p->band_nm[k % p->bands]);
        series[k] = (murk_chart_series){.name = names[k],
                                        .n = n,
                                        .x = x,
                                        .y = y,
                                        .low = low,
                                        .high = high,
                                        .is_line = true};
    }
    snprintf(title, sizeof title, "Tally %s, with 95 %% intervals%s", p->name,
             shown < lines ? " (the first 8 lines; all are in tallies.csv)"
                           : "");
    snprintf(y_title, sizeof y_title, "%s a bin", p->unit);
    const murk_chart chart = {
        .title = title, .x_title = axis, .y_title = y_title};
    murk_chart_draw(to, &chart, series, shown);
    free(room);
    return true;
}

/* Of a range of cells that is summed over angles and bands: the map of a
 * direction. */
static bool draw_map(FILE *to, const part *p, const double *values,
                     size_t direction)
{
    const size_t cells = p->size[0] * p->size[1];
    const size_t layers = p->size[2] * p->bands;
    char axis[2][TEXT_SIZE], title[TITLE_SIZE], value_title[TEXT_SIZE];
    double range[2][2];
    const bool is_place = name_axis(axis[0], TEXT_SIZE, range[0], p, 0);
    name_axis(axis[1], TEXT_SIZE, range[1], p, 1);
    /* thinned by whole bins, which add up */
    const size_t by[2] = {(p->size[0] - 1) / MURK_HEAT_MAX + 1,
                          (p->size[1] - 1) / MURK_HEAT_MAX + 1};
    const size_t size[2] = {(p->size[0] + by[0] - 1) / by[0],
                            (p->size[1] + by[1] - 1) / by[1]};
    double *sum = calloc(size[0] * size[1], sizeof *sum);
    if (!sum) {
        return false;
    }
    for (size_t layer = 0; layer < layers; ++layer) {
        const double *of = values + (direction * layers + layer) * cells;
        for (size_t i = 0; i < cells; ++i) {
            sum[i / p->size[0] / by[1] * size[0] + i % p->size[0] / by[0]] +=
                of[i];
        }
    }
    snprintf(title, sizeof title, "Tally %s%s%s%s", p->name,
             p->direction[direction][0] ? ", " : "", p->direction[direction],
             layers > 1 ? ", all bands and angles" : "");
    snprintf(value_title, sizeof value_title, "%s a bin", p->unit);
    const murk_heat heat = {.title = title,
                            .x_title = axis[0],
                            .y_title = axis[1],
                            .value_title = value_title,
                            .x = {range[0][0], range[0][1]},
                            .y = {range[1][0], range[1][1]},
                            .size = {size[0], size[1]},
                            .value = sum,
                            .min = 0,
                            .max = NAN,
                            .is_equal = is_place};
    murk_heat_draw(to, &heat);
    free(sum);
    return true;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* "20 values, 12 of them lit, half of these known to 3 % or better" */
static bool write_errors(FILE *to, const part *p, const double *values)
{
    const size_t n = p->end - p->begin;
    double *share = malloc(n * sizeof *share);
    size_t lit = 0;
    if (!share) {
        return false;
    }
    for (size_t i = 0; i < n; ++i) {
        if (values[i] > 0 && isfinite(values[n + i])) {
            share[lit++] = values[n + i] / values[i];
        }
    }
    qsort(share, lit, sizeof *share, by_size);
    fprintf(to, "<p class=\"note\">%zu values, %zu of them lit", n, lit);
    if (lit > 0) {
        fprintf(to, ", half of these known to %.2g %% or better",
                100 * share[(lit - 1) / 2]);
    }
    fputs("; all are in tallies.csv.</p>\n", to);
    free(share);
    return true;
}

/* Single values: of each direction and band. */
static void write_values(FILE *to, const part *p, const double *values)
{
    const size_t n = p->end - p->begin;
    for (size_t i = 0; i < n; ++i) {
        char band[40];
        snprintf(band, sizeof band, "%.6g nm", p->band_nm[i % p->bands]);
        murk_page_row_begin(to, p->name);
        murk_page_cell_text(to, p->direction[i / p->bands]);
        murk_page_cell_text(to, band);
        murk_page_cell_estimate(to, values[i], values[n + i]);
        murk_page_cell_text(to, p->unit);
        murk_page_row_end(to);
    }
}

static bool draw_part(FILE *to, const part *p, const double *values)
{
    const bool has_i = p->size[0] > 1, has_j = p->size[1] > 1;
    const bool has_k = p->size[2] > 1;
    fputs("<h3>Tally ", to);
    murk_page_text(to, p->name);
    fputs("</h3>\n<div class=\"plans\">\n", to);
    bool is_whole = true;
    if (has_i + has_j + has_k == 1) {
        is_whole = draw_lines(to, p, values, has_i ? 0 : has_j ? 1 : 2);
    }
    for (size_t d = 0;
         has_i + has_j + has_k > 1 && is_whole && d < p->directions; ++d) {
        is_whole = draw_map(to, p, values, d);
    }
    fputs("</div>\n", to);
    return is_whole && write_errors(to, p, values);
}

/* ---- the section ---- */

/* The rows from `begin` on that are of one tally. */
static part part_at(const murk_table *t, size_t begin,
                    const murk_scene_desc *scene)
{
    part p = {.table = t,
              .scene = scene,
              .begin = begin,
              .end = begin,
              .name = cell(t, begin, "tally"),
              .unit = cell(t, begin, "unit")};
    while (p.end < t->rows && strcmp(cell(t, p.end, "tally"), p.name) == 0) {
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

typedef enum pass { VALUES, PLOTS } pass;

/* Tallies of one bin as rows of a table, then the others as plots. */
static bool write_parts(FILE *to, const murk_table *t,
                        const murk_scene_desc *scene, pass which)
{
    bool is_whole = true;
    size_t drawn = 0;
    for (size_t row = 0; is_whole && row < t->rows && drawn < TALLIES_MAX;) {
        part p = part_at(t, row, scene);
        const bool is_good = measure(&p);
        const bool is_single = p.end - p.begin == p.bands * p.directions;
        row = p.end;
        if (is_good && is_single == (which == VALUES)) {
            double *values = values_of(&p);
            is_whole = values != NULL;
            if (values && which == VALUES) {
                write_values(to, &p, values);
            } else if (values) {
                is_whole = draw_part(to, &p, values);
            }
            free(values);
            ++drawn;
        }
    }
    return is_whole;
}

static bool has_single(const murk_table *t, const murk_scene_desc *scene)
{
    for (size_t row = 0; row < t->rows;) {
        part p = part_at(t, row, scene);
        if (measure(&p) && p.end - p.begin == p.bands * p.directions) {
            return true;
        }
        row = p.end;
    }
    return false;
}

murk_status murk_report_tallies(FILE *to, const murk_results_in *results,
                                const murk_report_fields *fields,
                                murk_error *err)
{
    static const char *const heads[] = {"<tally", "<direction", "<band",
                                        "value", "<unit"};
    murk_table *table = NULL;
    murk_status status =
        murk_results_table(&table, results->folder, "tallies.csv", err);
    if (status || !table) {
        return status;
    }
    murk_page_section_begin(to, "tallies", "Tallies");
    murk_page_paragraph(
        to, "What was counted where: power through planes, and the light that "
            "passes a point from all sides (fluence rate) in grids and "
            "spheres. Plots have 95 % intervals.");
    bool is_whole = true;
    if (has_single(table, fields->scene)) {
        murk_page_table_begin(to, "Tallies of one bin", heads, 5);
        is_whole = write_parts(to, table, fields->scene, VALUES);
        murk_page_table_end(to);
    }
    is_whole = is_whole && write_parts(to, table, fields->scene, PLOTS) &&
               murk_report_fields_draw(to, fields);
    if (!is_whole) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
    }
    murk_page_section_end(to);
    murk_table_destroy(table);
    return status;
}
