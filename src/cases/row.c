/* A row of a study: values by name, the sensors of its plan, and notes. Rows
 * are written as YAML text, so that a subprocess can send a row and a folder
 * can keep it, and read back with equal bits. */
#include "cases/row.h"

#include "base/number.h"
#include "base/scalar.h"
#include "scene/print.h"
#include "scene/yaml.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Degrees in a radian. */
#define DEG (180 / MURK_PI)

void murk_study_row_add(murk_study_row *row, const char *name, const char *unit,
                        murk_estimate of)
{
    murk_study_value *grown =
        realloc(row->value, (row->values + 1) * sizeof *grown);
    if (!grown) {
        row->lacks_memory = true;
        return;
    }
    row->value = grown;
    murk_study_value *v = &row->value[row->values++];
    snprintf(v->name, sizeof v->name, "%s", name);
    snprintf(v->unit, sizeof v->unit, "%s", unit);
    v->of = of;
}

murk_status murk_study_row_check(const murk_study_row *row, murk_error *err)
{
    return row->lacks_memory ? murk_no_memory(err, "", "for a row") : MURK_OK;
}

murk_status murk_study_row_set_sensors(murk_study_row *row,
                                       const murk_scene_desc *scene,
                                       const murk_pose *sensor, size_t n,
                                       murk_error *err)
{
    free(row->sensor);
    row->sensors = 0;
    row->sensor = calloc(n + 1, sizeof *row->sensor);
    if (!row->sensor) {
        return murk_no_memory(err, "", "for a row");
    }
    row->sensors = n;
    for (size_t i = 0; i < n; ++i) {
        const murk_scene_sensor_type *type =
            &scene->sensors.type[sensor[i].type];
        const bool is_round = type->view == MURK_VIEW_SPHERE;
        murk_study_sensor *s = &row->sensor[i];
        memcpy(s->type, type->name, sizeof s->type);
        s->position = murk_scene_user(scene, sensor[i].position);
        s->heading_deg = is_round ? NAN : DEG * sensor[i].heading_rad;
        s->tilt_deg = is_round ? NAN : DEG * sensor[i].tilt_rad;
    }
    return MURK_OK;
}

static uint32_t type_of(const murk_scene_sensors *sensors, const char *name)
{
    uint32_t t = 0;
    while (t < sensors->types && strcmp(sensors->type[t].name, name) != 0) {
        ++t;
    }
    return t;
}

static double radians(double degrees)
{
    return isfinite(degrees) ? degrees / DEG : 0;
}

murk_status murk_study_row_poses(murk_pose **out, const murk_study_row *row,
                                 const murk_scene_desc *scene, murk_error *err)
{
    murk_pose *pose = calloc(row->sensors + 1, sizeof *pose);
    if (!pose) {
        return murk_no_memory(err, scene->path, "for %zu sensors",
                              row->sensors);
    }
    for (size_t i = 0; i < row->sensors; ++i) {
        const murk_study_sensor *s = &row->sensor[i];
        pose[i] = (murk_pose){.type = type_of(&scene->sensors, s->type),
                              .position = murk_scene_local(scene, s->position),
                              .heading_rad = radians(s->heading_deg),
                              .tilt_rad = radians(s->tilt_deg)};
        if (pose[i].type == scene->sensors.types) {
            free(pose);
            return murk_fail(err, MURK_BAD_VALUE, scene->sensors.where,
                             "no sensor type %s", s->type);
        }
    }
    *out = pose;
    return MURK_OK;
}

void murk_study_add_note(char notes[MURK_ROW_TEXT_SIZE], const char *text)
{
    static const char cut[] = " ...";
    const size_t n = strlen(notes), capacity = MURK_ROW_TEXT_SIZE - n;
    if (text[0] && (size_t)snprintf(notes + n, capacity, "%s%s", n ? "; " : "",
                                    text) >= capacity) {
        memcpy(notes + MURK_ROW_TEXT_SIZE - sizeof cut, cut, sizeof cut);
    }
}

void murk_study_row_fail(murk_study_row *row, const murk_error *why)
{
    snprintf(row->failed, sizeof row->failed, "%s%s%s", why->where,
             why->where[0] ? ": " : "", why->text);
}

const murk_study_value *murk_study_row_get(const murk_study_row *row,
                                           const char *name)
{
    for (size_t i = 0; i < row->values; ++i) {
        if (strcmp(row->value[i].name, name) == 0) {
            return &row->value[i];
        }
    }
    return NULL;
}

void murk_study_row_release(murk_study_row *row)
{
    free(row->value);
    free(row->sensor);
    *row = (murk_study_row){0};
}

/* ---- text ---- */

/* Prints an item of a list: texts, then numbers, null for a number that is not
 * finite. */
static void print_item(FILE *out, const char *const *text, size_t texts,
                       const double *number, size_t numbers)
{
    char shown[MURK_NUMBER_SIZE];
    fputs("\n  [", out);
    for (size_t i = 0; i < texts; ++i) {
        fputs(i ? ", " : "", out);
        murk_scalar_print(out, text[i]);
    }
    for (size_t i = 0; i < numbers; ++i) {
        murk_number_print(shown, number[i]);
        fprintf(out, ", %s", isfinite(number[i]) ? shown : "null");
    }
    fputs("],", out);
}

char *murk_study_row_print(const murk_study_row *row, size_t number)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return NULL;
    }
    /* The keys of the row itself. */
    fprintf(out, "%zu\nemitted: %" PRIu64 "\nfailed: ", number, row->emitted);
    murk_scalar_print(out, row->failed);
    fputs("\nnote: ", out);
    murk_scalar_print(out, row->note);
    fputs("\nfluence: ", out);
    murk_scalar_print(out, row->fluence);
    /* The lists of values and sensors. */
    fputs("\nvalues: [", out);
    for (size_t i = 0; i < row->values; ++i) {
        const murk_study_value *v = &row->value[i];
        const double numbers[] = {v->of.value, v->of.standard_error};
        print_item(out, (const char *[]){v->name, v->unit}, 2, numbers, 2);
    }
    fputs("]\nsensors: [", out);
    for (size_t i = 0; i < row->sensors; ++i) {
        const murk_study_sensor *s = &row->sensor[i];
        const double numbers[] = {s->position.x, s->position.y, s->position.z,
                                  s->heading_deg, s->tilt_deg};
        print_item(out, (const char *[]){s->type}, 1, numbers, 5);
    }
    fputs("]\n", out);
    return murk_print_finish(out, &text);
}

static bool take_text(const murk_yaml *node, char *out, size_t size)
{
    if (!node || node->kind != MURK_YAML_SCALAR || strlen(node->text) >= size) {
        return false;
    }
    snprintf(out, size, "%s", node->text);
    return true;
}

static bool take_number(const murk_yaml *node, double *out)
{
    *out = NAN;
    return murk_yaml_is_null(node) || murk_yaml_number(node, out);
}

static bool take_value(const murk_yaml *item, murk_study_value *v)
{
    return item->kind == MURK_YAML_LIST && item->n == 4 &&
           take_text(item->child[0], v->name, sizeof v->name) &&
           take_text(item->child[1], v->unit, sizeof v->unit) &&
           take_number(item->child[2], &v->of.value) &&
           take_number(item->child[3], &v->of.standard_error);
}

static bool take_sensor(const murk_yaml *item, murk_study_sensor *s)
{
    return item->kind == MURK_YAML_LIST && item->n == 6 &&
           take_text(item->child[0], s->type, sizeof s->type) &&
           take_number(item->child[1], &s->position.x) &&
           take_number(item->child[2], &s->position.y) &&
           take_number(item->child[3], &s->position.z) &&
           take_number(item->child[4], &s->heading_deg) &&
           take_number(item->child[5], &s->tilt_deg);
}

static bool take_all(murk_study_row *row, const murk_yaml *root)
{
    const murk_yaml *values = murk_yaml_get(root, "values"),
                    *sensors = murk_yaml_get(root, "sensors"),
                    *emitted = murk_yaml_get(root, "emitted");
    /* The keys of the row itself. */
    bool is_whole =
        take_text(murk_yaml_get(root, "failed"), row->failed,
                  sizeof row->failed) &&
        take_text(murk_yaml_get(root, "note"), row->note, sizeof row->note) &&
        take_text(murk_yaml_get(root, "fluence"), row->fluence,
                  sizeof row->fluence) &&
        emitted && murk_yaml_count(emitted, &row->emitted) && values &&
        values->kind == MURK_YAML_LIST && sensors &&
        sensors->kind == MURK_YAML_LIST;
    /* The lists of values and sensors. */
    if (is_whole) {
        row->value = calloc(values->n + 1, sizeof *row->value);
        row->sensor = calloc(sensors->n + 1, sizeof *row->sensor);
        is_whole = row->value && row->sensor;
    }
    for (size_t i = 0; is_whole && i < values->n; ++i) {
        is_whole = take_value(values->child[i], &row->value[i]);
        row->values = i + 1;
    }
    for (size_t i = 0; is_whole && i < sensors->n; ++i) {
        is_whole = take_sensor(sensors->child[i], &row->sensor[i]);
        row->sensors = i + 1;
    }
    return is_whole;
}

murk_status murk_study_row_read(murk_study_row *out, const char *text,
                                size_t size, const char *source,
                                murk_error *err)
{
    murk_yaml *root = NULL;
    *out = (murk_study_row){0};
    murk_status status = murk_yaml_parse(&root, text, size, source, err);
    if (!status && !(root->kind == MURK_YAML_MAP && take_all(out, root))) {
        status = murk_fail(err, MURK_BAD_FILE, source,
                           "not a row of a study as murk writes it");
    }
    murk_yaml_destroy(root);
    return status;
}
