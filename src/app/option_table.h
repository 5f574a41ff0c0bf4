/* Every option, one row each: how it is spelled, the value that it takes, the
 * member or the scene key that the value goes to, which commands know it, and
 * its help. Parsing, --help, the man pages and the identity of a run read the
 * table.
 *
 * An option of one command needs no member of murk_options: the command asks
 * murk_option_text() or murk_option_number() by its name. */
#ifndef MURK_APP_OPTION_TABLE_H
#define MURK_APP_OPTION_TABLE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct murk_options murk_options;

typedef enum murk_option_kind {
    MURK_OPTION_SWITCH, /* no value; a bool */
    MURK_OPTION_TEXT,   /* const char * */
    MURK_OPTION_COUNT,  /* a whole number min..max; uint64_t or unsigned */
    MURK_OPTION_WORD,   /* one of `words`; the index: bool or int */
    MURK_OPTION_OWN     /* as `read` reads it */
} murk_option_kind;

/* What an option has to do with results, beside what it does to the scene. */
typedef enum murk_option_part {
    MURK_OPTION_NO_PART,
    MURK_OPTION_AS_TEXT, /* results depend on the value */
    MURK_OPTION_AS_FILE  /* results depend on the contents of that file */
} murk_option_part;

typedef struct murk_option {
    const char *name;     /* "--seed" */
    const char *other;    /* "-o", or NULL */
    const char *argument; /* "N", or NULL for a switch */
    const char *commands; /* "place sense", or NULL for all */
    const char *help;     /* NULL: not shown */
    murk_option_kind kind;
    uint64_t min, max;
    const char *const *words; /* NULL ends them */
    murk_status (*read)(murk_options *out, const char *name, const char *value,
                        murk_error *err);
    const char *key; /* scene key that gets the value; NULL: none */
    size_t at, size; /* member of murk_options; size 0: none */
    bool has_flag;
    size_t flag_at; /* a bool: the option is given */
    murk_option_part part;
    bool is_left_out; /* of the command line that is kept with results: where
                         results go, and what is printed */
} murk_option;

#define MURK_OPTIONS_MAX 96 /* of the table */

extern const murk_option murk_option_table[];
extern const size_t murk_option_table_size;

/* By name or its other spelling, text[length]; NULL: there is none. */
const murk_option *murk_option_find(const char *text, size_t length);

/* One of a letter, whose value follows at once: -j2; NULL: it is none. */
const murk_option *murk_option_find_short(const char *text);

/* Whether a list such as "place sense" holds the name; NULL holds all. */
bool murk_option_belongs(const murk_option *option, const char *command);

#endif
