/* One observation of the weather: an hour of a weather year (EPW), a METAR or a
 * SYNOP report, with what photons depend on. The classification of the sky by
 * its clearness is here, too. */
#ifndef MURK_WEATHER_OBSERVATION_H
#define MURK_WEATHER_OBSERVATION_H

#include <stdbool.h>

/* Reports that end at some distance state a limit and not a value. */
typedef enum murk_visibility_limit {
    MURK_VISIBILITY_EXACT,
    MURK_VISIBILITY_AT_LEAST,
    MURK_VISIBILITY_LESS_THAN
} murk_visibility_limit;

/* What is in the air, by the codes of the report, the first that applies. */
typedef enum murk_weather_kind {
    MURK_WEATHER_NONE, /* no code, or one without a medium */
    MURK_WEATHER_HAZE, /* also mist, dust and smoke */
    MURK_WEATHER_FOG,
    MURK_WEATHER_SNOW /* also with rain, and ice pellets */
} murk_weather_kind;

/* Largest rate of rain within an hour: more than any that was recorded (some
 * 400 mm in an hour). */
#define MURK_RAIN_MM_PER_H_MAX 500.0

/* Temperatures of air beyond these are faults of a report: -89.2 C and 56.7 C
 * are the extremes on record (World Meteorological Organization, archive of
 * weather and climate extremes). */
#define MURK_COLDEST_C (-90.0)
#define MURK_HOTTEST_C 70.0

/* Weather years state whole W/m2: an irradiance that they state as 0 is less
 * than this. */
#define MURK_WEATHER_RESOLVED_W_PER_M2 .5

#define MURK_WEATHER_GROUPS_SIZE                  \
    64 /* of the texts of a report, with the '\0' \
        */

/* A number that the report does not state is NAN. */
typedef struct murk_observation {
    double direct_w_per_m2;  /* of the sun, at right angles to the beam */
    double diffuse_w_per_m2; /* of the sky, on a level plane */
    double global_w_per_m2;  /* of both, on a level plane */
    double sky_cover;    /* share of the sky that clouds cover, 0..1; a sky that
                          * fog hides counts as covered */
    double visibility_m; /* meteorological optical range */
    murk_visibility_limit visibility_limit;
    murk_weather_kind kind;
    double rain_mm_per_h; /* 0: no rain */
    bool rain_is_by_word; /* the report states light, moderate or heavy rain;
                             the rate is the middle of that class */
    double temperature_c, dew_point_c;
    double pressure_hpa; /* at the station; METAR: reduced to the sea level */
    char weather[MURK_WEATHER_GROUPS_SIZE]; /* the weather groups as they stand,
                                             * blanks between */
    char unknown[MURK_WEATHER_GROUPS_SIZE]; /* groups that the reader does not
                                             * know, blanks between; empty:
                                             * none */
    int day;    /* of the month, of a report; 0: not of a report */
    int minute; /* of that day, UTC, when the report was made */
} murk_observation;

/* All numbers NAN, except for rain 0; no weather. */
murk_observation murk_observation_empty(void);

/* True for a temperature that air can have. */
bool murk_is_of_air(double temperature_c);

/* The rate of rain or drizzle [mm/h] of a class of intensity: 0 light, 1
 * moderate, 2 heavy. Rain is light up to 2.5 and heavy from 7.6 mm/h on,
 * drizzle light up to .25 and heavy from .5 mm/h on (American Meteorological
 * Society, Glossary of Meteorology; U.S. Federal Meteorological Handbook 1).
 * The rates are the middles of the light and the moderate class, and twice the
 * limit of the heavy one. */
double murk_rain_of_class(bool is_drizzle, int intensity);

/* The clearness of the sky by the measured irradiances and the zenith angle of
 * the sun: the number of the class, 1 (overcast) to 8 (clear). Above 90 degrees
 * the angle counts as 90; without diffuse light the sky counts as clear.
 *
 * Source: Perez, Ineichen, Seals, Michalsky and Stewart, Solar Energy 44 (1990)
 * 271, doi:10.1016/0038-092X(90)90055-H. */
int murk_sky_clearness(double direct_w_per_m2, double diffuse_w_per_m2,
                       double sun_zenith_rad);

/* The type of the CIE standard general sky (source/dome.h), 1..15, that murk
 * uses for a class of clearness. The assignment is murk's own: it follows the
 * descriptions of both classifications, and no published table. */
int murk_sky_cie_type(int clearness);

#endif
