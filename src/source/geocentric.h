/* Sun and moon as seen from the middle of the earth. Private to this room, and
 * the one door to libnova.
 *
 * Directions are apparent: light time and aberration are in them. The frame is
 * the true equator and equinox of date: x to the equinox, z to the pole.
 * Earth by VSOP87 (Bretagnon and Francou, Astron. Astrophys. 202 (1988) 309),
 * moon by ELP 2000-82B (Chapront-Touze and Chapront, Astron. Astrophys. 124
 * (1983) 50), both from libnova, which gives them for the ecliptic and equinox
 * of J2000; precession IAU 1976 (Lieske et al., Astron. Astrophys. 58 (1977)
 * 1), nutation IAU 1980 (libnova), sidereal time IAU 1982 (Aoki et al.,
 * Astron. Astrophys. 105 (1982) 359), as in Meeus, Astronomical Algorithms,
 * 2nd ed. 1998, ch. 12, 21, 22.
 *
 * libnova keeps its last answers in variables of its own, without a lock and,
 * for nutation, for a tenth of a day. These functions may be called from any
 * thread, and their answers do not depend on what was asked before. */
#ifndef MURK_SOURCE_GEOCENTRIC_H
#define MURK_SOURCE_GEOCENTRIC_H

#include "base/vector.h"

/* Metres from the middle of the earth; the time is terrestrial (TT). */
murk_vec3 murk_geocentric_sun_m(double julian_date_tt);
murk_vec3 murk_geocentric_moon_m(double julian_date_tt);

/* The angle from the true equinox to the meridian of Greenwich [rad], not
 * reduced to a turn. */
double murk_sidereal_time_rad(double julian_date_ut, double julian_date_tt);

/* Tilt of the true equator against the ecliptic [rad]. */
double murk_true_obliquity_rad(double julian_date_tt);

/* Terrestrial less universal time [s], for the years 1900 to 2150: Espenak and
 * Meeus, Five Millennium Canon of Solar Eclipses, NASA/TP-2006-214141, table
 * of polynomials. From 2005 on it is a forecast of 2006, some 6 s above what
 * came by 2025; that is .0001 degrees for the sun, .001 for the moon. */
double murk_delta_t_s(double julian_date_ut);

#endif
