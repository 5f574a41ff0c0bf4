/* The command line: the tables of commands and options, and what was given.
 *
 * An option is one row of murk_option_table (option_table.c), and the parser,
 * --help, the man pages and the identity of results read that row. Most options
 * need no member of murk_options: the command asks murk_option_text() or
 * murk_option_number() by the option's name. */
#ifndef MURK_APP_OPTIONS_H
#define MURK_APP_OPTIONS_H

#include "base/status.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct murk_options murk_options;

/* ---- options ---- */

typedef enum murk_option_kind {
    MURK_OPTION_SWITCH, /* no value; a bool */
    MURK_OPTION_TEXT,   /* const char * */
    MURK_OPTION_PATH,   /* a path that sets a key: any text, never a number or a
                         * list */
    MURK_OPTION_COUNT,  /* a whole number min..max; uint64_t or unsigned */
    MURK_OPTION_WORD,   /* one of `words`; the index: bool or int */
    MURK_OPTION_OWN     /* as `read` reads it */
} murk_option_kind;

/* How results depend on an option, beside its scene key. */
typedef enum murk_option_part {
    MURK_OPTION_NO_PART,
    MURK_OPTION_AS_TEXT, /* results depend on the value */
    MURK_OPTION_AS_FILE  /* results depend on the contents of that file */
} murk_option_part;

/* Checks the value of the option `name` and stores it. */
typedef murk_status murk_option_read(murk_options *out, const char *name,
                                     const char *value, murk_error *err);

typedef struct murk_option {
    const char *name;     /* "--seed" */
    const char *other;    /* "-o", or NULL */
    const char *argument; /* "N", or NULL for a switch */
    const char *commands; /* "place sense", or NULL for all */
    const char *help;     /* NULL: not shown */
    murk_option_kind kind;
    uint64_t min, max;
    const char *const *words; /* NULL ends them */
    murk_option_read *read;
    const char *key;     /* scene key that gets the value; NULL: none */
    size_t at, size;     /* member of murk_options; size 0: none */
    const char *setting; /* the name of the value in messages of the library: as
                            a place NAME, in texts options->NAME */
    bool has_items; /* the value is a list, and places name an item behind the
                       setting: "keys KEY" */
    murk_option_part part;
    bool is_left_out; /* left out of the command line that is kept with results,
                         because it concerns the place of results or the form of
                         the output */
} murk_option;

#define MURK_OPTIONS_MAX 96 /* of the table */

extern const murk_option murk_option_table[];
extern const size_t murk_option_table_size;

/* Finds an option by its name or its other spelling, text[length]; NULL if
 * there is none. */
const murk_option *murk_option_find(const char *text, size_t length);

/* True if the command has the option. command NULL: if every command has it. */
bool murk_option_belongs(const murk_option *option, const char *command);

/* ---- commands ---- */

typedef struct murk_note_pair {
    const char *name, *text; /* a file and its contents; a command line and its
                                purpose */
} murk_note_pair;

/* The largest numbers of entries of a command, without the empty one at the
 * end. */
#define MURK_NOTES_FILES    24
#define MURK_NOTES_EXAMPLES 6

typedef murk_status murk_command_run(const murk_options *options,
                                     murk_error *err);

/* What the word behind the name of a command stands for. */
typedef enum murk_command_input {
    MURK_INPUT_SCENE,  /* a file */
    MURK_INPUT_STUDY,  /* a file */
    MURK_INPUT_FOLDER, /* of results */
    MURK_INPUT_PARTS,  /* folders of parts of a run, as many as are given */
    MURK_INPUT_PRESET,
    MURK_INPUT_START_SCENE, /* of scenes/start */
    MURK_INPUT_KEY,         /* of a scene */
    MURK_INPUT_NONE         /* the command takes no word */
} murk_command_input;

typedef struct murk_command {
    const char *name, *arguments, *summary;
    const char *text; /* a paragraph or two for --help and the man page */
    murk_command_run *run;
    murk_command_input input;
    bool has_ranks;      /* ranks (base/ranks.h) run it together */
    bool ends_in_first;  /* of these rank 0 alone needs the results */
    bool holds_worlds;   /* reads files while another world, with the threads of
                          * its ray device, is there */
    bool is_text_alone;  /* prints one text: no scene, no JSON of results */
    const char *formats; /* man pages of section 5, with spaces between */
    murk_note_pair example[MURK_NOTES_EXAMPLES + 1];
    murk_note_pair file[MURK_NOTES_FILES + 1]; /* that the command writes */
} murk_command;

extern const murk_command murk_commands[];
extern const size_t murk_commands_count;

/* NULL if there is none of that name. */
const murk_command *murk_command_find(const char *name);

/* The commands, each in its own file. */
murk_command_run murk_command_check, murk_command_trace, murk_command_place,
    murk_command_sense, murk_command_render, murk_command_study,
    murk_command_follow, murk_command_fit, murk_command_report,
    murk_command_replay, murk_command_media, murk_command_help,
    murk_command_schema, murk_command_init, murk_command_merge;

/* --report: murk_page_check() fails before the command runs if there will be no
 * folder; murk_page_write() writes the page of the folder afterwards, on rank
 * 0. Without --report both do nothing. */
murk_status murk_page_check(const murk_options *options, murk_error *err);
murk_status murk_page_write(const murk_options *options, murk_error *err);
/* Writes the page, as murk_page_write() does, of results that were saved whole
 * but make the command fail with `status`, because rows or steps of them have
 * failed. Returns `status`; a page that cannot be written is a warning. If
 * `status` is MURK_OK the function does nothing. */
murk_status murk_page_of_failed(const murk_options *options,
                                murk_status status);

/* ---- a command line as given ---- */

typedef struct murk_words_given {
    const char **word; /* [n], with NULL behind the last */
    size_t n;
} murk_words_given;

typedef struct murk_given_shard { /* --shard */
    uint32_t number, count;       /* count 0: not given */
} murk_given_shard;

typedef struct murk_given_fit {
    const char *data;        /* --data */
    murk_words_given free;   /* --free */
    murk_words_given bounds; /* --bounds */
    const char *predict;     /* --predict */
} murk_given_fit;

typedef struct murk_render_options {
    uint64_t from_sensor;     /* --from-sensor, from 1; 0: not given */
    size_t pixels[2];         /* --pixels; 0: not given */
    uint64_t samples;         /* --samples; 0: not given */
    bool png;                 /* --png; with it: */
    bool has_exposure;        /* --exposure */
    double exposure_stops;    /* 0: radiance as it is */
    const char *false_colour; /* --false-colour; with it: */
    bool has_range;
    double range[2]; /* --range */
} murk_render_options;

typedef struct murk_section_options {
    bool has_cut;
    double cut_m[3]; /* --cut */
} murk_section_options;

/* A key of the scene that the command line sets. */
typedef struct murk_given_key {
    const char *text;   /* "KEY=VALUE" */
    const char *option; /* that gave the key, "--seed" or "--set @FILE"; NULL:
                         * --set KEY=VALUE */
} murk_given_key;

/* One option as it was given. */
typedef struct murk_given {
    const murk_option *option;
    const char *value; /* NULL: it takes none */
    uint64_t number;   /* of a count; of a word its index */
} murk_given;

struct murk_options {
    murk_context *context;       /* made by terminal.c */
    const murk_command *command; /* NULL: only --help, --version, --man or
                                  * --completion */
    bool wants_help, wants_version, wants_man;
    bool has_threads;    /* the process has threads, so it must not fork */
    const char *input;   /* the scene; NULL with --matrix; a preset's name */
    const char *out;     /* -o; NULL: print, write nothing */
    const char *light;   /* --light */
    const char *sensors; /* --sensors */
    const char *matrix;  /* --matrix */
    const char *camera;  /* --camera */
    const char *profile; /* --profile */
    const char *voxel;   /* --voxel, of a profile's grid and of --export */
    unsigned exports;    /* --export: murk_export bits */
    murk_given_shard shard;
    murk_words_given inputs; /* of murk merge: all words behind the command */
    const struct murk_options *merges; /* the options of murk merge, if this
                                          command puts parts together; else
                                          NULL */
    murk_given_fit fit;
    murk_render_options render;
    murk_section_options section;
    unsigned threads;
    bool json, quiet;
    bool force;      /* --force */
    bool wants_page; /* --report */
    murk_progress_mode progress;
    murk_given_key *overrides; /* in the order given */
    size_t n_overrides;
    murk_given *given; /* [n_given] as they came */
    size_t n_given;
    murk_words_given repeated; /* the words of the command line that gives the
                              same results again: without "murk", and without
                              options that change no result (is_left_out) */
    char *typed;  /* the same words behind "murk", quoted for a POSIX shell */
    char **owned; /* [n_owned] texts that other members point to */
    size_t n_owned;
};

bool murk_option_is_given(const murk_options *options, const char *name);

/* The value that was given last under the option's name; NULL, or `otherwise`,
 * if none was. */
const char *murk_option_text(const murk_options *options, const char *name);
uint64_t murk_option_number(const murk_options *options, const char *name,
                            uint64_t otherwise);

#endif
