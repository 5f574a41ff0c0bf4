/* Ranges of values: numbers in linear or logarithmic steps, times with a
 * zone, dates and times of day in equal steps. */
#include "scene/study_range.h"

#include "base/number.h"
#include "scene/keys_rows.h"
#include "scene/study_file.h"
#include "scene/value.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Reads one end of a range, and finds the kind of value. */
static murk_status read_end(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *member)
{
    murk_study_end *end = member;
    murk_date date;
    double local_s;
    bool has_zone = false;
    /* A number, a date, a time of day, or a time with a zone. */
    if (murk_yaml_number(node, &end->value)) {
        end->scale = MURK_STUDY_NUMBERS;
    } else if (node->kind != MURK_YAML_SCALAR) {
        return murk_value_wrong(walk, key, node);
    } else if (murk_date_read(node->text, &date)) {
        end->scale = MURK_STUDY_DATES;
        end->value = murk_date_days(date);
    } else if (murk_clock_read(node->text, &end->value)) {
        end->scale = MURK_STUDY_CLOCKS;
    } else if (murk_time_read(node->text, &local_s, &has_zone,
                              &end->zone_min) &&
               has_zone) {
        end->scale = MURK_STUDY_TIMES;
        end->value = local_s - 60. * end->zone_min;
    } else {
        return murk_value_wrong(walk, key, node);
    }
    return MURK_OK;
}

static murk_status check_range(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const murk_study_range *range = item;
    if (range->from.scale != range->to.scale) {
        return murk_walk_fail(walk, map,
                              "from and to, must be two numbers, two times "
                              "with their zone, two dates or two times of day");
    }
    return range->is_log && !(range->from.scale == MURK_STUDY_NUMBERS &&
                              range->from.value > 0 && range->to.value > 0)
               ? murk_walk_fail(
                     walk, map,
                     "spacing: log, from and to must be numbers above 0")
               : MURK_OK;
}

#define RANGE(member) AT(murk_study_range, member)
#define RANGE_END                                                       \
    NEEDED, .read = read_end,                                           \
            .allowed = "a number, a time with the zone "                \
                       "(2026-06-21T00:00:00+02:00), a date or a time " \
                       "of day"

static const murk_key RANGE_ROWS[] = {
    ROW("from", OWN, RANGE_END, RANGE(from)),
    ROW("to", OWN, RANGE_END, RANGE(to)),
    ROW("steps", COUNT, NEEDED, .min = 1, .max = MURK_STUDY_ROWS_MAX,
        RANGE(steps)),
    ROW("spacing", WORD, .preset = "linear", WORDS({"linear", 0}, {"log", 1}),
        RANGE(is_log)),
    END,
};

const murk_keys murk_study_range_keys = {
    .noun = "range", .check = check_range, .key = RANGE_ROWS};

/* Rounds to 15 digits, so that sums such as 0.1 + 0.2 give 0.3 and whole
 * steps give whole numbers. */
static double rounded(double value)
{
    char text[40];
    snprintf(text, sizeof text, "%.15g", value);
    return strtod(text, NULL);
}

/* Value i of the range; the ends are exact, and a single value is the beginning
 * of the range. */
static double value_at(const murk_study_range *g, size_t i)
{
    if (i == 0 || g->steps == 1) {
        return g->from.value;
    }
    if (i == g->steps - 1) {
        return g->to.value;
    }
    const double from = g->from.value, to = g->to.value;
    const double u = (double)i / (double)(g->steps - 1);
    return rounded(g->is_log ? from * pow(to / from, u)
                             : (1 - u) * from + u * to);
}

void murk_study_range_print(const murk_study_range *g, size_t i,
                            char out[MURK_TIME_SIZE])
{
    const double value = value_at(g, i);
    if (g->from.scale == MURK_STUDY_TIMES) {
        murk_time_print(out, value, g->from.zone_min);
    } else if (g->from.scale == MURK_STUDY_DATES) {
        const murk_date d = murk_date_of_days(floor(value + .5));
        snprintf(out, MURK_TIME_SIZE, "%04d-%02d-%02d", d.year, d.month, d.day);
    } else if (g->from.scale == MURK_STUDY_CLOCKS) {
        const int s = (int)floor(value + .5);
        snprintf(out, MURK_TIME_SIZE, "%02d:%02d:%02d", s / 3600, s / 60 % 60,
                 s % 60);
    } else {
        _Static_assert(MURK_NUMBER_SIZE <= MURK_TIME_SIZE, "numbers fit");
        murk_number_print(out, value);
    }
}
