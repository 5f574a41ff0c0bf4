/* Positions, distances and sizes of sun and moon in the sky of an observer.
 *
 * Geocentric positions (source/geocentric.h) are converted to the position of
 * the observer on the ellipsoid (WGS 84), so all results include parallax. UTC
 * is used as universal time; the two times differ by less than .9 s, in which
 * the sky turns by less than .004 degrees. Refraction: Bennett, J. Navig. 35
 * (1982) 255, doi:10.1017/S0373463300022037, inverted by Saemundsson, Sky and
 * Telescope 72 (1986) 70, with pressure and temperature as in the SPA of NREL
 * (Reda and Andreas, Solar Energy 76 (2004) 577,
 * doi:10.1016/j.solener.2003.12.003). As in the SPA, there is no refraction for
 * a body whose upper edge is more than .5667 degrees, the refraction at the
 * horizon, below the horizon.
 *
 * Results are within .0005 degrees of the SPA. Safe on any thread. */
#ifndef MURK_SOURCE_EPHEMERIS_H
#define MURK_SOURCE_EPHEMERIS_H

#include "base/status.h"

/* The range of Julian dates (UTC), TO excluded: the years 1900 to 2149, for
 * which terrestrial time is known or forecast. */
#define MURK_EPHEMERIS_FROM 2415020.5
#define MURK_EPHEMERIS_TO   2506331.5

/* An observer on the earth. */
typedef struct murk_observer {
    double latitude_deg;  /* -90..90, north positive */
    double longitude_deg; /* -180..360, east positive */
    double altitude_m;    /* above sea level, -500..20000 */
    double pressure_hpa;  /* of the air at the observer, up to 1200; 0: that of
                           * the standard atmosphere,
                           * murk_standard_pressure_hpa() */
    double temperature_c; /* of the air at the observer, -100..100 */
} murk_observer;

/* The sun or the moon as the observer sees it. */
typedef struct murk_body {
    double azimuth_deg;             /* 0..360, clockwise from north */
    double elevation_deg;           /* apparent: raised by refraction */
    double geometric_elevation_deg; /* without air */
    double distance_m;              /* from the observer */
    double diameter_deg;            /* of the disc */
    double illuminated;             /* lit share of the disc, 0..1 */
    double phase_angle_deg; /* angle at the body between sun and observer: 0 for
                             * a full moon, 180 for a new moon */
} murk_body;

/* The sun and the moon at a date. Fail with MURK_BAD_VALUE for a date or an
 * observer outside the ranges above (also NaN), and leave *out unchanged. For
 * the sun, illuminated is 1 and the phase angle is 0. */
murk_status murk_sun_at(murk_body *out, const murk_observer *observer,
                        double julian_date_utc, murk_error *err);
murk_status murk_moon_at(murk_body *out, const murk_observer *observer,
                         double julian_date_utc, murk_error *err);

/* The pressure of the ICAO standard atmosphere (ISO 2533:1975) below 11 km
 * [hPa]. */
double murk_standard_pressure_hpa(double altitude_m);

/* The refraction [degrees] for a geometric elevation from about -1 degree to 90
 * degrees. */
double murk_refraction_deg(double geometric_elevation_deg, double pressure_hpa,
                           double temperature_c);

#endif
