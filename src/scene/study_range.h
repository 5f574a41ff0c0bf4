/* Ranges of values in a study: {from, to, steps}, of numbers, times, dates or
 * times of day. For use inside src/scene only. */
#ifndef MURK_SCENE_STUDY_RANGE_H
#define MURK_SCENE_STUDY_RANGE_H

#include "base/calendar.h"
#include "scene/walk.h"

typedef enum murk_study_scale {
    MURK_STUDY_NUMBERS,
    MURK_STUDY_TIMES, /* s since 1970, UTC */
    MURK_STUDY_DATES, /* days since 1970-01-01 */
    MURK_STUDY_CLOCKS /* s since midnight */
} murk_study_scale;

typedef struct murk_study_end {
    murk_study_scale scale;
    double value;
    int zone_min; /* for times: the time zone in which they are printed */
} murk_study_end;

typedef struct murk_study_range {
    murk_study_end from, to; /* both of one scale */
    bool is_log;
    size_t steps; /* 1..MURK_STUDY_ROWS_MAX */
} murk_study_range;

/* The table by which murk_walk_map() reads a murk_study_range. */
extern const murk_keys murk_study_range_keys;

/* Prints value i (below steps) as a scene file has it: numbers so that the ends
 * are read back exactly and values between them are rounded to 15 digits, times
 * and times of day in whole seconds, and dates in whole days. */
void murk_study_range_print(const murk_study_range *range, size_t i,
                            char out[MURK_TIME_SIZE]);

#endif
