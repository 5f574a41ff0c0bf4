/* Ranges of values: numbers in linear or logarithmic steps, times with a
 * zone, dates and times of day in equal steps. */
#include "scene/study_range.h"

#include "base/number.h"
#include "scene/value.h"
#include "scene/words.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

murk_status murk_study_fail(const murk_yaml *node, const char *key, bool at_key,
                            murk_error *err, const char *format, ...)
{
    char text[512];
    murk_scene_where where;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    murk_walk_where(node, key, at_key, where);
    return murk_fail(err, MURK_BAD_VALUE, where, "%s", text);
}

murk_status murk_study_no_memory(const char *path, murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, path, "no memory for the study");
}

/* Reads one end of a range, and finds the kind of value. */
static bool read_end(const murk_yaml *node, murk_study_scale *scale,
                     double *value, int *zone_min)
{
    murk_date date;
    double local_s;
    bool has_zone = false;
    if (!node || node->kind != MURK_YAML_SCALAR) {
        return false;
    }
    /* A number, a date, a time of day, or a time with a zone. */
    if (murk_yaml_number(node, value)) {
        *scale = MURK_STUDY_NUMBERS;
        return true;
    }
    if (murk_date_read(node->text, &date)) {
        *scale = MURK_STUDY_DATES;
        *value = murk_date_days(date);
        return true;
    }
    if (murk_clock_read(node->text, value)) {
        *scale = MURK_STUDY_CLOCKS;
        return true;
    }
    if (murk_time_read(node->text, &local_s, &has_zone, zone_min) && has_zone) {
        *scale = MURK_STUDY_TIMES;
        *value = local_s - 60. * *zone_min;
        return true;
    }
    return false;
}

static murk_status read_ends(const murk_yaml *node, const char *key,
                             murk_study_range *out, murk_error *err)
{
    const murk_yaml *from = murk_yaml_get(node, "from"),
                    *to = murk_yaml_get(node, "to");
    murk_study_scale scale_to = MURK_STUDY_NUMBERS;
    int zone_to = 0;
    if (!read_end(from, &out->scale, &out->from, &out->zone_min) ||
        !read_end(to, &scale_to, &out->to, &zone_to) ||
        scale_to != out->scale) {
        return murk_study_fail(
            node, key, true, err,
            "from and to, must be two numbers, two times with their "
            "zone (2026-06-21T00:00:00+02:00), two dates or two times "
            "of day");
    }
    if (out->is_log &&
        !(out->scale == MURK_STUDY_NUMBERS && out->from > 0 && out->to > 0)) {
        return murk_study_fail(
            node, key, true, err,
            "spacing: log, from and to must be numbers above 0");
    }
    return MURK_OK;
}

static murk_status read_range_keys(const murk_yaml *node, const char *key,
                                   murk_study_range *out, murk_error *err)
{
    static const char *const names[] = {"from", "to", "steps", "spacing"};
    /* No other keys. */
    for (size_t i = 0; i < node->n; ++i) {
        const char *meant = murk_words_meant(node->key[i], names, 4);
        if (!meant || strcmp(meant, node->key[i]) != 0) {
            char shown[MURK_SCENE_NAME_SIZE];
            murk_words_show(shown, sizeof shown, node->key[i]);
            return murk_study_fail(node->child[i], key, true, err,
                                   "%s is no key of a range, which has from, "
                                   "to, steps and spacing",
                                   shown);
        }
    }
    const murk_yaml *steps = murk_yaml_get(node, "steps"),
                    *spacing = murk_yaml_get(node, "spacing");
    /* The number of steps. */
    uint64_t n = 0;
    if (!steps || !murk_yaml_count(steps, &n) || n < 1 ||
        n > MURK_STUDY_ROWS_MAX) {
        char found[MURK_FOUND_SIZE] = "nothing";
        if (steps) {
            murk_value_found(steps, found);
        }
        return murk_study_fail(steps ? steps : node, key, !steps, err,
                               "steps: %s, must be a whole number, 1..%d",
                               found, MURK_STUDY_ROWS_MAX);
    }
    out->steps = (size_t)n;
    /* The spacing. */
    const char *word = spacing && spacing->kind == MURK_YAML_SCALAR
                           ? spacing->text
                       : spacing ? ""
                                 : "linear";
    out->is_log = strcmp(word, "log") == 0;
    if (!out->is_log && strcmp(word, "linear") != 0) {
        return murk_study_fail(spacing, key, false, err,
                               "spacing: must be linear or log");
    }
    return MURK_OK;
}

/* Rounds to 15 digits, so that sums such as 0.1 + 0.2 give 0.3 and whole
 * steps give whole numbers. */
static double rounded(double value)
{
    char text[40];
    snprintf(text, sizeof text, "%.15g", value);
    return strtod(text, NULL);
}

/* Value i of the range; the ends are exact. */
static double value_at(const murk_study_range *g, size_t i)
{
    if (i == 0 || g->steps == 1) {
        return g->from;
    }
    if (i == g->steps - 1) {
        return g->to;
    }
    const double u = (double)i / (double)(g->steps - 1);
    return rounded(g->is_log ? g->from * pow(g->to / g->from, u)
                             : (1 - u) * g->from + u * g->to);
}

void murk_study_range_print(const murk_study_range *g, size_t i,
                            char out[MURK_TIME_SIZE])
{
    const double value = value_at(g, i);
    if (g->scale == MURK_STUDY_TIMES) {
        murk_time_print(out, value, g->zone_min);
    } else if (g->scale == MURK_STUDY_DATES) {
        const murk_date d = murk_date_of_days(floor(value + .5));
        snprintf(out, MURK_TIME_SIZE, "%04d-%02d-%02d", d.year, d.month, d.day);
    } else if (g->scale == MURK_STUDY_CLOCKS) {
        const int s = (int)floor(value + .5);
        snprintf(out, MURK_TIME_SIZE, "%02d:%02d:%02d", s / 3600, s / 60 % 60,
                 s % 60);
    } else {
        _Static_assert(MURK_NUMBER_SIZE <= MURK_TIME_SIZE, "numbers fit");
        murk_number_print(out, value);
    }
}

murk_status murk_study_range_read(murk_study_range *out, const murk_yaml *node,
                                  const char *key, murk_error *err)
{
    *out = (murk_study_range){0};
    const murk_status status = read_range_keys(node, key, out, err);
    return status ? status : read_ends(node, key, out, err);
}
