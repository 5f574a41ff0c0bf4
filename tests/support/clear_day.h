/* A clear day of measured sunshine against the clear-sky model, with one free
 * turbidity.
 *
 * SURFRAD's daily files: station, then latitude, longitude (west positive) and
 * altitude, then a minute a line: year, day of the year, month, day, hour,
 * minute (UTC), decimal hour, zenith angle, and pairs of value and flag (0:
 * good), of which global, upwelling, direct and diffuse irradiance are the
 * first [W/m2]. Data: NOAA, ../shared/data/PROVENANCE.md. */
#ifndef MURK_TESTS_CLEAR_DAY_H
#define MURK_TESTS_CLEAR_DAY_H

#include "source/ephemeris.h"

#include <stdbool.h>
#include <stddef.h>

#define CLEAR_DAY_FILE "../shared/data/field/solar/surfrad-slv16001.dat"

typedef struct clear_minute {
    double global, direct, diffuse; /* measured [W/m2] */
    double stated_zenith_deg;
    double apparent_zenith_deg, airmass, outside; /* ours */
} clear_minute;

typedef struct clear_day {
    murk_observer observer;
    clear_minute minute[1440]; /* those with the sun up and good flags */
    size_t n;
} clear_day;

/* Of their measured mean: root mean square and mean absolute difference, and
 * the mean difference (model less measured). */
typedef struct clear_misfit {
    double mean_w_per_m2, rms, absolute, bias;
} clear_misfit;

typedef struct clear_fit {
    double
        linke; /* by least squares of global and direct, each over its mean */
    clear_misfit global, direct, diffuse;
} clear_fit;

/* False where the file is not here. With a clock that is so much slow. */
bool clear_day_read(clear_day *day, double clock_error_s);

clear_fit clear_day_fit(const clear_day *day);

#endif
