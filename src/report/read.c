/* What studies, fits and explorations leave in space, for the view: sensors of
 * each row of a study, readings of fit.csv, the stops of path.ply. */
#include "report/scene.h"

#include "base/file.h"
#include "base/inputs.h"
#include "scene/places.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RECORD_MAX (MURK_PLACE_BYTES_MAX + STOP) /* bytes of a vertex */

#define STOPS_MAX 20000 /* of a path: 0.5 MB of the page */
#define STOP      6     /* bytes of a vertex of path.ply behind its place */
#define CORNER    2     /* of a vertex's kind */

/* ---- studies ---- */

static bool same_sensors(const murk_shown_state *a, const murk_shown_state *b)
{
    bool is_same = a->sensors == b->sensors;
    for (size_t i = 0; is_same && i < a->sensors; ++i) {
        const murk_shown_sensor *x = &a->sensor[i], *y = &b->sensor[i];
        is_same = murk_length(murk_sub(x->place, y->place)) == 0 &&
                  strcmp(x->type, y->type) == 0 &&
                  !(x->heading_deg < y->heading_deg) &&
                  !(x->heading_deg > y->heading_deg) &&
                  !(x->tilt_deg < y->tilt_deg) && !(x->tilt_deg > y->tilt_deg);
    }
    return is_same;
}

/* One more state, where there is room and the list has any. */
static murk_status add_state(murk_report_scene *out, const char *name,
                             const murk_yaml *of, murk_error *err)
{
    if (murk_result_count(of, "sensors") == 0) {
        return MURK_OK;
    }
    ++out->states_asked;
    if (out->states == MURK_SHOWN_STATES_MAX) {
        return MURK_OK;
    }
    murk_shown_state *state = &out->state[out->states++];
    snprintf(state->name, sizeof state->name, "%s", name);
    return murk_report_read_sensors(&state->sensor, &state->sensors, out->scene,
                                    murk_result_at(of, "sensors"), err);
}

static void name_row(char *out, size_t size, const murk_yaml *row)
{
    const murk_yaml *axes = murk_result_at(row, "axes");
    int at = snprintf(out, size, "row %.0f", murk_result_number(row, "row"));
    for (size_t i = 0; axes && axes->kind == MURK_YAML_MAP && i < axes->n;
         ++i) {
        const char *value = murk_result_text(axes->child[i], "");
        if (at > 0 && (size_t)at < size) {
            at += snprintf(out + at, size - (size_t)at, "%s %.60s %.40s",
                           i > 0 ? "," : ":", axes->key[i], value ? value : "");
        }
    }
}

murk_status murk_report_read_study(murk_report_scene *out,
                                   const murk_yaml *study, murk_error *err)
{
    murk_status status = add_state(out, "one plan, for the mean of all rows",
                                   murk_result_at(study, "plans.mean"), err);
    if (!status) {
        status = add_state(out, "one plan, for the worst of all rows",
                           murk_result_at(study, "plans.worst"), err);
    }
    const murk_yaml *rows = murk_result_at(study, "rows");
    const size_t n = murk_result_count(study, "rows");
    const size_t first = out->states;
    bool differ = false;
    for (size_t i = 0; i < n && !status; ++i) {
        char name[sizeof out->state->name];
        name_row(name, sizeof name, rows->child[i]);
        status = add_state(out, name, rows->child[i], err);
    }
    for (size_t i = first + 1; i < out->states; ++i) {
        differ = differ || !same_sensors(&out->state[first], &out->state[i]);
    }
    if (!differ && out->states > first + 1) { /* a given plan: once is enough */
        for (size_t i = first + 1; i < out->states; ++i) {
            free(out->state[i].sensor);
            out->state[i] = (murk_shown_state){0};
        }
        out->states = out->states_asked = first + 1;
        snprintf(out->state[first].name, sizeof out->state->name,
                 "the plan of every row");
    }
    return status;
}

/* ---- fits ---- */

static double number_of(const murk_table *table, size_t row, long column)
{
    double value = NAN;
    murk_error ignored = {0};
    return column >= 0 &&
                   table->cell[row * table->columns + (size_t)column][0] &&
                   !murk_table_number(table, row, column, 0, &value, &ignored)
               ? value
               : NAN;
}

static void copy_cell(char *out, size_t size, const murk_table *table,
                      size_t row, const char *name)
{
    const long column = murk_table_column(table, name);
    snprintf(out, size, "%s",
             column >= 0 ? table->cell[row * table->columns + (size_t)column]
                         : "");
}

static murk_vec3 place_of(const murk_table *table, size_t row,
                          const char *const names[3])
{
    double v[3];
    for (int k = 0; k < 3; ++k) {
        v[k] = number_of(table, row, murk_table_column(table, names[k]));
    }
    return murk_vec(v[0], v[1], v[2]);
}

static murk_shown_reading reading_of(const murk_table *table, size_t row)
{
    static const char *const from[] = {"x_m", "y_m", "z_m"};
    static const char *const end[] = {"x2_m", "y2_m", "z2_m"};
    murk_shown_reading r = {.place = place_of(table, row, from),
                            .to = place_of(table, row, end)};
    char use[16];
    const struct {
        const char *name;
        double *to;
    } numbers[] = {{"residual_in_standard_errors", &r.residual},
                   {"value", &r.value},
                   {"standard_error", &r.standard_error},
                   {"predicted", &r.predicted},
                   {"line", &r.line}};
    /* a cell without a number leaves NaN: not known */
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
        *numbers[i].to =
            number_of(table, row, murk_table_column(table, numbers[i].name));
    }
    copy_cell(r.kind, sizeof r.kind, table, row, "kind");
    copy_cell(r.unit, sizeof r.unit, table, row, "unit");
    copy_cell(r.condition, sizeof r.condition, table, row, "condition");
    copy_cell(use, sizeof use, table, row, "use");
    r.is_held_out = strcmp(use, "hold_out") == 0;
    r.to = murk_is_shown(r.to) ? r.to : r.place;
    return r;
}

murk_status murk_report_read_fit(murk_report_scene *out, const char *folder,
                                 murk_error *err)
{
    murk_table *table = NULL;
    murk_error why = {0};
    if (murk_results_table(&table, folder, "fit.csv", &why)) {
        murk_report_scene_note(
            out, "fit.csv cannot be read, so readings are not shown", &why);
        return MURK_OK;
    }
    /* readings that have a place, about the scene's local origin */
    const size_t rows = table ? table->rows : 0;
    out->reading = calloc(rows + 1, sizeof *out->reading);
    for (size_t i = 0; out->reading && i < rows; ++i) {
        murk_shown_reading one = reading_of(table, i);
        if (out->scene) {
            one.place = murk_scene_local(out->scene, one.place);
            one.to = murk_scene_local(out->scene, one.to);
        }
        if (murk_is_shown(one.place) &&
            out->readings < MURK_SHOWN_READINGS_MAX) {
            out->reading[out->readings++] = one;
        }
    }
    murk_table_destroy(table);
    return out->reading ? MURK_OK
                        : murk_fail(err, MURK_NO_MEMORY, "fit.csv",
                                    "no memory to read it");
}

/* ---- explorations ---- */

murk_status murk_report_read_path(murk_report_scene *out, const char *folder,
                                  murk_error *err)
{
    if (!murk_results_has(folder, "path.ply")) {
        return MURK_OK;
    }
    char *path = murk_path_join(folder, "path.ply");
    FILE *file = path ? murk_inputs_open(path) : NULL;
    out->stop = calloc(STOPS_MAX, sizeof *out->stop);
    uint64_t n = 0;
    const bool is_path =
        file && out->stop &&
        murk_ply_begin(file, &n,
                       "ply\nformat binary_little_endian 1.0\n"
                       "comment murk path",
                       "property uchar red\nproperty uchar green\n"
                       "property uchar blue\nproperty uchar kind\n"
                       "property ushort step\n",
                       out->scene);
    /* corners of the way follow the stops */
    unsigned char bytes[RECORD_MAX];
    for (uint64_t i = 0; is_path && i < n && out->stops < STOPS_MAX; ++i) {
        const size_t place = murk_place_bytes(out->scene);
        if (fread(bytes, place + STOP, 1, file) != 1 ||
            bytes[place + 3] >= CORNER) {
            break;
        }
        const murk_vec3 at = murk_place_take(out->scene, bytes);
        if (murk_is_shown(at)) {
            out->stop[out->stops++] = at;
        }
    }
    if (file) {
        fclose(file);
    }
    if (out->stops == 0) {
        const murk_error why = {.text = "not a path.ply of this version"};
        murk_report_scene_note(out, "The path is not shown", &why);
    }
    free(path);
    return out->stop ? MURK_OK
                     : murk_fail(err, MURK_NO_MEMORY, "path.ply",
                                 "no memory to read it");
}
