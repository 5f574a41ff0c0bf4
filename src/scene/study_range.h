/* Ranges as axes of a study have them: {from, to, steps}, of numbers, times,
 * dates or times of day. Private to the room. */
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
    int zone_min; /* of TIMES: in which they are told */
    bool is_log;
    size_t steps; /* 1..MURK_STUDY_ROWS_MAX */
} murk_study_range;

/* Of a map; fails at the node, which is the value of `key`. */
murk_status murk_study_range_read(murk_study_range *out, const murk_yaml *node,
                                  const char *key, murk_error *err);

/* Value i, below steps, as a scene has it: the ends exactly, numbers between
 * them to 15 digits. */
void murk_study_range_print(const murk_study_range *range, size_t i,
                            char out[MURK_TIME_SIZE]);

#endif
