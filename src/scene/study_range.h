/* Ranges of values in a study: {from, to, steps}, of numbers, times, dates
 * or times of day; and failures of a study file. Private to the room. */
#ifndef MURK_SCENE_STUDY_RANGE_H
#define MURK_SCENE_STUDY_RANGE_H

#include "base/calendar.h"
#include "scene/study_file.h"

typedef enum murk_study_scale {
    MURK_STUDY_NUMBERS,
    MURK_STUDY_TIMES, /* s, universal */
    MURK_STUDY_DATES, /* days */
    MURK_STUDY_CLOCKS /* s of a day */
} murk_study_scale;

typedef struct murk_study_range {
    murk_study_scale scale;
    double from, to;
    int zone_min; /* for times: the time zone in which they are printed */
    bool is_log;
    size_t steps; /* 1..MURK_STUDY_ROWS_MAX */
} murk_study_range;

/* Reads a range from a map. Messages name the node, which is the value of
 * `key`. */
murk_status murk_study_range_read(murk_study_range *out, const murk_yaml *node,
                                  const char *key, murk_error *err);

/* Prints value i (below steps) as a scene file has it: the ends exactly,
 * numbers between them with 15 digits. */
void murk_study_range_print(const murk_study_range *range, size_t i,
                            char out[MURK_TIME_SIZE]);

/* Fails at a node, or at the key of the node: "study.yaml:5:3: axes.KEY". */
murk_status murk_study_fail(const murk_yaml *node, const char *key, bool at_key,
                            murk_error *err, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
murk_status murk_study_no_memory(const char *path, murk_error *err);

#endif
