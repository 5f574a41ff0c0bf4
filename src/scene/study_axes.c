/* Reads the axes of a study file: lists of values, ranges {from, to, steps},
 * and names with several keys each. Checks that no key is set by two axes,
 * and counts the rows. */
#include "scene/study_axes.h"

#include "scene/override.h"
#include "scene/print.h"
#include "scene/study_range.h"
#include "scene/value.h"
#include "scene/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Length of "axes.NAME" in messages: the name is cut to
 * MURK_SCENE_NAME_SIZE. */
#define KEY_SIZE 160

/* An axis while it is read. */
typedef struct reading {
    murk_study_axis *axis;
    const murk_yaml *node;
    char key[KEY_SIZE];
    murk_error *err;
} reading;

static murk_status fail(const reading *r, const murk_yaml *node,
                        const char *text)
{
    return murk_study_fail(node, r->key, node == r->node, r->err, "%s", text);
}

static murk_status no_memory(const reading *r)
{
    return murk_study_no_memory(r->axis->where, r->err);
}

/* Stores a value and the text for tables; takes ownership of both, also on
 * failure. */
static murk_status put(const reading *r, size_t i, murk_yaml *value, char *text)
{
    r->axis->value[i] = value;
    r->axis->text[i] = text;
    return value && text ? MURK_OK : no_memory(r);
}

static murk_status reserve_values(const reading *r, size_t n)
{
    if (n < 1 || n > MURK_STUDY_ROWS_MAX) {
        return murk_study_fail(r->node, r->key, true, r->err,
                               "%zu values, must be 1..%d", n,
                               MURK_STUDY_ROWS_MAX);
    }
    r->axis->value = calloc(n, sizeof *r->axis->value);
    r->axis->text = calloc(n, sizeof *r->axis->text);
    r->axis->n = r->axis->value && r->axis->text ? n : 0;
    return r->axis->n ? MURK_OK : no_memory(r);
}

/* ---- lists and names ---- */

static murk_status read_list(const reading *r)
{
    murk_status status = reserve_values(r, r->node->n);
    for (size_t i = 0; !status && i < r->node->n; ++i) {
        const murk_yaml *item = r->node->child[i];
        status = put(r, i, murk_yaml_copy(item),
                     item->kind == MURK_YAML_SCALAR ? strdup(item->text)
                                                    : murk_print_flow(item));
    }
    return status;
}

/* True if a name has no control characters: names appear in messages of one
 * line and in tables. */
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

static murk_status read_names(const reading *r)
{
    murk_status status = reserve_values(r, r->node->n);
    for (size_t i = 0; !status && i < r->node->n; ++i) {
        const murk_yaml *item = r->node->child[i];
        if (item->kind != MURK_YAML_MAP && !murk_yaml_is_null(item)) {
            char found[MURK_FOUND_SIZE];
            murk_value_found(item, found);
            return murk_study_fail(item, r->key, true, r->err,
                                   "%s, must be a map of keys and values, or "
                                   "from, to and steps",
                                   found);
        }
        /* A name stands for a map of keys; nothing is an empty map. */
        if (!is_printable(r->node->key[i]) ||
            (item->kind == MURK_YAML_MAP && !has_printable_keys(item))) {
            return fail(r, item, "a name with control characters");
        }
        murk_yaml *copy = murk_yaml_copy(item);
        if (copy && copy->kind != MURK_YAML_MAP) {
            murk_yaml_clear(copy);
            copy->kind = MURK_YAML_MAP;
        }
        status = put(r, i, copy, strdup(r->node->key[i]));
    }
    return status;
}

/* ---- ranges ---- */

static murk_status read_range(const reading *r)
{
    murk_study_range range;
    murk_status status = murk_study_range_read(&range, r->node, r->key, r->err);
    if (!status) {
        status = reserve_values(r, range.steps);
    }
    for (size_t i = 0; !status && i < range.steps; ++i) {
        char text[MURK_TIME_SIZE];
        murk_study_range_print(&range, i, text);
        murk_yaml *value = murk_yaml_make(MURK_YAML_SCALAR, r->node->source);
        if (value) {
            value->line = r->node->line;
            value->column = r->node->column;
            value->is_quoted = range.scale != MURK_STUDY_NUMBERS;
        }
        status = put(r, i, value, strdup(text));
        if (!status && !murk_yaml_set_text(value, text)) {
            status = no_memory(r);
        }
    }
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

static murk_status check_conditions(const reading *r)
{
    for (size_t i = 0; i < r->axis->n; ++i) {
        if (r->axis->value[i]->kind != MURK_YAML_SCALAR) {
            return fail(r, r->axis->value[i],
                        "must be the name of a condition");
        }
    }
    return MURK_OK;
}

static murk_status read_axis(murk_study_axis *axis, const char *name,
                             const murk_yaml *node, murk_error *err)
{
    reading r = {.axis = axis, .node = node, .err = err};
    murk_status status = MURK_OK;
    axis->name = name;
    axis->path = path_of(name);
    char shown[MURK_SCENE_NAME_SIZE];
    murk_words_show(shown, sizeof shown, name); /* it may contain line breaks */
    snprintf(r.key, sizeof r.key, "axes.%s", shown);
    murk_walk_where(node, r.key, true, axis->where);
    if (name[0] == '\0') {
        status = fail(&r, node, "an axis without a name");
    } else if (!is_printable(name)) {
        status = fail(&r, node, "a name with control characters");
    } else if (node->kind == MURK_YAML_LIST) {
        status = read_list(&r);
    } else if (node->kind == MURK_YAML_MAP && is_range(node)) {
        status = read_range(&r);
    } else if (node->kind == MURK_YAML_MAP && node->n > 0) {
        axis->kind = MURK_STUDY_AXIS_NAMED;
        status = read_names(&r);
    } else {
        char found[MURK_FOUND_SIZE];
        murk_value_found(node, found);
        status = murk_study_fail(node, r.key, true, err,
                                 "%s, must be a list of values, {from, to, "
                                 "steps}, or names with their keys",
                                 found);
    }
    if (axis->kind == MURK_STUDY_AXIS_KEY && strcmp(name, "condition") == 0) {
        axis->kind = MURK_STUDY_AXIS_CONDITION;
        return status ? status : check_conditions(&r);
    }
    return status;
}

/* A path that the axis sets and that overlaps `path`; NULL if there is none. */
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

/* Checks that no other axis sets a key of axis `a`, and that the keys of one
 * name do not overlap. */
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
 * overflow. */
static murk_status count_rows(murk_study_file *study, const murk_yaml *map,
                              murk_error *err)
{
    double rows = 1;
    for (size_t a = 0; a < study->axes; ++a) {
        const murk_study_axis *axis = &study->axis[a];
        if (!study->is_paired) {
            rows *= (double)axis->n;
        } else if (axis->n != study->axis[0].n) {
            return murk_fail(err, MURK_BAD_VALUE, axis->where,
                             "%zu values, must be as many as axis %s has, %zu "
                             "(mode: paired)",
                             axis->n, study->axis[0].name, study->axis[0].n);
        } else {
            rows = (double)axis->n;
        }
    }
    if (rows > MURK_STUDY_ROWS_MAX) {
        return murk_study_fail(map, "axes", true, err,
                               "%.10g rows, must be at most %d", rows,
                               MURK_STUDY_ROWS_MAX);
    }
    study->rows = (size_t)rows;
    return MURK_OK;
}

murk_status murk_study_axes_read(murk_study_file *study, const murk_yaml *map,
                                 murk_error *err)
{
    if (!map || map->kind != MURK_YAML_MAP || map->n > MURK_STUDY_AXES_MAX) {
        return murk_study_fail(map ? map : study->root, "axes", true, err,
                               "must be a map of 0..%d axes: KEY: [values]",
                               MURK_STUDY_AXES_MAX);
    }
    study->axis = calloc(map->n + 1, sizeof *study->axis);
    if (!study->axis) {
        return murk_study_no_memory(study->path, err);
    }
    murk_status status = MURK_OK;
    for (size_t a = 0; a < map->n && !status; ++a) {
        study->axes = a + 1;
        status = read_axis(&study->axis[a], map->key[a], map->child[a], err);
        if (!status) {
            status = check_disjoint(study, a, err);
        }
    }
    return status ? status : count_rows(study, map, err);
}
