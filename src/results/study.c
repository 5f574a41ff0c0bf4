#include "results/study.h"

#include "results/coverage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Names of values, in the order in which rows first have them. */
typedef struct columns {
    size_t n, room;
    const char **name;
} columns;

static bool has(const columns *c, const char *name)
{
    for (size_t i = 0; i < c->n; ++i) {
        if (strcmp(c->name[i], name) == 0) {
            return true;
        }
    }
    return false;
}

static bool collect(columns *c, const murk_study_row *row)
{
    for (size_t i = 0; i < row->values; ++i) {
        if (has(c, row->value[i].name)) {
            continue;
        }
        if (c->n == c->room) {
            const size_t room = c->room ? 2 * c->room : 16;
            const char **grown = realloc(c->name, room * sizeof *grown);
            if (!grown) {
                return false;
            }
            c->name = grown;
            c->room = room;
        }
        c->name[c->n++] = row->value[i].name;
    }
    return true;
}

/* ---- table.csv ---- */

static void write_cell(FILE *file, const char *text)
{
    if (!strpbrk(text, ",\"\r\n")) {
        fputs(text, file);
        return;
    }
    fputc('"', file);
    for (; *text; ++text) {
        if (*text == '"') {
            fputc('"', file);
        }
        fputc(*text, file);
    }
    fputc('"', file);
}

static void write_number(FILE *file, double value)
{
    char text[32] = "";
    if (isfinite(value)) {
        murk_number_text(text, value);
    }
    fprintf(file, ",%s", text);
}

static void write_header(FILE *file, const murk_study_file *study,
                         const columns *c)
{
    for (size_t a = 0; a < study->axes; ++a) {
        write_cell(file, study->axis[a].name);
        fputc(',', file);
    }
    for (size_t i = 0; i < c->n; ++i) {
        write_cell(file, c->name[i]);
        fputc(',', file);
        write_cell(file, c->name[i]);
        fputs("_standard_error,", file);
    }
    fputs("failed\n", file);
}

static void write_row(FILE *file, const murk_sweep *sweep, size_t row,
                      const columns *c)
{
    const murk_study_file *study = sweep->desc.study;
    const murk_study_row *found = &sweep->row[row].found;
    size_t index[MURK_STUDY_AXES_MAX];
    murk_study_row_indices(study, row, index);
    for (size_t a = 0; a < study->axes; ++a) {
        fputs(a ? "," : "", file);
        write_cell(file, study->axis[a].text[index[a]]);
    }
    for (size_t i = 0; i < c->n; ++i) {
        const murk_study_value *v = murk_study_row_get(found, c->name[i]);
        if (i == 0 && study->axes == 0) {
            char text[32] = "";
            if (v && isfinite(v->of.value)) {
                murk_number_text(text, v->of.value);
            }
            fputs(text, file);
        } else {
            write_number(file, v ? v->of.value : NAN);
        }
        write_number(file, v ? v->of.standard_error : NAN);
    }
    fputs(study->axes + c->n > 0 ? "," : "", file);
    write_cell(file, found->failed);
    fputc('\n', file);
}

static murk_status write_table(const char *path, const void *context,
                               murk_error *err)
{
    const murk_sweep *sweep = context;
    const size_t rows = sweep->desc.study->rows;
    columns c = {0};
    murk_file *file = NULL;
    murk_status status = murk_file_create(&file, path, err);
    bool is_whole = true;
    for (size_t i = 0; !status && is_whole && i < rows; ++i) {
        is_whole = collect(&c, &sweep->row[i].found);
    }
    if (!status && !is_whole) {
        status = murk_fail(err, MURK_NO_MEMORY, path, "no memory to write it");
    }
    if (!status) {
        write_header(murk_file_stream(file), sweep->desc.study, &c);
        for (size_t i = 0; i < rows; ++i) {
            if (sweep->row[i].is_done) {
                write_row(murk_file_stream(file), sweep, i, &c);
            }
        }
        status = murk_file_commit(&file, err);
    }
    murk_file_discard(file);
    free(c.name);
    return status;
}

murk_status murk_add_table(murk_results *results, const murk_sweep *sweep,
                           murk_error *err)
{
    return murk_results_add(results, "table.csv", write_table, sweep, err);
}

/* ---- study.json ---- */

static void add_axes(cJSON *root, const murk_study_file *study)
{
    cJSON *list = cJSON_AddArrayToObject(root, "axes");
    for (size_t a = 0; a < study->axes; ++a) {
        const murk_study_axis *axis = &study->axis[a];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "key", axis->name);
        cJSON *values = cJSON_AddArrayToObject(item, "values");
        for (size_t i = 0; i < axis->n; ++i) {
            cJSON_AddItemToArray(values, cJSON_CreateString(axis->text[i]));
        }
        cJSON_AddItemToArray(list, item);
    }
}

static void add_values(cJSON *item, const murk_study_row *row)
{
    cJSON *values = cJSON_AddObjectToObject(item, "values");
    for (size_t i = 0; i < row->values; ++i) {
        const murk_study_value *v = &row->value[i];
        cJSON *value = cJSON_AddObjectToObject(values, v->name);
        murk_json_number(value, "value", v->of.value);
        murk_json_number(value, "standard_error", v->of.standard_error);
        cJSON_AddStringToObject(value, "unit", v->unit);
    }
}

static void add_sensors(cJSON *item, const char *name,
                        const murk_study_sensor *sensor, size_t n)
{
    cJSON *list = cJSON_AddArrayToObject(item, name);
    for (size_t i = 0; i < n; ++i) {
        cJSON *one = cJSON_CreateObject();
        cJSON_AddStringToObject(one, "type", sensor[i].type);
        murk_json_vector(one, "position_m", sensor[i].position);
        murk_json_number(one, "heading_deg", sensor[i].heading_deg);
        murk_json_number(one, "tilt_deg", sensor[i].tilt_deg);
        cJSON_AddItemToArray(list, one);
    }
}

static void add_text(cJSON *item, const char *key, const char *text)
{
    if (text[0]) {
        cJSON_AddStringToObject(item, key, text);
    } else {
        cJSON_AddNullToObject(item, key);
    }
}

static cJSON *row_json(const murk_sweep *sweep, size_t i)
{
    const murk_study_file *study = sweep->desc.study;
    const murk_sweep_row *row = &sweep->row[i];
    size_t index[MURK_STUDY_AXES_MAX];
    murk_study_row_indices(study, i, index);
    cJSON *item = cJSON_CreateObject();
    cJSON_AddNumberToObject(item, "row", (double)(i + 1));
    cJSON *axes = cJSON_AddObjectToObject(item, "axes");
    for (size_t a = 0; a < study->axes; ++a) {
        cJSON_AddStringToObject(axes, study->axis[a].name,
                                study->axis[a].text[index[a]]);
    }
    add_values(item, &row->found);
    add_sensors(item, "sensors", row->found.sensor, row->found.sensors);
    cJSON_AddNumberToObject(item, "photons_emitted",
                            (double)row->found.emitted);
    murk_json_number(item, "light",
                     row->group == SIZE_MAX ? NAN : (double)(row->group + 1));
    add_text(item, "note", row->found.note);
    add_text(item, "failed", row->found.failed);
    return item;
}

/* Which rows share what was traced. */
static void add_lights(cJSON *root, const murk_sweep *sweep)
{
    cJSON *list = cJSON_AddArrayToObject(root, "lights");
    for (size_t g = 0; g < sweep->groups; ++g) {
        const murk_sweep_group *group = &sweep->group[g];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddNumberToObject(item, "light", (double)(g + 1));
        cJSON *rows = cJSON_AddArrayToObject(item, "rows");
        for (size_t k = 0; k < group->n; ++k) {
            cJSON_AddItemToArray(
                rows, cJSON_CreateNumber((double)(group->row[k] + 1)));
        }
        cJSON_AddNumberToObject(item, "scaled_lights", (double)group->lights);
        cJSON_AddItemToArray(list, item);
    }
}

static void add_estimate(cJSON *to, const char *name, murk_estimate of)
{
    cJSON *item = cJSON_AddObjectToObject(to, name);
    murk_json_number(item, "value", of.value);
    murk_json_number(item, "standard_error", of.standard_error);
}

static double value_of(const murk_study_row *found, const char *name)
{
    const murk_study_value *v = murk_study_row_get(found, name);
    return v ? v->of.value : NAN;
}

static cJSON *plan_json(const murk_sweep *sweep, const murk_sweep_plan *plan)
{
    const murk_study_row *found = &plan->found;
    const size_t rows = sweep->desc.study->rows;
    cJSON *item = cJSON_CreateObject();
    add_sensors(item, "sensors", found->sensor, found->sensors);
    add_estimate(item, "mean", plan->mean);
    add_estimate(item, "worst", plan->worst);
    murk_json_number(item, "worst_row",
                     plan->worst_row < rows ? (double)(plan->worst_row + 1)
                                            : NAN);
    murk_json_number(item, "in_sample", value_of(found, "in_sample"));
    murk_json_number(item, "upper_bound", value_of(found, "upper_bound"));
    cJSON *by = cJSON_AddArrayToObject(item, "chosen_for_rows");
    for (size_t i = 0; i < sweep->choosers; ++i) {
        cJSON_AddItemToArray(
            by, cJSON_CreateNumber((double)(sweep->chooser[i] + 1)));
    }
    add_text(item, "failed", found->failed);
    return item;
}

/* One plan for all rows, as far as it was asked for. */
static void add_plans(cJSON *root, const murk_sweep *sweep)
{
    static const char *const names[] = {
        [MURK_SWEEP_MEAN] = "mean", [MURK_SWEEP_WORST] = "worst"};
    cJSON *plans = cJSON_AddObjectToObject(root, "plans");
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        if (sweep->plan[p].is_wanted) {
            cJSON_AddItemToObject(plans, names[p],
                                  plan_json(sweep, &sweep->plan[p]));
        }
    }
}

cJSON *murk_study_json(const murk_sweep *sweep, bool is_interrupted)
{
    const murk_study_file *study = sweep->desc.study;
    const size_t rows = study->rows;
    size_t kept = 0, traced = 0;
    cJSON *root = murk_json_begin_murk();
    cJSON_AddStringToObject(root, "study", study->path);
    cJSON_AddStringToObject(root, "study_sha256", study->sha256);
    cJSON_AddStringToObject(root, "scene", study->base);
    cJSON_AddStringToObject(root, "scene_sha256", sweep->scene_sha256);
    cJSON_AddNumberToObject(root, "seed", sweep->seed);
    cJSON_AddStringToObject(root, "mode", study->is_paired ? "paired" : "grid");
    add_axes(root, study);
    cJSON_AddNumberToObject(root, "rows_asked", (double)rows);
    cJSON_AddNumberToObject(root, "rows_done", (double)murk_sweep_done(sweep));
    cJSON_AddNumberToObject(root, "rows_failed",
                            (double)murk_sweep_failed(sweep));
    cJSON_AddBoolToObject(root, "interrupted", is_interrupted);
    cJSON *list = cJSON_AddArrayToObject(root, "rows");
    for (size_t i = 0; i < rows; ++i) {
        if (sweep->row[i].is_done) {
            cJSON_AddItemToArray(list, row_json(sweep, i));
        }
        kept += sweep->row[i].is_kept;
    }
    add_plans(root, sweep);
    add_lights(root, sweep);
    for (size_t g = 0; g < sweep->groups; ++g) {
        traced += sweep->group[g].was_traced;
    }
    cJSON *run = cJSON_AddObjectToObject(root, "run");
    cJSON_AddNumberToObject(run, "lights_traced", (double)traced);
    cJSON_AddNumberToObject(run, "rows_kept", (double)kept);
    return root;
}
