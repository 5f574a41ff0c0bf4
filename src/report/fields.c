#include "report/fields.h"

#include "base/file.h"
#include "base/log.h"
#include "medium/grid.h"
#include "report/chart.h"
#include "report/chart_heat.h"
#include "report/html.h"
#include "scene/places.h"
#include "world/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TITLE_SIZE (2 * TEXT_SIZE)

#define NAME_SIZE (MURK_SCENE_NAME_SIZE + 8)

#define FILE_SIZE (MURK_SCENE_NAME_SIZE + 16)

#define TEXT_SIZE 200

/* Largest over middle value from which on colours are by logarithms. */
#define LOG_RATIO 30

/* ---- slices ---- */

/* A slice has the axes u and v of space, and lies in the middle of the third.
 * Its cells are every step-th of the grid. */
typedef struct slice {
    int u, v, w;
    size_t size[2], step[2], at;
} slice;

static const slice slices[3] = {{.u = 0, .v = 1, .w = 2},
                                {.u = 0, .v = 2, .w = 1},
                                {.u = 1, .v = 2, .w = 0}};

static slice slice_of(const murk_scene_tally *asked, int which)
{
    slice s = slices[which];
    const size_t all[2] = {asked->size[s.u], asked->size[s.v]};
    for (int k = 0; k < 2; ++k) {
        s.step[k] = (all[k] - 1) / MURK_HEAT_MAX + 1;
        s.size[k] = (all[k] + s.step[k] - 1) / s.step[k];
    }
    s.at = asked->size[s.w] / 2;
    return s;
}

static size_t cells_of(const murk_scene_tally *asked, int which)
{
    const slice s = slice_of(asked, which);
    return s.size[0] * s.size[1];
}

/* Those that tell something new: of a flat grid the one along it. */
static bool is_told(const murk_scene_tally *asked, int which)
{
    const slice *s = &slices[which];
    const size_t *n = asked->size;
    const bool is_flat = n[0] == 1 || n[1] == 1 || n[2] == 1;
    return is_flat ? n[s->w] == 1 && (n[s->u] > 1 || n[s->v] > 1 || which == 0)
                   : true;
}

static double *take_slices(const murk_grid *grid, const murk_scene_tally *asked)
{
    size_t n = 0, at = 0;
    for (int k = 0; k < 3; ++k) {
        n += cells_of(asked, k);
    }
    double *out = malloc(n * sizeof *out);
    for (int which = 0; out && which < 3; ++which) {
        const slice s = slice_of(asked, which);
        for (size_t j = 0; j < s.size[1]; ++j) {
            for (size_t i = 0; i < s.size[0]; ++i) {
                int64_t index[3];
                index[s.u] = (int64_t)(i * s.step[0]);
                index[s.v] = (int64_t)(j * s.step[1]);
                index[s.w] = (int64_t)s.at;
                out[at++] = murk_grid_value(grid, index[0], index[1], index[2]);
            }
        }
    }
    return out;
}

/* ---- reading ---- */

/* The slices of one grid of one file; *out stays NULL, and why says why, where
 * it cannot be read. */
static murk_status read_grid(double **out, const murk_results_in *results,
                             const murk_report_field *field, const char *ending,
                             murk_error *why)
{
    char name[FILE_SIZE], grid_name[48];
    murk_grid *grid = NULL;
    snprintf(name, sizeof name, "%s%s.vdb", field->asked->name, ending);
    snprintf(grid_name, sizeof grid_name, "fluence_%.9gnm", field->band_nm);
    char *path = murk_path_join(results->folder, name);
    if (!path) {
        return murk_fail(why, MURK_NO_MEMORY, name, "no memory to read it");
    }
    murk_status status = murk_grid_read(&grid, path, grid_name, path, why);
    if (!status) {
        *out = take_slices(grid, field->asked);
        status =
            *out ? MURK_OK
                 : murk_fail(why, MURK_NO_MEMORY, name, "no memory to draw it");
    }
    murk_grid_destroy(grid);
    free(path);
    return status;
}

static murk_status read_field(murk_report_fields *out, size_t tally, int band,
                              const murk_results_in *results, murk_error *err)
{
    murk_error why = {0};
    if (out->asked++ >= MURK_REPORT_FIELDS_MAX) {
        return MURK_OK;
    }
    murk_report_field *f = &out->field[out->fields++];
    f->asked = &out->scene->tallies[tally];
    f->band_nm = out->scene->band_nm[band];
    murk_status status = read_grid(&f->value, results, f, "", &why);
    if (!status) {
        status = read_grid(&f->error, results, f, "_error", &why);
    }
    if (status == MURK_NO_MEMORY) {
        return murk_fail(err, status, why.where, "%s", why.text);
    }
    if (status) {
        snprintf(f->note, sizeof f->note, "%.120s: %.180s", f->asked->name,
                 why.text);
    }
    return MURK_OK;
}

static murk_status read_fields(murk_report_fields *out,
                               const murk_results_in *results, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < out->scene->n_tallies; ++i) {
        char name[NAME_SIZE];
        const murk_scene_tally *asked = &out->scene->tallies[i];
        snprintf(name, sizeof name, "%s.vdb", asked->name);
        const bool is_there = asked->type == MURK_TALLY_GRID &&
                              murk_results_has(results->folder, name);
        for (int b = 0; is_there && !status && b < out->scene->bands; ++b) {
            status = read_field(out, i, b, results, err);
        }
    }
    return status;
}

murk_status murk_report_fields_read(murk_report_fields *out,
                                    const murk_results_in *results,
                                    murk_error *err)
{
    *out = (murk_report_fields){0};
    if (!murk_results_has(results->folder,
                          murk_results_scene(results->folder))) {
        return MURK_OK;
    }
    murk_error why = {0};
    const murk_warn_sink told = murk_warn_to(NULL); /* by the run */
    char *path =
        murk_path_join(results->folder, murk_results_scene(results->folder));
    murk_status status = MURK_OK;
    if (!path) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory to read it");
    } else if (!murk_scene_desc_read(&out->scene, path, NULL, 0, &why)) {
        status = read_fields(out, results, err);
    }
    free(path);
    murk_warn_to(told);
    return status;
}

void murk_report_fields_release(murk_report_fields *fields)
{
    for (size_t i = 0; i < fields->fields; ++i) {
        free(fields->field[i].value);
        free(fields->field[i].error);
    }
    murk_scene_desc_destroy(fields->scene);
    *fields = (murk_report_fields){0};
}

/* ---- drawing ---- */

static double along(murk_vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Whether the largest value is far above the middle of those above 0. */
static bool spans_decades(const double *value, size_t n)
{
    double *lit = malloc((n + 1) * sizeof *lit);
    size_t m = 0;
    for (size_t i = 0; lit && i < n; ++i) {
        if (value[i] > 0) {
            lit[m++] = value[i];
        }
    }
    if (m > 0) {
        qsort(lit, m, sizeof *lit, by_size);
    }
    const bool spans = m > 0 && lit[m - 1] > LOG_RATIO * lit[m / 2];
    free(lit);
    return spans;
}

static void name_field(char out[TEXT_SIZE], const murk_report_fields *all,
                       const murk_report_field *f)
{
    if (all->scene->bands > 1) {
        snprintf(out, TEXT_SIZE, "%s at %.6g nm", f->asked->name, f->band_nm);
    } else {
        snprintf(out, TEXT_SIZE, "%s", f->asked->name);
    }
}

static void draw_map(FILE *to, const murk_report_fields *all,
                     const murk_report_field *f, int which, const double *value,
                     bool is_log)
{
    const slice s = slice_of(f->asked, which);
    const murk_box user = murk_scene_user_box(all->scene, f->asked->box);
    const murk_box *box = &user;
    char name[TEXT_SIZE], title[TITLE_SIZE];
    const char axis[2][5] = {{"xyz"[s.u], ',', ' ', 'm', 0},
                             {"xyz"[s.v], ',', ' ', 'm', 0}};
    const double low = along(box->min, s.w), high = along(box->max, s.w);
    const size_t n = f->asked->size[s.w];
    name_field(name, all, f);
    snprintf(title, sizeof title, "Fluence rate %s at %c = %.*g m", name,
             "xyz"[s.w], murk_coordinate_digits(all->scene, 4),
             low + ((double)s.at + 0.5) / (double)n * (high - low));
    const murk_heat heat = {.title = title,
                            .x_title = axis[0],
                            .y_title = axis[1],
                            .value_title =
                                murk_units_of(all->scene->units).irradiance,
                            .x = {along(box->min, s.u), along(box->max, s.u)},
                            .y = {along(box->min, s.v), along(box->max, s.v)},
                            .size = {s.size[0], s.size[1]},
                            .value = value,
                            .min = is_log ? NAN : 0,
                            .max = NAN,
                            .is_log = is_log,
                            .is_equal = true};
    murk_heat_draw(to, &heat);
}

/* A grid of one row of cells: a line with its 95 % interval. */
static bool draw_line(FILE *to, const murk_report_fields *all,
                      const murk_report_field *f, int which, size_t begin)
{
    const slice s = slice_of(f->asked, which);
    const int axis = s.size[0] > 1 ? s.u : s.v;
    const size_t n = s.size[0] * s.size[1];
    const murk_box box = murk_scene_user_box(all->scene, f->asked->box);
    const double low_m = along(box.min, axis);
    const double high_m = along(box.max, axis);
    char name[TEXT_SIZE], title[TITLE_SIZE];
    const char axis_title[] = {"xyz"[axis], ',', ' ', 'm', 0};
    double *x = malloc(3 * n * sizeof *x);
    if (!x) {
        return false;
    }
    double *low = x + n, *high = low + n;
    for (size_t i = 0; i < n; ++i) {
        x[i] = low_m + ((double)i + 0.5) / (double)n * (high_m - low_m);
        low[i] = f->value[begin + i] - 1.96 * f->error[begin + i];
        high[i] = f->value[begin + i] + 1.96 * f->error[begin + i];
    }
    name_field(name, all, f);
    snprintf(title, sizeof title, "Fluence rate %s, with its 95 %% interval",
             name);
    const murk_chart_series series = {.name = name,
                                      .n = n,
                                      .x = x,
                                      .y = f->value + begin,
                                      .low = low,
                                      .high = high,
                                      .is_line = true};
    const murk_chart chart = {.title = title,
                              .x_title = axis_title,
                              .y_title =
                                  murk_units_of(all->scene->units).irradiance};
    murk_chart_draw(to, &chart, &series, 1);
    free(x);
    return true;
}

static bool draw_field(FILE *to, const murk_report_fields *all,
                       const murk_report_field *f)
{
    size_t begin = 0, n = 0;
    for (int k = 0; k < 3; ++k) {
        n += cells_of(f->asked, k);
    }
    const bool is_log = spans_decades(f->value, n);
    for (int which = 0; which < 3; ++which) {
        const slice s = slice_of(f->asked, which);
        if (is_told(f->asked, which)) {
            if (s.size[0] > 1 && s.size[1] > 1) {
                draw_map(to, all, f, which, f->value + begin, is_log);
            } else {
                return draw_line(to, all, f, which, begin);
            }
        }
        begin += s.size[0] * s.size[1];
    }
    return true;
}

bool murk_report_fields_draw(FILE *to, const murk_report_fields *fields)
{
    bool is_whole = true;
    const char *last = "";
    for (size_t i = 0; is_whole && i < fields->fields; ++i) {
        const murk_report_field *f = &fields->field[i];
        if (strcmp(f->asked->name, last) != 0) {
            last = f->asked->name;
            fputs("<h3>Tally ", to);
            murk_page_text(to, last);
            fputs("</h3>\n", to);
        }
        if (!f->value || !f->error) {
            fputs("<p class=\"note\">It cannot be shown: ", to);
            murk_page_text(to, f->note);
            fputs(".</p>\n", to);
            continue;
        }
        fputs("<div class=\"plans\">\n", to);
        is_whole = draw_field(to, fields, f);
        fputs("</div>\n", to);
    }
    if (fields->asked > fields->fields) {
        fprintf(to,
                "<p class=\"note\">The first %zu of %zu fields are drawn; all "
                "are in the .vdb files.</p>\n",
                fields->fields, fields->asked);
    }
    return is_whole;
}
