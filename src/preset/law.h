/* Laws: the functions of wavelength and words from which presets are composed.
 *
 * To add a law, write a function in a file of src/preset, with the source
 * (author, year, doi), declare the function in laws.h and add a row in laws.c.
 * The parameters of the law are
 * then keys of a part in media/FAMILY/NAME.yaml, beside `law:` with the name of
 * the law. */
#ifndef MURK_PRESET_LAW_H
#define MURK_PRESET_LAW_H

#include "preset/preset.h"

/* The input of a law. */
typedef struct murk_law_call {
    size_t n;
    const double *wavelength_nm;    /* [n], within the range of the preset, but
                                     * for 550 nm as the last one if parts are
                                     * scaled to a visibility */
    const murk_words *words;        /* with defaults, see preset/words.h */
    const double *parameter;        /* in the order of murk_law.parameter */
    const murk_preset_table *table; /* the table of the part, if
                                     * murk_law.by_table is set */
    const char *where;              /* for messages: the place of the medium in
                                     * the scene file */
} murk_law_call;

/* The result of a law. The caller sets the coefficients to 0 before the law is
 * called. */
typedef struct murk_law_result {
    double *absorption_per_m, *scattering_per_m; /* [n] */
    murk_preset_phase *phase; /* [n]; used if has_phase is set and the file
                               * gives no phase function */
    bool has_phase;
    murk_preset_angles *made; /* the table that `phase` refers to, if the law
                               * made one, else NULL; the caller destroys it */
} murk_law_result;

typedef struct murk_law_parameter {
    const char *name; /* NULL ends the list */
    double min, max;
} murk_law_parameter;

typedef murk_status murk_law_run(murk_law_result *out,
                                 const murk_law_call *call, murk_error *err);

/* A row of the table of laws. Sets of words are bit sets: 1u <<
 * MURK_WORD_RAIN. */
struct murk_law {
    const char *name;
    const char *about; /* one line for `murk media` */
    murk_law_run *run;
    murk_law_parameter parameter[MURK_PRESET_PARAMETERS_MAX + 1];
    bool by_table;  /* requires a table with diffuse_attenuation_per_m */
    unsigned needs; /* words that the file must declare, with a default */
    unsigned may;   /* words that the file may declare, with or without a
                     * default */
};

/* Returns the law with that name, or NULL. */
const murk_law *murk_law_find(const char *name);

#endif
