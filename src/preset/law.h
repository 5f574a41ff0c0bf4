/* Laws: what presets are made of, each a function of wavelength and words.
 *
 * To add one: a function in a file of this room, with its source (author, year,
 * doi), and a row in laws.c; its parameters are then keys of a part in
 * media/FAMILY/NAME.yaml, beside `law: NAME`. */
#ifndef MURK_PRESET_LAW_H
#define MURK_PRESET_LAW_H

#include "preset/preset.h"

/* What a law is asked. */
typedef struct murk_law_call {
    size_t n;
    const double *wavelength_nm;    /* [n], within the preset's range */
    const murk_words *words;        /* with defaults; see words.h */
    const double *parameter;        /* as murk_law.parameter lists them */
    const murk_preset_table *table; /* where murk_law.by_table says so */
    const char *where;              /* for messages: the medium's place */
} murk_law_call;

/* What it answers. Coefficients start at 0. */
typedef struct murk_law_result {
    double *absorption_per_m, *scattering_per_m; /* [n] */
    murk_preset_phase *phase; /* [n]; used where has_phase is set and the file
                                 gives none */
    bool has_phase;
    murk_preset_angles *made; /* angles that `phase` points to, if the law made
                                 any: whoever called takes them */
} murk_law_result;

typedef struct murk_law_parameter {
    const char *name; /* NULL ends the list */
    double min, max;
} murk_law_parameter;

/* Words are given as a bit set: 1u << MURK_WORD_RAIN. */
struct murk_law {
    const char *name;
    const char *about; /* one line, for murk media */
    murk_status (*run)(murk_law_result *out, const murk_law_call *call,
                       murk_error *err);
    murk_law_parameter parameter[MURK_PRESET_PARAMETERS_MAX + 1];
    bool by_table;  /* needs a table with diffuse_attenuation_per_m */
    unsigned needs; /* words: the file must know them, with a default */
    unsigned may;   /* words: may be without default, or not known */
};

/* NULL when there is none of that name. */
const murk_law *murk_law_find(const char *name);

/* All of them, for tests and lists. */
extern const murk_law murk_laws[];
extern const size_t murk_laws_count;

#endif
