/* Writes the rows of a study: table.csv, whose columns are the axes and the
 * values that the rows have, and the table of fields of study.json. */
#include "results/study.h"

#include "results/coverage.h"
#include "results/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- table.csv ---- */

static bool has(const char *const *name, size_t n, const char *wanted)
{
    for (size_t i = 0; i < n; ++i) {
        if (strcmp(name[i], wanted) == 0) {
            return true;
        }
    }
    return false;
}

/* Lists the names of values, in the order in which rows first have them. The
 * caller frees the array, not the names. NULL when out of memory. */
static const char **names_of(const murk_sweep *sweep, size_t *n)
{
    const size_t rows = sweep->desc.study->rows;
    size_t all = 0;
    for (size_t i = 0; i < rows; ++i) {
        all += sweep->row[i].found.values;
    }
    const char **name = malloc((all + 1) * sizeof *name);
    *n = 0;
    for (size_t i = 0; name && i < rows; ++i) {
        const murk_study_row *row = &sweep->row[i].found;
        for (size_t k = 0; k < row->values; ++k) {
            if (!has(name, *n, row->value[k].name)) {
                name[(*n)++] = row->value[k].name;
            }
        }
    }
    return name;
}

/* Writes a cell and a comma; an empty cell if the value is not finite. */
static void write_number(FILE *file, double value)
{
    char text[32] = "";
    if (isfinite(value)) {
        murk_number_text(text, value);
    }
    fprintf(file, "%s,", text);
}

static void write_row(FILE *file, const murk_sweep *sweep, size_t row,
                      const char *const *name, size_t n)
{
    const murk_study_file *study = sweep->desc.study;
    const murk_study_row *found = &sweep->row[row].found;
    size_t index[MURK_STUDY_AXES_MAX];
    murk_study_row_indices(study, row, index);
    for (size_t a = 0; a < study->axes; ++a) {
        murk_results_csv_cell(file, study->axis[a].text[index[a]]);
        fputc(',', file);
    }
    for (size_t i = 0; i < n; ++i) {
        const murk_study_value *v = murk_study_row_get(found, name[i]);
        write_number(file, v ? v->of.value : NAN);
        write_number(file, v ? v->of.standard_error : NAN);
    }
    murk_results_csv_cell(file, found->failed);
    fputc('\n', file);
}

static murk_status write_table(FILE *file, const void *context, murk_error *err)
{
    const murk_sweep *sweep = context;
    const murk_study_file *study = sweep->desc.study;
    size_t n;
    const char **name = names_of(sweep, &n);
    if (!name) {
        return murk_no_memory(err, "table.csv", "to write it");
    }
    /* the heading: axes, values with their errors, `failed` */
    for (size_t a = 0; a < study->axes; ++a) {
        murk_results_csv_cell(file, study->axis[a].name);
        fputc(',', file);
    }
    for (size_t i = 0; i < n; ++i) {
        murk_results_csv_cell(file, name[i]);
        fputc(',', file);
        murk_results_csv_cell(file, name[i]);
        fputs("_standard_error,", file);
    }
    fputs("failed\n", file);
    for (size_t i = 0; i < study->rows; ++i) {
        if (sweep->row[i].is_done) {
            write_row(file, sweep, i, name, n);
        }
    }
    free(name);
    return MURK_OK;
}

murk_status murk_add_table(murk_results *results, const murk_sweep *sweep,
                           murk_error *err)
{
    return murk_results_add_stream(results, "table.csv", write_table, sweep,
                                   err);
}

/* ---- study.json ---- */

static void list_axis(murk_results_fields *f, const void *of, size_t a)
{
    const murk_study_axis *axis =
        of ? &((const murk_study_file *)of)->axis[a] : NULL;
    MURK_TEXT(f, "key", "of the scene", axis->name);
    MURK_JSON(
        f, "values", "", "as given",
        cJSON_CreateStringArray((const char *const *)axis->text, (int)axis->n));
}

static cJSON *values_json(const murk_study_row *row)
{
    cJSON *values = cJSON_CreateObject();
    for (size_t i = 0; i < row->values; ++i) {
        const murk_study_value *v = &row->value[i];
        cJSON *value = cJSON_AddObjectToObject(values, v->name);
        murk_json_number(value, "value", v->of.value);
        murk_json_number(value, "standard_error", v->of.standard_error);
        cJSON_AddStringToObject(value, "unit", v->unit);
    }
    return values;
}

static void list_sensor(murk_results_fields *f, const void *of, size_t i)
{
    const murk_study_row *row = of;
    const murk_study_sensor *sensor = row ? &row->sensor[i] : NULL;
    MURK_TEXT(f, "type", "name of the sensor type", sensor->type);
    MURK_VECTOR(f, "position_m", "m", "position", sensor->position);
    MURK_NUMBER(f, "heading_deg", "degrees", "clockwise from north",
                sensor->heading_deg);
    MURK_NUMBER(f, "tilt_deg", "degrees", "up from the horizon",
                sensor->tilt_deg);
}

static void list_sensors(murk_results_fields *f, const murk_study_row *row)
{
    MURK_LIST(f, "sensors", "of the plan", list_sensor, row, row->sensors);
}

static const char *or_null(const char *text)
{
    return text[0] ? text : NULL;
}

/* The value of each axis in row i. */
static cJSON *axes_json(const murk_study_file *study, size_t i)
{
    size_t index[MURK_STUDY_AXES_MAX];
    cJSON *axes = cJSON_CreateObject();
    murk_study_row_indices(study, i, index);
    for (size_t a = 0; a < study->axes; ++a) {
        cJSON_AddStringToObject(axes, study->axis[a].name,
                                study->axis[a].text[index[a]]);
    }
    return axes;
}

/* Only rows that are done are listed. */
static void list_row(murk_results_fields *f, const void *of, size_t i)
{
    const murk_sweep *sweep = of;
    const murk_sweep_row *row = sweep ? &sweep->row[i] : NULL;
    if (!MURK_LISTED_IF(f, row->is_done)) {
        return;
    }
    MURK_COUNT(f, "row", "number, from 1", i + 1);
    MURK_JSON(f, "axes", "", "value of each axis, by key",
              axes_json(sweep->desc.study, i));
    MURK_JSON(f, "values", "", "by name, each value, standard_error, unit",
              values_json(&row->found));
    list_sensors(f, row ? &row->found : NULL);
    MURK_COUNT(f, "photons_emitted", "emitted photons", row->found.emitted);
    MURK_NUMBER(f, "light", "", "number of the light that rows share",
                row->group == SIZE_MAX ? NAN : (double)(row->group + 1));
    MURK_TEXT(f, "note", "null, or notes on the row", or_null(row->found.note));
    MURK_TEXT(f, "failed", "null, or the reason of the failure",
              or_null(row->found.failed));
}

/* A list of the numbers, from 1, of n rows. */
static cJSON *numbers_json(const size_t *row, size_t n)
{
    cJSON *list = cJSON_CreateArray();
    for (size_t k = 0; k < n; ++k) {
        cJSON_AddItemToArray(list, cJSON_CreateNumber((double)(row[k] + 1)));
    }
    return list;
}

static void list_light(murk_results_fields *f, const void *of, size_t g)
{
    const murk_sweep *sweep = of;
    const murk_sweep_group *group = sweep ? &sweep->group[g] : NULL;
    MURK_COUNT(f, "light", "number, from 1", g + 1);
    MURK_JSON(f, "rows", "", "that share the traced light",
              numbers_json(group->row, group->n));
    MURK_COUNT(f, "scaled_lights", "light sources whose powers rows scale",
               group->lights);
}

static void list_estimate(murk_results_fields *f, const void *of)
{
    const murk_estimate *e = of;
    MURK_NUMBER(f, "value", "1", "coverage", e->value);
    MURK_NUMBER(f, "standard_error", "1", "of value", e->standard_error);
}

static double value_of(const murk_study_row *found, const char *name)
{
    const murk_study_value *v = murk_study_row_get(found, name);
    return v ? v->of.value : NAN;
}

/* A plan that is meant for all rows of a study. */
typedef struct plan_of_rows {
    const murk_sweep *sweep;
    const murk_sweep_plan *plan;
} plan_of_rows;

static void list_plan(murk_results_fields *f, const void *of)
{
    const plan_of_rows *p = of;
    const murk_sweep *sweep = p ? p->sweep : NULL;
    const murk_sweep_plan *plan = p ? p->plan : NULL;
    list_sensors(f, plan ? &plan->found : NULL);
    MURK_OBJECT(f, "mean", "over the rows", list_estimate, &plan->mean);
    MURK_OBJECT(f, "worst", "of the rows", list_estimate, &plan->worst);
    MURK_NUMBER(f, "worst_row", "", "number, from 1",
                plan->worst_row < sweep->desc.study->rows
                    ? (double)(plan->worst_row + 1)
                    : NAN);
    MURK_NUMBER(f, "in_sample", "1", "on the light that chose",
                value_of(&plan->found, "in_sample"));
    MURK_NUMBER(f, "upper_bound", "1", "on in_sample",
                value_of(&plan->found, "upper_bound"));
    MURK_JSON(f, "chosen_for_rows", "", "numbers, from 1",
              numbers_json(sweep->chooser, sweep->choosers));
    MURK_TEXT(f, "failed", "null, or the reason of the failure",
              or_null(plan->found.failed));
}

/* The plans for all rows that were asked for: for the best mean, and for the
 * best worst row. */
static void list_plans(murk_results_fields *f, const void *of)
{
    static const char *const names[] = {
        [MURK_SWEEP_MEAN] = "mean", [MURK_SWEEP_WORST] = "worst"};
    const murk_sweep *sweep = of;
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        const plan_of_rows plan = {sweep, sweep ? &sweep->plan[p] : NULL};
        if (MURK_LISTED_IF(f, plan.plan->is_wanted)) {
            MURK_OBJECT(f, names[p], "the plan for this criterion", list_plan,
                        &plan);
        }
    }
}

static void list_run(murk_results_fields *f, const void *of)
{
    const murk_sweep *sweep = of;
    size_t reused = 0, traced = 0;
    for (size_t g = 0; sweep && g < sweep->groups; ++g) {
        traced += sweep->group[g].was_traced;
    }
    for (size_t i = 0; sweep && i < sweep->desc.study->rows; ++i) {
        reused += sweep->row[i].is_reused;
    }
    MURK_COUNT(f, "lights_traced", "by this run", traced);
    MURK_COUNT(f, "rows_kept", "from earlier runs", reused);
}

void murk_results_list_study(murk_results_fields *f, const void *of)
{
    const murk_study_results *r = of;
    const murk_sweep *sweep = r ? r->sweep : NULL;
    const murk_study_file *study = sweep ? sweep->desc.study : NULL;
    if (!murk_results_describes(f)) {
        murk_results_list_murk(f, NULL);
    }
    /* The study and the base scene, then the rows. */
    MURK_TEXT(f, "study", "the study file as named", study->path);
    MURK_TEXT(f, "study_sha256", "of the study file", study->sha256);
    MURK_TEXT(f, "scene", "the base scene", study->base);
    MURK_TEXT(f, "scene_sha256", "of the base scene", sweep->scene_sha256);
    MURK_COUNT(f, "seed", "of all random numbers", sweep->seed);
    MURK_TEXT(f, "mode", "grid or paired",
              study->is_paired ? "paired" : "grid");
    MURK_LIST(f, "axes", "the keys that vary", list_axis, study, study->axes);
    MURK_COUNT(f, "rows_asked", "of the study", study->rows);
    MURK_COUNT(f, "rows_done", "failed ones included", murk_sweep_done(sweep));
    MURK_COUNT(f, "rows_failed", "of those done", murk_sweep_failed(sweep));
    MURK_FLAG(f, "interrupted", "true if the run was", r->is_interrupted);
    MURK_LIST(f, "rows", "those done", list_row, sweep, study->rows);
    MURK_OBJECT(f, "plans", "one plan for all rows, as asked for", list_plans,
                sweep);
    MURK_LIST(f, "lights", "groups of rows that share a light", list_light,
              sweep, sweep->groups);
    MURK_OBJECT(f, "run", "beside the keys of every JSON", list_run, sweep);
}
