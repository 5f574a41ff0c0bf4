#include "app/placement_in.h"

#include "scene/table.h"
#include "scene/yaml.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SENSORS_MAX 1000000

static murk_status check_sensor(const char *where, const char *type,
                                murk_vec3 p, const murk_scene *scene,
                                const murk_domain *domain, murk_error *err)
{
    if (strcmp(type, scene->sensors.type_name) != 0) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "type: %s, the scene's sensors are of type %s", type,
                         scene->sensors.type_name);
    }
    if (!murk_box_contains(&domain->box, p)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "sensor at %.6g %.6g %.6g m lies outside the domain",
                         p.x, p.y, p.z);
    }
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

static murk_status from_table(murk_vec3 *sensor, const murk_table *table,
                              const murk_scene *scene,
                              const murk_domain *domain, murk_error *err)
{
    static const char *const names[4] = {"type", "x_m", "y_m", "z_m"};
    long column[4];
    murk_status status = MURK_OK;
    for (int i = 0; i < 4 && !status; ++i) {
        status = need_column(table, names[i], &column[i], err);
    }
    for (size_t row = 0; row < table->rows && !status; ++row) {
        double p[3];
        for (int i = 0; i < 3 && !status; ++i) {
            status =
                murk_table_number(table, row, column[i + 1], NAN, &p[i], err);
        }
        if (status) {
            break;
        }
        sensor[row] = murk_vec(p[0], p[1], p[2]);
        char where[320];
        snprintf(where, sizeof where, "%s:%d", table->path, table->line[row]);
        status = check_sensor(
            where, table->cell[row * table->columns + (size_t)column[0]],
            sensor[row], scene, domain, err);
    }
    return status;
}

static murk_status read_csv(murk_vec3 **out, size_t *n, const char *path,
                            const murk_scene *scene, const murk_domain *domain,
                            murk_error *err)
{
    murk_table *table = NULL;
    murk_status status = murk_table_read(&table, path, err);
    if (status) {
        return status;
    }
    murk_vec3 *sensor = calloc(table->rows + 1, sizeof *sensor);
    if (!sensor) {
        status = murk_fail(err, MURK_NO_MEMORY, path, "no memory to read it");
    } else if (table->rows < 1 || table->rows > SENSORS_MAX) {
        status =
            murk_fail(err, MURK_BAD_FILE, path, "%zu sensors, must be 1..%d",
                      table->rows, SENSORS_MAX);
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

static murk_status from_plan(murk_vec3 *sensor, const murk_yaml *list,
                             const murk_scene *scene, const murk_domain *domain,
                             murk_error *err)
{
    for (size_t i = 0; i < list->n; ++i) {
        const murk_yaml *item = list->child[i];
        char where[320];
        snprintf(where, sizeof where, "%s:%d:%d: sensors.%zu", item->source,
                 item->line, item->column, i);
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
        sensor[i] = murk_vec(p[0], p[1], p[2]);
        const murk_status status =
            check_sensor(where, type->text, sensor[i], scene, domain, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

/* JSON is YAML in flow style: the scene reader's parser knows lines and
 * columns. */
static murk_status read_json(murk_vec3 **out, size_t *n, const char *path,
                             const murk_scene *scene, const murk_domain *domain,
                             murk_error *err)
{
    murk_yaml *root = NULL;
    murk_status status = murk_yaml_read(&root, path, err);
    if (status) {
        return status;
    }
    const murk_yaml *list =
        root->kind == MURK_YAML_MAP ? murk_yaml_get(root, "sensors") : NULL;
    murk_vec3 *sensor = NULL;
    if (!list || list->kind != MURK_YAML_LIST || list->n < 1 ||
        list->n > SENSORS_MAX) {
        status = murk_fail(err, MURK_BAD_FILE, path,
                           "has no list \"sensors\" of 1..%d", SENSORS_MAX);
        goto done;
    }
    sensor = calloc(list->n, sizeof *sensor);
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

murk_status murk_placement_read(murk_vec3 **out, size_t *n, const char *path,
                                const murk_scene *scene,
                                const murk_domain *domain, murk_error *err)
{
    const char *dot = strrchr(path, '.');
    return dot && strcmp(dot, ".json") == 0
               ? read_json(out, n, path, scene, domain, err)
               : read_csv(out, n, path, scene, domain, err);
}
