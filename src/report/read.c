/* What the view shows of studies, timelines, fits and explorations: the sensors
 * of each row of a study and of each step of a timeline, the readings of
 * fit.csv, and the stops of path.ply. */
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
#define STOP      6     /* bytes of a vertex of path.ply after its position */
#define CORNER    2     /* `kind` of a vertex */

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

/* Adds a state with the sensors of `of`, if there are any; when all states are
 * used, it is only counted. */
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
    for (size_t i = 0; i < murk_result_entries(axes); ++i) {
        const char *value = murk_result_text(axes->child[i], "");
        if (at > 0 && (size_t)at < size) {
            at += snprintf(out + at, size - (size_t)at, "%s %.60s %.40s",
                           i > 0 ? "," : ":", axes->key[i], value ? value : "");
        }
    }
}

/* Sets *differ to whether the sensors of any row differ from those of `first`.
 * Rows without sensors are ignored. Compares all rows, also those beyond the
 * limit on states. */
static murk_status compare_rows(bool *differ, const murk_report_scene *of,
                                const murk_shown_state *first,
                                const murk_yaml *rows, size_t n,
                                murk_error *err)
{
    murk_status status = MURK_OK;
    *differ = false;
    for (size_t i = 0; i < n && !status && !*differ; ++i) {
        murk_shown_state row = {0};
        const murk_yaml *list = murk_result_at(rows->child[i], "sensors");
        if (murk_result_count(rows->child[i], "sensors") > 0) {
            status = murk_report_read_sensors(&row.sensor, &row.sensors,
                                              of->scene, list, err);
            *differ = !status && !same_sensors(first, &row);
        }
        free(row.sensor);
    }
    return status;
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
    for (size_t i = 0; i < n && !status; ++i) {
        char name[sizeof out->state->name];
        name_row(name, sizeof name, rows->child[i]);
        status = add_state(out, name, rows->child[i], err);
    }
    bool differ = true;
    if (!status && out->states > first + 1) {
        status = compare_rows(&differ, out, &out->state[first], rows, n, err);
    }
    if (!differ) { /* all rows have the same sensors, which are shown once */
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

/* ---- steps of a timeline ---- */

/* Adds a state with the sensors, the scene and the folder of a step. A step
 * whose plan cannot be read, such as one that failed, has no state. */
static murk_status add_step(murk_report_scene *out, const char *folder,
                            const murk_yaml *row, murk_error *err)
{
    murk_shown_state *state = &out->state[out->states];
    const double number = murk_result_number(row, "step");
    const char *failed = murk_result_text(row, "failed");
    char name[64];
    murk_yaml *plan = NULL;
    murk_error why = {0};
    murk_status status = MURK_OK;
    if (!(number >= 0 && number <= 1e6) || (failed && *failed)) {
        return MURK_OK;
    }
    snprintf(name, sizeof name, "steps/%04.0f", number);
    state->folder = murk_path_join(folder, name);
    char *path =
        state->folder ? murk_results_path(state->folder, "plan.json") : NULL;
    if (path && !murk_yaml_read(&plan, path, &why)) {
        status = murk_report_read_sensors(&state->sensor, &state->sensors,
                                          out->scene,
                                          murk_result_at(plan, "sensors"), err);
    }
    free(path);
    /* The names of types belong to the JSON: take those of the scene. */
    for (size_t i = 0; !status && i < state->sensors; ++i) {
        murk_shown_sensor *sensor = &state->sensor[i];
        sensor->type = sensor->of ? sensor->of->name : "";
    }
    /* The scene, for its media. */
    path = plan ? murk_results_path(state->folder,
                                    murk_results_scene(state->folder))
                : NULL;
    if (path) {
        (void)murk_scene_desc_read(&state->scene, path, NULL, 0, &why);
    }
    free(path);
    if (plan) {
        snprintf(state->name, sizeof state->name, "step %.0f: %.6g s", number,
                 murk_result_number(row, "t_s"));
        ++out->states;
    } else {
        free(state->folder);
        state->folder = NULL;
    }
    murk_yaml_destroy(plan);
    return status;
}

murk_status murk_report_read_follow(murk_report_scene *out, const char *folder,
                                    const murk_yaml *follow, murk_error *err)
{
    const murk_yaml *rows = murk_result_at(follow, "steps");
    const size_t n = murk_result_count(follow, "steps");
    const size_t max = MURK_SHOWN_STATES_MAX;
    const size_t shown = n < max ? n : max;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < shown && !status; ++i) {
        const size_t step = shown > 1 ? i * (n - 1) / (shown - 1) : 0;
        status = add_step(out, folder, rows->child[step], err);
    }
    out->states_asked = n;
    return status;
}

/* ---- fits ---- */

static murk_vec3 place_of(const murk_report_scene *of, size_t row,
                          const char *x, const char *y, const char *z)
{
    const murk_vec3 place = murk_vec(murk_table_value(of->fit, row, x),
                                     murk_table_value(of->fit, row, y),
                                     murk_table_value(of->fit, row, z));
    return of->scene ? murk_scene_local(of->scene, place) : place;
}

murk_status murk_report_read_fit(murk_report_scene *out, const char *folder,
                                 murk_error *err)
{
    murk_error why = {0};
    if (murk_results_table(&out->fit, folder, "fit.csv", &why)) {
        murk_report_scene_note(
            out, "fit.csv cannot be read, so readings are not shown", &why);
        return MURK_OK;
    }
    /* readings that have a place, relative to the local origin */
    const size_t rows = out->fit ? out->fit->rows : 0;
    out->reading = calloc(rows + 1, sizeof *out->reading);
    for (size_t i = 0; out->reading && i < rows; ++i) {
        murk_shown_reading one = {
            .place = place_of(out, i, "x_m", "y_m", "z_m"),
            .to = place_of(out, i, "x2_m", "y2_m", "z2_m"),
            .row = i};
        one.to = murk_is_shown(one.to) ? one.to : one.place;
        if (murk_is_shown(one.place) &&
            out->readings < MURK_SHOWN_READINGS_MAX) {
            out->reading[out->readings++] = one;
        }
    }
    return out->reading ? MURK_OK
                        : murk_no_memory(err, "fit.csv", "to read it");
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
    /* The stops come first. Reading ends at the first corner. */
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
    return out->stop ? MURK_OK : murk_no_memory(err, "path.ply", "to read it");
}
