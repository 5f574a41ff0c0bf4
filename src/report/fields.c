/* Grid tallies of a result folder as data of the page. Each band has three
 * slices through the middle of the grid; of a grid that is one cell thick along
 * an axis, only the slices at right angles to this axis are written. If there
 * are more cells than a map can show, every n-th cell is taken. A slice that is
 * one line of cells also has the standard errors. */
#include "report/fields.h"

#include "base/file.h"
#include "base/log.h"
#include "medium/grid.h"
#include "scene/places.h"
#include "world/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NAME_SIZE (MURK_SCENE_NAME_SIZE + 8)  /* "TALLY.vdb" */
#define FILE_SIZE (MURK_SCENE_NAME_SIZE + 16) /* "TALLY_error.vdb" */

/* ---- slices ---- */

/* A slice has the axes u and v of space, and lies in the middle of axis w, at
 * cell `at`. Along each of u and v, it has every step-th cell of the grid. */
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
        s.step[k] = (all[k] - 1) / MURK_REPORT_CELLS_MAX + 1;
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

/* True if a slice is written: of a grid that is one cell thick, only slices
 * normal to a thin axis that are more than one cell (for a single cell, the
 * first slice). */
static bool is_drawn(const murk_scene_tally *asked, int which)
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

/* Reads the slices of one grid of one file. On failure *out stays NULL, and
 * *why has the reason. */
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
        return murk_no_memory(why, name, "to read it");
    }
    murk_status status = murk_grid_read(&grid, path, grid_name, path, why);
    if (!status) {
        *out = take_slices(grid, field->asked);
        status = *out ? MURK_OK : murk_no_memory(why, name, "to draw it");
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
    *out = (murk_report_fields){.scene = results->scene};
    const murk_warn_sink sink = murk_warn_to(NULL); /* the run has printed the
                                                       warnings */
    const murk_status status =
        out->scene ? read_fields(out, results, err) : MURK_OK;
    murk_warn_to(sink);
    return status;
}

void murk_report_fields_release(murk_report_fields *fields)
{
    for (size_t i = 0; i < fields->fields; ++i) {
        free(fields->field[i].value);
        free(fields->field[i].error);
    }
    *fields = (murk_report_fields){0};
}

/* ---- data of the page ---- */

/* Adds one slice: its axes, extent, position and values, and for a line of
 * cells the errors. */
static void add_slice(murk_data *data, const murk_report_fields *all,
                      const murk_report_field *f, const slice *s, size_t begin)
{
    const murk_box box = murk_scene_user_box(all->scene, f->asked->box);
    const int axes[3] = {s->u, s->v, s->w};
    const double axis[3] = {s->u, s->v, s->w};
    const double size[2] = {(double)s->size[0], (double)s->size[1]};
    const size_t n = s->size[0] * s->size[1];
    double ends[3][2];
    for (int k = 0; k < 3; ++k) {
        ends[k][0] = murk_component(box.min, axes[k]);
        ends[k][1] = murk_component(box.max, axes[k]);
    }
    /* the position of the slice: the middle of its cells */
    char at[32];
    snprintf(at, sizeof at, "%.*g", murk_coordinate_digits(all->scene, 4),
             ends[2][0] + ((double)s->at + 0.5) / (double)f->asked->size[s->w] *
                              (ends[2][1] - ends[2][0]));
    murk_data_begin(data, NULL, '{');
    murk_data_numbers(data, "axes", axis, 3);
    murk_data_numbers(data, "x", ends[0], 2);
    murk_data_numbers(data, "y", ends[1], 2);
    murk_data_text(data, "at", at);
    murk_data_numbers(data, "size", size, 2);
    murk_data_floats(data, "values", f->value + begin, n);
    if (s->size[0] == 1 || s->size[1] == 1) {
        murk_data_floats(data, "errors", f->error + begin, n);
    }
    murk_data_end(data, '}');
}

void murk_report_fields_add(murk_data *data, const murk_report_fields *all)
{
    murk_data_number(data, "fields_asked", (double)all->asked);
    murk_data_begin(data, "fields", '[');
    for (size_t i = 0; i < all->fields; ++i) {
        const murk_report_field *f = &all->field[i];
        size_t begin = 0;
        murk_data_begin(data, NULL, '{');
        murk_data_text(data, "name", f->asked->name);
        murk_data_number(data, "band_nm", f->band_nm);
        murk_data_number(data, "bands", all->scene->bands);
        murk_data_text(data, "unit",
                       murk_units_of(all->scene->units).irradiance);
        if (!f->value || !f->error) {
            murk_data_text(data, "note", f->note);
        }
        /* the slices that are drawn */
        murk_data_begin(data, "slices", '[');
        for (int which = 0; which < 3 && f->value && f->error; ++which) {
            const slice s = slice_of(f->asked, which);
            if (is_drawn(f->asked, which)) {
                add_slice(data, all, f, &s, begin);
            }
            begin += s.size[0] * s.size[1];
        }
        murk_data_end(data, ']');
        murk_data_end(data, '}');
    }
    murk_data_end(data, ']');
}
