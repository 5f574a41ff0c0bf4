/* Geocentric positions of sun and moon. For use inside src/source only, and the
 * only user of libnova.
 *
 * Directions are apparent: they include light time and aberration. The frame is
 * the true equator and equinox of date: x to the equinox, z to the pole. The
 * earth follows VSOP87 (Bretagnon and Francou, Astron. Astrophys. 202 (1988)
 * 309), the moon ELP 2000-82B (Chapront-Touze and Chapront, Astron. Astrophys.
 * 124 (1983) 50), both from libnova, which gives them for the ecliptic and
 * equinox of J2000. Precession: IAU 1976 (Lieske et al., Astron. Astrophys. 58
 * (1977) 1); nutation: IAU 1980 (libnova); sidereal time: IAU 1982 (Aoki et
 * al., Astron. Astrophys. 105 (1982) 359), as in Meeus, Astronomical
 * Algorithms, 2nd ed. 1998, ch. 12, 21, 22.
 *
 * libnova caches the last results in global variables, without a lock and, for
 * nutation, for a tenth of a day. The functions of this header are safe on any
 * thread, and the results do not depend on earlier calls. */
#ifndef MURK_SOURCE_GEOCENTRIC_H
#define MURK_SOURCE_GEOCENTRIC_H

#include "base/vector.h"

/* Positions in metres from the center of the earth; the time is terrestrial
 * (TT). */
murk_vec3 murk_geocentric_sun_m(double julian_date_tt);
murk_vec3 murk_geocentric_moon_m(double julian_date_tt);

/* The angle from the true equinox to the meridian of Greenwich [rad], not
 * reduced to one turn. */
double murk_sidereal_time_rad(double julian_date_ut, double julian_date_tt);

/* The obliquity: the angle between the true equator and the ecliptic [rad]. */
double murk_true_obliquity_rad(double julian_date_tt);

/* Terrestrial time minus universal time [s], for the years 1900 to 2150:
 * Espenak and Meeus, Five Millennium Canon of Solar Eclipses,
 * NASA/TP-2006-214141, table of polynomials. Values from 2005 on are a forecast
 * of 2006, which was some 5 s too large by 2025; this is .0001 degrees for the
 * sun and .001 degrees for the moon. */
double murk_delta_t_s(double julian_date_ut);

#endif
