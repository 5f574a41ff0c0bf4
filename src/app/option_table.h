/* Every option: how it is spelled, what it takes, which commands know it. */
#ifndef MURK_APP_OPTION_TABLE_H
#define MURK_APP_OPTION_TABLE_H

#include <stddef.h>

typedef enum murk_option_id {
    MURK_OPTION_OUT,
    MURK_OPTION_SEED,
    MURK_OPTION_THREADS,
    MURK_OPTION_EMIT,
    MURK_OPTION_STORE,
    MURK_OPTION_COUNT,
    MURK_OPTION_TARGET,
    MURK_OPTION_BUDGET,
    MURK_OPTION_SET,
    MURK_OPTION_LIGHT,
    MURK_OPTION_SENSORS,
    MURK_OPTION_MATRIX,
    MURK_OPTION_EXPORT,
    MURK_OPTION_REPEAT,
    MURK_OPTION_PHOTON,
    MURK_OPTION_DATA,
    MURK_OPTION_FREE,
    MURK_OPTION_BOUNDS,
    MURK_OPTION_LOSS,
    MURK_OPTION_STARTS,
    MURK_OPTION_TRACES,
    MURK_OPTION_NEXT,
    MURK_OPTION_PREDICT,
    MURK_OPTION_CAMERA,
    MURK_OPTION_METHOD,
    MURK_OPTION_FROM_SENSOR,
    MURK_OPTION_PIXELS,
    MURK_OPTION_SAMPLES,
    MURK_OPTION_PNG,
    MURK_OPTION_EXPOSURE,
    MURK_OPTION_FALSE_COLOUR,
    MURK_OPTION_RANGE,
    MURK_OPTION_SCALE,
    MURK_OPTION_PROFILE,
    MURK_OPTION_COLUMN,
    MURK_OPTION_ROWS,
    MURK_OPTION_VOXEL,
    MURK_OPTION_WIDTH,
    MURK_OPTION_FORMAT,
    MURK_OPTION_FORCE,
    MURK_OPTION_QUIET,
    MURK_OPTION_PROGRESS,
    MURK_OPTION_HELP,
    MURK_OPTION_VERSION,
    MURK_OPTION_MAN
} murk_option_id;

typedef struct murk_option {
    murk_option_id id;
    const char *name;     /* "--seed" */
    const char *other;    /* "-o", or NULL */
    const char *argument; /* "N", or NULL for a switch */
    const char *commands; /* "place sense", or NULL for all */
    const char *help;     /* NULL: not shown */
} murk_option;

#define MURK_OPTIONS_MAX 96 /* of the table */

extern const murk_option murk_option_table[];
extern const size_t murk_option_table_size;

/* By name or its other spelling, text[length]; NULL: there is none. */
const murk_option *murk_option_find(const char *text, size_t length);

/* One of a letter, whose value follows at once: -j2; NULL: it is none. */
const murk_option *murk_option_find_short(const char *text);

/* Whether a list such as "place sense" holds the name; NULL holds all. */
int murk_option_belongs(const murk_option *option, const char *command);

#endif
