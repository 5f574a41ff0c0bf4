/* Reads sensors from a CSV table or from the list "sensors" of a JSON result.
 * Both lead to the same checks of one sensor: type, position in the domain,
 * heading and tilt. */
#include "plan/placement_in.h"

#include "base/position.h"
#include "scene/table_places.h"
#include "scene/yaml.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sensors that a file may list: beyond any deployment, and some 50 MB. */
#define SENSORS_MAX 1000000

/* A file that is being read. */
typedef struct reading {
    const char *path;
    size_t min; /* sensors that there must be */
    const murk_scene_desc *scene;
    const murk_domain *domain;
    murk_pose *sensor; /* [n] */
    bool *is_drifted;  /* [n] */
    size_t n;
    bool may_drift; /* the column `drifted` counts */
} reading;

static murk_status allocate(reading *r, size_t n, murk_error *err)
{
    r->n = n;
    r->sensor = calloc(n + 1, sizeof *r->sensor);
    r->is_drifted = calloc(n + 1, sizeof *r->is_drifted);
    return r->sensor && r->is_drifted
               ? MURK_OK
               : murk_no_memory(err, r->path, "to read it");
}

/* The numbers of a sensor in a file; angles are NAN if the file gives none. */
enum { X, Y, Z, HEADING, TILT, NUMBERS };

/* Checks a sensor, converts its position from the coordinates of the user to
 * those of the scene structs, and stores the sensor as number i. */
static murk_status add_sensor(reading *r, size_t i, const char *where,
                              const char *type, const double p[NUMBERS],
                              murk_error *err)
{
    /* The type must exist in the scene. */
    const murk_scene_sensors *settings = &r->scene->sensors;
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
    const murk_vec3 local =
        murk_scene_local(r->scene, murk_vec(p[X], p[Y], p[Z]));
    if (!r->is_drifted[i] && !murk_box_contains(&r->domain->box, local)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "sensor at %s m lies outside the domain",
                         murk_position_show(local).text);
    }
    r->sensor[i] = (murk_pose){.type = (uint32_t)k, .position = local};
    /* A type that does not see all round needs a heading and a tilt. */
    if (settings->type[k].view == MURK_VIEW_SPHERE) {
        return MURK_OK;
    }
    if (!(fabs(p[HEADING]) <= 360) || !(fabs(p[TILT]) <= 90)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "heading_deg %g and tilt_deg %g, type %s must have "
                         "-360..360 and -90..90 degrees",
                         p[HEADING], p[TILT], type);
    }
    r->sensor[i].heading_rad = p[HEADING] * (MURK_PI / 180);
    r->sensor[i].tilt_rad = p[TILT] * (MURK_PI / 180);
    return MURK_OK;
}

/* ---- CSV ---- */

/* The columns beside those of the place. */
enum { TYPE, HEADING_DEG, TILT_DEG, COLUMNS };
static const char *const NAMES[COLUMNS] = {"type", "heading_deg", "tilt_deg"};

static const char *cell_of(const murk_table *table, size_t row, long column)
{
    return table->cell[row * table->columns + (size_t)column];
}

/* Reads row i; an empty angle stays NAN. */
static murk_status read_row(reading *r, const murk_table_places *places,
                            size_t i, const long column[COLUMNS],
                            murk_error *err)
{
    const murk_table *table = places->table;
    double p[NUMBERS], above_m;
    murk_vec3 place;
    murk_status status =
        murk_table_places_read(places, i, &place, &above_m, err);
    for (int k = HEADING; k <= TILT && !status; ++k) {
        const long at = column[k == HEADING ? HEADING_DEG : TILT_DEG];
        p[k] = NAN;
        if (at >= 0 && cell_of(table, i, at)[0]) {
            status = murk_table_number(table, i, at, NAN, &p[k], err);
        }
    }
    if (status) {
        return status;
    }
    p[X] = place.x;
    p[Y] = place.y;
    p[Z] = place.z;
    /* The pose, and whether it has drifted. */
    const long drifted = murk_table_column(table, "drifted");
    r->is_drifted[i] = r->may_drift && drifted >= 0 &&
                       strcmp(cell_of(table, i, drifted), "1") == 0;
    char where[320];
    snprintf(where, sizeof where, "%s:%d", table->path, table->line[i]);
    return add_sensor(r, i, where, cell_of(table, i, column[TYPE]), p, err);
}

static murk_status read_rows(reading *r, const murk_table *table,
                             murk_error *err)
{
    long column[COLUMNS];
    if (table->rows < r->min || table->rows > SENSORS_MAX) {
        return murk_fail(err, MURK_BAD_FILE, r->path,
                         "%zu sensors, must be %zu..%d", table->rows, r->min,
                         SENSORS_MAX);
    }
    /* Columns, then rows. */
    for (int i = 0; i < COLUMNS; ++i) {
        column[i] = murk_table_column(table, NAMES[i]);
    }
    if (column[TYPE] < 0) {
        return murk_fail(err, MURK_BAD_FILE, table->path,
                         "misses column type, must have type and a place");
    }
    murk_table_places places;
    murk_status status =
        murk_table_places_find(&places, table, r->scene, false, err);
    if (!status) {
        status = allocate(r, table->rows, err);
    }
    for (size_t i = 0; i < table->rows && !status; ++i) {
        status = read_row(r, &places, i, column, err);
    }
    return status;
}

static murk_status read_csv(reading *r, murk_error *err)
{
    murk_table *table = NULL;
    murk_status status = murk_table_read(&table, r->path, err);
    if (!status) {
        status = read_rows(r, table, err);
    }
    murk_table_destroy(table);
    return status;
}

/* ---- JSON ---- */

/* The number of a key; NAN if the key is missing or its value is null or no
 * number. */
static double angle_of(const murk_yaml *item, const char *name)
{
    const murk_yaml *node = murk_yaml_get(item, name);
    double value;
    return node && murk_yaml_number(node, &value) ? value : NAN;
}

/* Reads item i of the list: a type, a position of three numbers, angles. */
static murk_status read_item(reading *r, const murk_yaml *item, size_t i,
                             murk_error *err)
{
    char where[320];
    snprintf(where, sizeof where, "%s:%d:%d: sensors.%zu", item->source,
             item->line, item->column, i);
    const bool is_map = item->kind == MURK_YAML_MAP;
    const murk_yaml *type = is_map ? murk_yaml_get(item, "type") : NULL;
    const murk_yaml *place = is_map ? murk_yaml_get(item, "position_m") : NULL;
    double p[NUMBERS];
    bool is_good = type && type->kind == MURK_YAML_SCALAR && place &&
                   place->kind == MURK_YAML_LIST && place->n == 3;
    for (size_t k = 0; is_good && k < 3; ++k) {
        is_good = murk_yaml_number(place->child[k], &p[k]);
    }
    if (!is_good) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "must have a type and a position_m [x, y, z] in m");
    }
    p[HEADING] = angle_of(item, "heading_deg");
    p[TILT] = angle_of(item, "tilt_deg");
    return add_sensor(r, i, where, type->text, p, err);
}

/* JSON is read by the YAML parser, because JSON is YAML in flow style and that
 * parser reports lines and columns. */
static murk_status read_json(reading *r, murk_error *err)
{
    murk_yaml *root = NULL;
    murk_status status = murk_yaml_read(&root, r->path, err);
    const murk_yaml *list = !status && root->kind == MURK_YAML_MAP
                                ? murk_yaml_get(root, "sensors")
                                : NULL;
    if (!status && (!list || list->kind != MURK_YAML_LIST || list->n < r->min ||
                    list->n > SENSORS_MAX)) {
        status = murk_fail(err, MURK_BAD_FILE, r->path,
                           "has no list \"sensors\" of %zu..%d", r->min,
                           SENSORS_MAX);
    }
    if (!status) {
        status = allocate(r, list->n, err);
    }
    for (size_t i = 0; !status && i < list->n; ++i) {
        status = read_item(r, list->child[i], i, err);
    }
    murk_yaml_destroy(root);
    return status;
}

/* Reads the file; after a failure the arrays of `r` are NULL. */
static murk_status read_file(reading *r, murk_error *err)
{
    const char *dot = strrchr(r->path, '.');
    const murk_status status =
        dot && strcmp(dot, ".json") == 0 ? read_json(r, err) : read_csv(r, err);
    if (status) {
        free(r->sensor);
        free(r->is_drifted);
        r->sensor = NULL;
        r->is_drifted = NULL;
    }
    return status;
}

murk_status murk_placement_read(murk_pose **out, size_t *n, const char *path,
                                size_t min, const murk_scene_desc *scene,
                                const murk_domain *domain, murk_error *err)
{
    reading r = {.path = path, .min = min, .scene = scene, .domain = domain};
    const murk_status status = read_file(&r, err);
    free(r.is_drifted);
    if (!status) {
        *out = r.sensor;
        *n = r.n;
    }
    return status;
}

murk_status murk_placement_read_start(murk_pose **out, bool **is_drifted,
                                      size_t *n, const char *path,
                                      const murk_scene_desc *scene,
                                      const murk_domain *domain,
                                      murk_error *err)
{
    reading r = {
        .path = path, .scene = scene, .domain = domain, .may_drift = true};
    const murk_status status = read_file(&r, err);
    if (!status) {
        *out = r.sensor;
        *is_drifted = r.is_drifted;
        *n = r.n;
    }
    return status;
}
