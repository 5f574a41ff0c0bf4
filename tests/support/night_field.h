/* Nights of a sky quality meter that looks at the zenith, against moonlight
 * scattered by a clear sky plus one free level of the dark sky.
 *
 * Readings with the sun less than 15 degrees down are left out (twilight).
 * Data: D. O'Keeffe, CAC (ODbL 1.0), ../shared/data/PROVENANCE.md. */
#ifndef MURK_TESTS_NIGHT_FIELD_H
#define MURK_TESTS_NIGHT_FIELD_H

#include <stdbool.h>
#include <stddef.h>

#define NIGHT_FIELD_FILES   "../shared/data/field/night/*.dat"
#define NIGHT_FIELD_NIGHTS  16 /* at most */
#define NIGHT_FIELD_SUN_DEG (-15.0)
#define NIGHT_FIELD_MOON    5 /* the nights with the most moonlight */

typedef struct night_reading {
    size_t night;
    double measured_mag;
    double moonlight; /* at the zenith, by the model [cd/m2] */
} night_reading;

typedef struct night_field {
    night_reading reading[4096];
    size_t n, nights;
} night_field;

typedef struct night_fit {
    double level_mag; /* the free one, by least squares of magnitudes */
    double correlation, rms_mag;         /* of magnitudes, so of logarithms */
    double measured[NIGHT_FIELD_NIGHTS]; /* mean luminance [cd/m2] */
    double model[NIGHT_FIELD_NIGHTS];
    double moonlight[NIGHT_FIELD_NIGHTS];  /* the moon's part of the model */
    size_t by_moonlight[NIGHT_FIELD_MOON]; /* nights, the brightest first */
    size_t out_of_order; /* of those, darker by the meter than the next */
} night_fit;

/* False where the files are not here. With clocks that are so much slow. */
bool night_field_read(night_field *field, double clock_error_s);
night_fit night_field_fit(const night_field *field);

#endif
