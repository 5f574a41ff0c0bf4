/* Where sun and moon stand in an observer's sky, and how large and how far.
 *
 * From geocentric places (source/geocentric.h) by the observer's own place on
 * the ellipsoid (WGS 84), so parallax is in all that is given here. Universal
 * time is taken for UTC; they differ by less than .9 s, which turns the sky by
 * less than .004 degrees. Refraction: Bennett, J. Navig. 35 (1982) 255,
 * doi:10.1017/S0373463300022037, turned round by Saemundsson, Sky and
 * Telescope 72 (1986) 70, with pressure and temperature as in NREL's SPA (Reda
 * and Andreas, Solar Energy 76 (2004) 577, doi:10.1016/j.solener.2003.12.003);
 * it is left out, as there, for a body that is wholly below the horizon.
 *
 * Within .0005 degrees of the SPA. May be called from any thread. */
#ifndef MURK_SOURCE_EPHEMERIS_H
#define MURK_SOURCE_EPHEMERIS_H

#include "base/status.h"

/* The Julian dates (UTC) for which positions are given: the years 1900 to
 * 2149, in which terrestrial time is known or forecast. */
#define MURK_EPHEMERIS_FROM 2415020.5
#define MURK_EPHEMERIS_TO   2506331.5

typedef struct murk_observer {
    double latitude_deg;  /* -90..90, north positive */
    double longitude_deg; /* -180..360, east positive */
    double altitude_m;    /* above the sea, -500..20000 */
    double pressure_hpa;  /* of the air there, up to 1200; 0: the standard
                             atmosphere's, murk_standard_pressure_hpa() */
    double temperature_c; /* of the air there, -100..100 */
} murk_observer;

typedef struct murk_body {
    double azimuth_deg;             /* 0..360, clockwise from north */
    double elevation_deg;           /* apparent: raised by refraction */
    double geometric_elevation_deg; /* without air */
    double distance_m;              /* from the observer */
    double diameter_deg;            /* of the disc */
    double illuminated;             /* share of the disc that is lit, 0..1 */
    double phase_angle_deg; /* at the body, between sun and observer: 0 for a
                               full moon, 180 for a new one */
} murk_body;

/* Fail with MURK_BAD_VALUE for a date or an observer outside the ranges above
 * (NaN too), and leave *out untouched. For the sun, illuminated is 1 and the
 * phase angle 0. */
murk_status murk_sun_at(murk_body *out, const murk_observer *observer,
                        double julian_date_utc, murk_error *err);
murk_status murk_moon_at(murk_body *out, const murk_observer *observer,
                         double julian_date_utc, murk_error *err);

/* ICAO standard atmosphere (ISO 2533:1975) below 11 km [hPa]. */
double murk_standard_pressure_hpa(double altitude_m);

/* What air adds to an elevation above the horizon [degrees]. */
double murk_refraction_deg(double geometric_elevation_deg, double pressure_hpa,
                           double temperature_c);

#endif
