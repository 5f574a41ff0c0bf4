/* Illuminance by the clear sky while the sun is below the horizon.
 *
 * The illuminance falls from 760 lux (center of the sun at the horizon) through
 * 3.4 lux (sun 6 degrees below the horizon: end of civil twilight) and 7.5e-3
 * lux (12 degrees, nautical) to 0 at 18 degrees (astronomical). Light of the
 * night sky (source/night_sky.h) is added by the caller: the value of the
 * polynomials at 18 degrees, 6e-4 lux, is subtracted here.
 *
 * Source: cubic polynomials in the elevation of the sun for the logarithm of
 * the illuminance of a horizontal surface, stated error 2 %: P. M. Janiczek and
 * J. A. DeYoung, U.S. Naval Observatory Circular 171 (1987), also in P. K.
 * Seidelmann (ed.), Explanatory Supplement to the Astronomical Almanac (1992).
 * The coefficients are from secondary sources, three programs that agree (among
 * them E. O. Ofek's sunlight.m and D. A. Vallado's sunill). Adjacent
 * polynomials differ by up to 1 % at the common end; each is shifted by half of
 * the difference, so that there is no step. */
#ifndef MURK_SOURCE_TWILIGHT_H
#define MURK_SOURCE_TWILIGHT_H

/* At this elevation [degrees] and below the sun gives no light. */
#define MURK_TWILIGHT_END_DEG (-18.0)

/* The illuminance [lux] of a horizontal plane by the sky. sun_elevation_deg is
 * the geometric elevation (without refraction) of the center of the sun. Above
 * 0 the value at 0 is returned: callers take the larger of this and the diffuse
 * light of the clear-sky model, which is 0 at sunrise. */
double murk_twilight_lux(double sun_elevation_deg);

#endif
