/* The words of presets: the quantities with which users describe a medium.
 * Words are keys of a medium in a scene, beside `preset`. A new word is a row
 * here and a row in scene/keys_media.c. */
#ifndef MURK_PRESET_WORDS_H
#define MURK_PRESET_WORDS_H

#include <stdbool.h>

#define MURK_WORD_NUMBERS_MAX 3 /* of droplet_shape */

/* id, name, unit, numbers, true if the word states the amount of the medium: a
 * user may give only one of these words */
#define MURK_WORD_ROWS(X)                                                     \
    X(VISIBILITY, "visibility_m", "m", 1, true)                               \
    X(MOR, "mor_m", "m", 1, true)                                             \
    X(RAIN, "rain_mm_per_h", "mm/h", 1, false)                                \
    X(SOOT, "soot_g_per_m3", "g/m3", 1, false)                                \
    X(DROPLETS, "droplets_per_cm3", "1/cm3", 1, true)                         \
    X(LIQUID_WATER, "liquid_water_g_per_m3", "g/m3", 1, true)                 \
    X(DROPLET_SHAPE, "droplet_shape", "a, b, c of r^a exp(-b r^c)", 3, false) \
    X(CHLOROPHYLL, "chlorophyll_mg_per_m3", "mg/m3", 1, false)                \
    X(SEDIMENT, "sediment_g_per_m3", "g/m3", 1, false)                        \
    X(CDOM, "cdom_per_m", "1/m at 440 nm", 1, false)                          \
    X(BEAM_ATTENUATION, "beam_attenuation_per_m", "1/m", 1, false)            \
    X(TEMPERATURE, "temperature_c", "degrees C", 1, false)                    \
    X(SALINITY, "salinity_psu", "psu", 1, false)                              \
    X(PRESSURE, "pressure_hpa", "hPa", 1, false)

typedef enum murk_word_id {
#define X(id, name, unit, numbers, is_amount) MURK_WORD_##id,
    MURK_WORD_ROWS(X)
#undef X
        MURK_WORDS
} murk_word_id;

/* The words that a user gave. Laws receive them with the defaults of the preset
 * filled in (`given` is set for defaults, too) and with mor_m converted to
 * visibility_m. */
typedef struct murk_words {
    bool given[MURK_WORDS];
    double value[MURK_WORDS][MURK_WORD_NUMBERS_MAX];
} murk_words;

typedef struct murk_word_row {
    const char *name, *unit;
    int numbers;
    bool is_amount;
} murk_word_row;

/* Indexed by murk_word_id. */
extern const murk_word_row murk_word_rows[MURK_WORDS];

/* Returns the murk_word_id of the word with that name, or -1. */
int murk_word_find(const char *name);

#endif
