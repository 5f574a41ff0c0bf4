/* What users read of light: watts, lumens or photons, by the scene's `units`.
 *
 * One factor a band. A line is what it is; between edges light is taken as
 * even in wavelength, or, where all lights are of the sky, as in sunlight
 * (AM 1.5): what of a band arrives depends on everything it met, which the band
 * does not know. */
#ifndef MURK_STUDY_UNITS_H
#define MURK_STUDY_UNITS_H

#include "base/bands.h"
#include "base/stats.h"
#include "scene/scene.h"

typedef struct murk_units {
    const char *power;      /* "W", "lm", "1/s", "umol/s" */
    const char *irradiance; /* "W/m2", "lux", "1/s/m2", "umol/s/m2" */
    const char *suffix;     /* of JSON keys: "w", "lm", "photons_per_s" .. */
    murk_spectrum per_watt; /* in each band */
} murk_units;

murk_units murk_units_of(const murk_scene *scene);

/* A radiometric value of a band in these units, with its error. */
murk_estimate murk_units_convert(const murk_units *units, int band,
                                 murk_estimate radiometric);

/* The sum over n bands of values in these units: bands have photons of their
 * own, so their errors are independent. */
murk_estimate murk_units_sum(const murk_estimate *value, int n);

/* A note where bands count nothing: light that eyes or plants do not see. */
void murk_units_note(const murk_scene *scene);

#endif
