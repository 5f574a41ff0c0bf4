/* The command line: which command, which file, which options. */
#ifndef MURK_APP_OPTIONS_H
#define MURK_APP_OPTIONS_H

#include "app/option_table.h"
#include "base/progress.h"
#include "base/status.h"
#include "fit/least_squares.h"
#include "results/exports.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct murk_command {
    const char *name, *arguments, *summary;
    const char *text; /* a paragraph or two for --help and the man page */
    murk_status (*run)(const murk_options *options, murk_error *err);
} murk_command;

typedef struct murk_words_given {
    char **word; /* [n] owned */
    size_t n;
} murk_words_given;

typedef struct murk_fit_options {
    const char *data;        /* --data */
    murk_words_given free;   /* --free */
    murk_words_given bounds; /* --bounds */
    murk_loss_function loss; /* --loss */
    double loss_width;       /* in standard errors */
    const char *predict;     /* --predict */
} murk_fit_options;

typedef struct murk_render_options {
    uint64_t from_sensor;     /* --from-sensor, from 1; 0: not given */
    size_t pixels[2];         /* --pixels; 0: not given */
    uint64_t samples;         /* --samples; 0: not given */
    bool png;                 /* --png; with it: */
    bool has_exposure;        /* --exposure */
    double exposure_stops;    /* 0: radiance as it is */
    const char *false_colour; /* --false-colour; with it: */
    bool has_range, has_scale;
    double range[2]; /* --range */
    bool is_log;     /* --scale */
} murk_render_options;

typedef struct murk_given {
    const murk_option *option;
    const char *value; /* NULL: it takes none */
    uint64_t number;   /* of a count; of a word its index */
} murk_given;

struct murk_options {
    const murk_command *command; /* NULL: only --help, --version or --man */
    bool wants_help, wants_version, wants_man;
    const char *input;   /* the scene; NULL with --matrix; a preset's name */
    const char *out;     /* -o; NULL: print, write nothing */
    const char *light;   /* --light */
    const char *sensors; /* --sensors */
    const char *matrix;  /* --matrix */
    const char *camera;  /* --camera */
    bool by_path;        /* --method path */
    bool maps_only;      /* --method maps-only */
    const char *profile; /* --profile */
    const char *voxel;   /* --voxel, of a profile's grid and of --export */
    unsigned exports;    /* --export: murk_export bits */
    murk_fit_options fit;
    murk_render_options render;
    unsigned threads;
    bool json, quiet;
    bool force; /* --force */
    murk_progress_mode progress;
    murk_override *overrides; /* scene keys, in the order given */
    size_t n_overrides;
    murk_given *given; /* [n_given] as they came */
    size_t n_given;
    char *typed; /* the command line that gives the same again, for a shell */
    char **kept; /* texts that overrides point to */
    size_t n_kept;
};

extern const murk_command murk_commands[];
extern const size_t murk_commands_count;

/* Fills *out; release it also after a failure. Messages name the option, what
 * was found and what is allowed. */
murk_status murk_options_parse(murk_options *out, int argc, char **argv,
                               murk_error *err);
void murk_options_release(murk_options *options);

/* The value of an option by its name in the table, the last one that is given.
 * Text: NULL where it is not given; number: `otherwise`. */
const char *murk_option_text(const murk_options *options, const char *name);
uint64_t murk_option_number(const murk_options *options, const char *name,
                            uint64_t otherwise);

/* --help of one command, or of the program (NULL). */
void murk_help_print(FILE *to, const murk_command *command);

/* The man page of one command, or of the program (NULL), in roff. */
void murk_man_print(FILE *to, const murk_command *command);

/* The commands, each in its own file. */
murk_status murk_command_check(const murk_options *, murk_error *);
murk_status murk_command_trace(const murk_options *, murk_error *);
murk_status murk_command_place(const murk_options *, murk_error *);
murk_status murk_command_sense(const murk_options *, murk_error *);
murk_status murk_command_render(const murk_options *, murk_error *);
murk_status murk_command_study(const murk_options *, murk_error *);
murk_status murk_command_fit(const murk_options *, murk_error *);
murk_status murk_command_report(const murk_options *, murk_error *);
murk_status murk_command_replay(const murk_options *, murk_error *);
murk_status murk_command_media(const murk_options *, murk_error *);
murk_status murk_command_media_profile(const murk_options *, murk_error *);

#endif
