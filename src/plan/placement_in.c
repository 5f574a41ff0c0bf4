/* Reads sensors from a CSV table or from the list "sensors" of a JSON result.
 * Both lead to the same checks of one sensor: type, position in the domain,
 * heading and tilt. */
#include "plan/placement_in.h"

#include "base/position.h"
#include "scene/table.h"
#include "scene/yaml.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sensors that a file may list: beyond any deployment, and some 50 MB. */
#define SENSORS_MAX 1000000

/* Checks one sensor and converts it; p is in the coordinates of the user.
 * Angles are NAN if the file gives none. */
static murk_status read_sensor(murk_pose *out, const char *where,
                               const char *type, murk_vec3 p,
                               double heading_deg, double tilt_deg,
                               const murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err)
{
    /* The type must exist in the scene. */
    const murk_scene_sensors *settings = &scene->sensors;
    size_t k = 0;
    while (k < settings->types && strcmp(type, settings->type[k].name) != 0) {
        ++k;
    }
    if (k == settings->types) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "type: %s is no type of the scene's sensors; the "
                         "first there is %s",
                         type, settings->type[0].name);
    }
    /* The position must lie in the domain. */
    const murk_vec3 local = murk_scene_local(scene, p);
    if (!murk_box_contains(&domain->box, local)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "sensor at %s m lies outside the domain",
                         murk_position_show(local).text);
    }
    *out = (murk_pose){.type = (uint32_t)k, .position = local};
    /* A type with a view needs a heading and a tilt. */
    if (settings->type[k].view == MURK_VIEW_SPHERE) {
        return MURK_OK;
    }
    if (!(fabs(heading_deg) <= 360) || !(fabs(tilt_deg) <= 90)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "heading_deg %g and tilt_deg %g, type %s must have "
                         "-360..360 and -90..90 degrees",
                         heading_deg, tilt_deg, type);
    }
    out->heading_rad = heading_deg * (MURK_PI / 180);
    out->tilt_rad = tilt_deg * (MURK_PI / 180);
    return MURK_OK;
}

static murk_status need_column(const murk_table *table, const char *name,
                               long *out, murk_error *err)
{
    *out = murk_table_column(table, name);
    return *out >= 0 ? MURK_OK
                     : murk_fail(err, MURK_BAD_FILE, table->path,
                                 "no column %s; needed are type, x_m, y_m, "
                                 "z_m",
                                 name);
}

static bool is_empty(const murk_table *table, size_t row, long column)
{
    return table->cell[row * table->columns + (size_t)column][0] == '\0';
}

/* Reads the sensors of a table. */
static murk_status from_table(murk_pose *sensor, const murk_table *table,
                              const murk_scene_desc *scene,
                              const murk_domain *domain, murk_error *err)
{
    /* Find the columns; heading and tilt may be missing. */
    static const char *const names[6] = {"type", "x_m",         "y_m",
                                         "z_m",  "heading_deg", "tilt_deg"};
    long column[6];
    murk_status status = MURK_OK;
    for (int i = 0; i < 4 && !status; ++i) {
        status = need_column(table, names[i], &column[i], err);
    }
    column[4] = murk_table_column(table, names[4]);
    column[5] = murk_table_column(table, names[5]);
    for (size_t row = 0; row < table->rows && !status; ++row) {
        /* Read the numbers of a row; an empty angle stays NAN. */
        double p[5] = {NAN, NAN, NAN, NAN, NAN};
        for (int i = 0; i < 5 && !status; ++i) {
            if (column[i + 1] >= 0 &&
                !(i >= 3 && is_empty(table, row, column[i + 1]))) {
                status = murk_table_number(table, row, column[i + 1], NAN,
                                           &p[i], err);
            }
        }
        if (status) {
            break;
        }
        /* Check and convert. */
        char where[320];
        snprintf(where, sizeof where, "%s:%d", table->path, table->line[row]);
        status = read_sensor(
            &sensor[row], where,
            table->cell[row * table->columns + (size_t)column[0]],
            murk_vec(p[0], p[1], p[2]), p[3], p[4], scene, domain, err);
    }
    return status;
}

static murk_status read_csv(murk_pose **out, size_t *n, const char *path,
                            size_t min, const murk_scene_desc *scene,
                            const murk_domain *domain, murk_error *err)
{
    murk_table *table = NULL;
    murk_status status = murk_table_read(&table, path, err);
    if (status) {
        return status;
    }
    /* The number of rows must be in range. */
    murk_pose *sensor = calloc(table->rows + 1, sizeof *sensor);
    if (!sensor) {
        status = murk_fail(err, MURK_NO_MEMORY, path, "no memory to read it");
    } else if (table->rows < min || table->rows > SENSORS_MAX) {
        status =
            murk_fail(err, MURK_BAD_FILE, path, "%zu sensors, must be %zu..%d",
                      table->rows, min, SENSORS_MAX);
    } else {
        status = from_table(sensor, table, scene, domain, err);
    }
    if (!status) {
        *out = sensor;
        *n = table->rows;
        sensor = NULL;
    }
    free(sensor);
    murk_table_destroy(table);
    return status;
}

/* The number of a key; NAN if the key is missing or null. */
static double angle_of(const murk_yaml *item, const char *name)
{
    const murk_yaml *node = murk_yaml_get(item, name);
    double value;
    return node && murk_yaml_number(node, &value) ? value : NAN;
}

/* Reads the sensors of a JSON list. */
static murk_status from_plan(murk_pose *sensor, const murk_yaml *list,
                             const murk_scene_desc *scene,
                             const murk_domain *domain, murk_error *err)
{
    for (size_t i = 0; i < list->n; ++i) {
        const murk_yaml *item = list->child[i];
        char where[320];
        snprintf(where, sizeof where, "%s:%d:%d: sensors.%zu", item->source,
                 item->line, item->column, i);
        /* A type and a position of three numbers. */
        const murk_yaml *type =
            item->kind == MURK_YAML_MAP ? murk_yaml_get(item, "type") : NULL;
        const murk_yaml *place = item->kind == MURK_YAML_MAP
                                     ? murk_yaml_get(item, "position_m")
                                     : NULL;
        double p[3];
        bool is_good = type && type->kind == MURK_YAML_SCALAR && place &&
                       place->kind == MURK_YAML_LIST && place->n == 3;
        for (size_t k = 0; is_good && k < 3; ++k) {
            is_good = murk_yaml_number(place->child[k], &p[k]);
        }
        if (!is_good) {
            return murk_fail(err, MURK_BAD_FILE, where,
                             "must have a type and a position_m [x, y, z] in "
                             "m");
        }
        /* Check and convert. */
        const murk_status status = read_sensor(
            &sensor[i], where, type->text, murk_vec(p[0], p[1], p[2]),
            angle_of(item, "heading_deg"), angle_of(item, "tilt_deg"), scene,
            domain, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

/* JSON is read by the YAML parser, because JSON is YAML in flow style and that
 * parser reports lines and columns. */
static murk_status read_json(murk_pose **out, size_t *n, const char *path,
                             size_t min, const murk_scene_desc *scene,
                             const murk_domain *domain, murk_error *err)
{
    murk_yaml *root = NULL;
    murk_status status = murk_yaml_read(&root, path, err);
    if (status) {
        return status;
    }
    /* Find the list. */
    const murk_yaml *list =
        root->kind == MURK_YAML_MAP ? murk_yaml_get(root, "sensors") : NULL;
    murk_pose *sensor = NULL;
    if (!list || list->kind != MURK_YAML_LIST || list->n < min ||
        list->n > SENSORS_MAX) {
        status =
            murk_fail(err, MURK_BAD_FILE, path,
                      "has no list \"sensors\" of %zu..%d", min, SENSORS_MAX);
        goto done;
    }
    /* Convert the list. */
    sensor = calloc(list->n + 1, sizeof *sensor);
    status = sensor
                 ? from_plan(sensor, list, scene, domain, err)
                 : murk_fail(err, MURK_NO_MEMORY, path, "no memory to read it");
    if (!status) {
        *out = sensor;
        *n = list->n;
        sensor = NULL;
    }
done:
    free(sensor);
    murk_yaml_destroy(root);
    return status;
}

murk_status murk_placement_read(murk_pose **out, size_t *n, const char *path,
                                size_t min, const murk_scene_desc *scene,
                                const murk_domain *domain, murk_error *err)
{
    const char *dot = strrchr(path, '.');
    return dot && strcmp(dot, ".json") == 0
               ? read_json(out, n, path, min, scene, domain, err)
               : read_csv(out, n, path, min, scene, domain, err);
}
