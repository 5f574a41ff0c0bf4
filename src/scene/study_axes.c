/* Reads the axes of a study file: lists of values, ranges {from, to, steps},
 * hours of a weather year, and names with several keys each. Checks that no key
 * is set by two axes, and counts the rows. */
#include "scene/study_axes.h"

#include "scene/keys_rows.h"
#include "scene/override.h"
#include "scene/print.h"
#include "scene/study_file.h"
#include "scene/study_range.h"
#include "scene/value.h"

#include <stdlib.h>
#include <string.h>

#include "weather/year.h"

/* Stores a value and the text for tables; takes ownership of both, also on
 * failure. */
static murk_status put(murk_key_reader *walk, murk_study_axis *axis, size_t i,
                       murk_yaml *value, char *text)
{
    axis->value[i] = value;
    axis->text[i] = text;
    return value && text ? MURK_OK : murk_walk_no_memory(walk);
}

static murk_status reserve_values(murk_key_reader *walk, murk_study_axis *axis,
                                  const murk_yaml *node, size_t n)
{
    if (n < 1 || n > MURK_STUDY_ROWS_MAX) {
        return murk_walk_fail(walk, node, "%zu values, must be 1..%d", n,
                              MURK_STUDY_ROWS_MAX);
    }
    axis->value = calloc(n, sizeof *axis->value);
    axis->text = calloc(n, sizeof *axis->text);
    axis->n = axis->value && axis->text ? n : 0;
    return axis->n ? MURK_OK : murk_walk_no_memory(walk);
}

/* ---- lists and names ---- */

static murk_status read_list(murk_key_reader *walk, murk_study_axis *axis,
                             const murk_yaml *list)
{
    murk_status status = reserve_values(walk, axis, list, list->n);
    for (size_t i = 0; !status && i < list->n; ++i) {
        const murk_yaml *item = list->child[i];
        status = put(walk, axis, i, murk_yaml_copy(item),
                     item->kind == MURK_YAML_SCALAR ? strdup(item->text)
                                                    : murk_print_flow(item));
    }
    return status;
}

/* True if a name has no ASCII control characters: names appear in messages of
 * one line and in tables. */
static bool is_printable(const char *name)
{
    while (*name && (unsigned char)*name >= ' ' && *name != 127) {
        ++name;
    }
    return *name == '\0';
}

static bool has_printable_keys(const murk_yaml *map)
{
    for (size_t i = 0; i < map->n; ++i) {
        if (!is_printable(map->key[i])) {
            return false;
        }
    }
    return true;
}

static murk_status read_names(murk_key_reader *walk, murk_study_axis *axis,
                              const murk_yaml *map)
{
    murk_status status = reserve_values(walk, axis, map, map->n);
    axis->kind = MURK_STUDY_AXIS_NAMED;
    for (size_t i = 0; !status && i < map->n; ++i) {
        const murk_yaml *item = map->child[i];
        if (item->kind != MURK_YAML_MAP && !murk_yaml_is_null(item)) {
            static const murk_key keys = {
                .kind = MURK_KEY_OWN,
                .allowed = "a map of keys and values, or from, to and steps"};
            return murk_value_wrong(walk, &keys, item);
        }
        /* A name stands for a map of keys; an empty value counts as an empty
         * map. */
        if (!is_printable(map->key[i]) || !has_printable_keys(item)) {
            return murk_walk_fail_key(walk, item,
                                      "a name with control characters");
        }
        murk_yaml *copy = murk_yaml_copy(item);
        if (copy && copy->kind != MURK_YAML_MAP) {
            murk_yaml_clear(copy);
            copy->kind = MURK_YAML_MAP;
        }
        status = put(walk, axis, i, copy, strdup(map->key[i]));
    }
    return status;
}

/* ---- ranges ---- */

static murk_status read_range(murk_key_reader *walk, murk_study_axis *axis,
                              murk_yaml *map)
{
    murk_study_range range = {0};
    murk_status status =
        murk_walk_map(walk, &murk_study_range_keys, map, &range);
    if (!status) {
        status = reserve_values(walk, axis, map, range.steps);
    }
    for (size_t i = 0; !status && i < range.steps; ++i) {
        char text[MURK_TIME_SIZE];
        murk_study_range_print(&range, i, text);
        murk_yaml *value = murk_yaml_make(MURK_YAML_SCALAR, map->source);
        if (value) {
            value->line = map->line;
            value->column = map->column;
            value->is_quoted = range.from.scale != MURK_STUDY_NUMBERS;
        }
        status = put(walk, axis, i, value, strdup(text));
        if (!status && !murk_yaml_set_text(value, text)) {
            status = murk_walk_no_memory(walk);
        }
    }
    return status;
}

/* ---- hours of a weather year ---- */

/* {hours_of, first, last, step}: the middles of rows of a weather year. */
typedef struct hours {
    char *file;
    size_t first, last, step; /* rows, from 1 */
} hours;

#define HOURS(member) AT(hours, member)

static const murk_key HOURS_ROWS[] = {
    ROW("hours_of", PATH, NEEDED, HOURS(file)),
    ROW("first", COUNT, .min = 1, .max = 1e7, .preset = "1", HOURS(first)),
    ROW("last", COUNT, .min = 1, .max = 1e7, HOURS(last)),
    ROW("step", COUNT, .min = 1, .max = 1e7, .preset = "1", HOURS(step)),
    END,
};

static const murk_keys HOURS_KEYS = {.noun = "hours", .key = HOURS_ROWS};

static murk_yaml *text_node(const murk_yaml *map, const char *text)
{
    murk_yaml *value = murk_yaml_make(MURK_YAML_SCALAR, map->source);
    if (value) {
        value->line = map->line;
        value->column = map->column;
        value->is_quoted = true;
    }
    if (value && !murk_yaml_set_text(value, text)) {
        murk_yaml_destroy(value);
        value = NULL;
    }
    return value;
}

static murk_status put_hours(murk_key_reader *walk, murk_study_axis *axis,
                             const murk_yaml *map, const hours *h,
                             const murk_weather_year *year)
{
    const size_t last = h->last > 0 ? h->last : year->n;
    if (h->first > last || last > year->n) {
        return murk_walk_fail(walk, map,
                              "rows %zu to %zu, must rise and be among 1..%zu",
                              h->first, last, year->n);
    }
    const size_t n = 1 + (last - h->first) / h->step;
    murk_status status = reserve_values(walk, axis, map, n);
    for (size_t i = 0; i < n && !status; ++i) {
        const murk_weather_row *row = &year->row[h->first - 1 + i * h->step];
        char text[MURK_TIME_SIZE];
        murk_time_print(text, murk_weather_row_middle(year, row),
                        year->zone_min);
        status = put(walk, axis, i, text_node(map, text), strdup(text));
    }
    return status;
}

static murk_status read_hours(murk_key_reader *walk, murk_study_axis *axis,
                              murk_yaml *map)
{
    hours h = {0};
    murk_weather_year *year = NULL;
    murk_status status = murk_walk_map(walk, &HOURS_KEYS, map, &h);
    if (!status && strcmp(axis->path, "site.time") != 0) {
        status = murk_walk_fail(walk, map,
                                "hours_of gives times, must be of the axis "
                                "site.time");
    }
    if (!status) {
        status = murk_weather_year_read(&year, h.file, walk->err);
    }
    if (!status) {
        status = put_hours(walk, axis, map, &h, year);
    }
    murk_weather_year_release(year);
    free(h.file);
    return status;
}

/* ---- axes ---- */

/* Short names of axes. */
static const struct {
    const char *name, *path;
} SHORT_NAMES[] = {{"date", "site.date"},
                   {"local_time", "site.clock"},
                   {"time_zone", "site.time_zone"}};

static const char *path_of(const char *name)
{
    for (size_t i = 0; i < sizeof SHORT_NAMES / sizeof *SHORT_NAMES; ++i) {
        if (strcmp(name, SHORT_NAMES[i].name) == 0) {
            return SHORT_NAMES[i].path;
        }
    }
    return name;
}

static bool is_range(const murk_yaml *node)
{
    return murk_yaml_get(node, "from") || murk_yaml_get(node, "to") ||
           murk_yaml_get(node, "steps");
}

static murk_status check_conditions(murk_key_reader *walk,
                                    const murk_study_axis *axis)
{
    for (size_t i = 0; i < axis->n; ++i) {
        if (axis->value[i]->kind != MURK_YAML_SCALAR) {
            return murk_walk_fail(walk, axis->value[i],
                                  "must be the name of a condition");
        }
    }
    return MURK_OK;
}

static murk_status read_axis(murk_key_reader *walk, murk_study_axis *axis,
                             const char *name, murk_yaml *node)
{
    static const murk_key any = {.kind = MURK_KEY_OWN,
                                 .allowed =
                                     "a list of values, {from, to, steps}, "
                                     "{hours_of: FILE}, or names with their "
                                     "keys"};
    murk_status status = MURK_OK;
    axis->name = name;
    axis->path = path_of(name);
    murk_walk_where(node, walk->key, true, axis->where);
    /* The form of the node tells the kind of axis. */
    if (name[0] == '\0') {
        status = murk_walk_fail_key(walk, node, "an axis without a name");
    } else if (!is_printable(name)) {
        status =
            murk_walk_fail_key(walk, node, "a name with control characters");
    } else if (node->kind == MURK_YAML_LIST) {
        status = read_list(walk, axis, node);
    } else if (murk_yaml_get(node, "hours_of")) {
        status = read_hours(walk, axis, node);
    } else if (is_range(node)) {
        status = read_range(walk, axis, node);
    } else if (node->kind == MURK_YAML_MAP && node->n > 0) {
        status = read_names(walk, axis, node);
    } else {
        status = murk_value_wrong(walk, &any, node);
    }
    if (axis->kind == MURK_STUDY_AXIS_KEY && strcmp(name, "condition") == 0) {
        axis->kind = MURK_STUDY_AXIS_CONDITION;
        return status ? status : check_conditions(walk, axis);
    }
    return status;
}

/* A path that the axis sets and that overlaps `path`; NULL if there is none,
 * and for an axis of conditions. */
static const char *sets(const murk_study_axis *axis, const char *path)
{
    if (axis->kind == MURK_STUDY_AXIS_CONDITION) {
        return NULL;
    }
    if (axis->kind != MURK_STUDY_AXIS_NAMED) {
        return murk_override_overlap(axis->path, path) ? axis->path : NULL;
    }
    for (size_t i = 0; i < axis->n; ++i) {
        for (size_t k = 0; k < axis->value[i]->n; ++k) {
            if (murk_override_overlap(axis->value[i]->key[k], path)) {
                return axis->value[i]->key[k];
            }
        }
    }
    return NULL;
}

static murk_status check_path(const murk_study_file *study, size_t a,
                              const char *path, murk_error *err)
{
    const murk_study_axis *axis = &study->axis[a];
    for (size_t b = 0; b < a; ++b) {
        const murk_study_axis *other = &study->axis[b];
        const char *theirs = sets(other, path);
        if (theirs) {
            return murk_fail(err, MURK_BAD_VALUE, axis->where,
                             "sets %s, and axis %s sets %s: a key belongs to "
                             "one axis",
                             path, other->name, theirs);
        }
    }
    return MURK_OK;
}

/* Checks that no earlier axis sets a key that overlaps one of axis `a`, and
 * that the keys of one name do not overlap. */
static murk_status check_disjoint(const murk_study_file *study, size_t a,
                                  murk_error *err)
{
    const murk_study_axis *axis = &study->axis[a];
    /* A condition may set any key. */
    if (axis->kind == MURK_STUDY_AXIS_CONDITION) {
        return MURK_OK;
    }
    if (axis->kind != MURK_STUDY_AXIS_NAMED) {
        return check_path(study, a, axis->path, err);
    }
    /* Each key of each name. */
    murk_status status = MURK_OK;
    for (size_t i = 0; i < axis->n && !status; ++i) {
        const murk_yaml *map = axis->value[i];
        for (size_t k = 0; k < map->n && !status; ++k) {
            status = check_path(study, a, map->key[k], err);
            for (size_t j = 0; j < k && !status; ++j) {
                if (murk_override_overlap(map->key[j], map->key[k])) {
                    status = murk_fail(err, MURK_BAD_VALUE, axis->where,
                                       "%s sets %s and %s, of which one lies "
                                       "within the other",
                                       axis->text[i], map->key[j], map->key[k]);
                }
            }
        }
    }
    return status;
}

/* Counts the rows, in double precision: a product of 16 lengths cannot
 * overflow. Fails if paired axes have different lengths, or if there are too
 * many rows. */
static murk_status count_rows(murk_key_reader *walk, const murk_yaml *map,
                              murk_study_file *study)
{
    double rows = 1;
    for (size_t a = 0; a < study->axes; ++a) {
        const murk_study_axis *axis = &study->axis[a];
        if (!study->is_paired) {
            rows *= (double)axis->n;
        } else if (axis->n != study->axis[0].n) {
            return murk_fail(walk->err, MURK_BAD_VALUE, axis->where,
                             "%zu values, must be as many as axis %s has, %zu "
                             "(mode: paired)",
                             axis->n, study->axis[0].name, study->axis[0].n);
        } else {
            rows = (double)axis->n;
        }
    }
    if (rows > MURK_STUDY_ROWS_MAX) {
        return murk_walk_fail(walk, map, "%.10g rows, must be at most %d", rows,
                              MURK_STUDY_ROWS_MAX);
    }
    study->rows = (size_t)rows;
    return MURK_OK;
}

murk_status murk_study_axes_read(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, void *study)
{
    murk_study_file *out = study;
    if (node->kind != MURK_YAML_MAP) {
        return murk_value_wrong(walk, key, node);
    }
    if (node->n > MURK_STUDY_AXES_MAX) {
        return murk_walk_fail(walk, node, "%zu axes, must be at most %d",
                              node->n, MURK_STUDY_AXES_MAX);
    }
    out->axis = calloc(node->n + 1, sizeof *out->axis);
    murk_status status = out->axis ? MURK_OK : murk_walk_no_memory(walk);
    for (size_t a = 0; a < node->n && !status; ++a) {
        const size_t back = murk_walk_enter(walk, node->key[a]);
        out->axes = a + 1;
        status = read_axis(walk, &out->axis[a], node->key[a], node->child[a]);
        if (!status) {
            status = check_disjoint(out, a, walk->err);
            murk_walk_leave(walk, back);
        }
    }
    return status ? status : count_rows(walk, node, out);
}
