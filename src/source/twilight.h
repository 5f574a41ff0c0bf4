/* Light of the clear sky while the sun is below the horizon.
 *
 * Falls from 750 lux at sunset through 3.4 lux (sun 6 degrees down: civil
 * twilight ends) and 8e-3 lux (12 degrees, nautical) to nothing at 18 degrees
 * (astronomical). What the night itself gives (source/night_sky.h) comes on
 * top: the law's own rest at 18 degrees, 6e-4 lux, is taken off.
 *
 * Source: cubic polynomials in the sun's elevation for the logarithm of the
 * illuminance of a horizontal surface, stated error 2 %: P. M. Janiczek and
 * J. A. DeYoung, U.S. Naval Observatory Circular 171 (1987), also in
 * P. K. Seidelmann (ed.), Explanatory Supplement to the Astronomical Almanac
 * (1992); the coefficients at second hand, from three programs that agree
 * (E. O. Ofek's sunlight.m, D. A. Vallado's sunill). Where two polynomials
 * meet they differ by up to 1.2 %; half of that is given to each, so that
 * there is no step. */
#ifndef MURK_SOURCE_TWILIGHT_H
#define MURK_SOURCE_TWILIGHT_H

/* Below this elevation [degrees] the sun gives no light. */
#define MURK_TWILIGHT_END_DEG (-18.0)

/* Illuminance [lux] of a horizontal plane by the sky. sun_elevation_deg is
 * geometric (without refraction), of the sun's middle. Above 0 it stays what
 * it is at 0: the sky of sunrise is the larger of this and the clear sky's
 * diffuse light, which begins at nothing. */
double murk_twilight_lux(double sun_elevation_deg);

#endif
