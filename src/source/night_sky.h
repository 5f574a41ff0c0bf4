/* The sky of a clear night without moon: airglow, zodiacal light, stars, and
 * light pollution.
 *
 * The brightness is a free, constant level, given at the zenith in V magnitudes
 * per square arc second as in astronomy: 22 at the darkest places, 21.6 far
 * from towns, 18 in a city. A sky quality meter shows this number.
 *
 * Towards the horizon the line of sight crosses more glowing and more absorbing
 * air; the distribution follows both (Krisciunas and Schaefer, eq. 2).
 *
 * Source of the scale and of the dependence on zenith distance: K. Krisciunas
 * and B. E. Schaefer, Publ. Astron. Soc. Pac. 103 (1991) 1033,
 * doi:10.1086/132921. */
#ifndef MURK_SOURCE_NIGHT_SKY_H
#define MURK_SOURCE_NIGHT_SKY_H

/* A dark rural sky [V mag/arcsec2 at the zenith]. */
#define MURK_NIGHT_SKY_MAGNITUDE 21.6

/* Converts V magnitudes per square arc second to luminance [cd/m2], and back.
 * 21.6 is 2.5e-4 cd/m2. The scale is accurate to some percent, because it takes
 * the V filter for the spectral response of the eye. */
double murk_sky_luminance(double mag_per_arcsec2);
double murk_sky_magnitude(double cd_per_m2);

/* Air mass along a line of sight to a scattering or glowing layer: 1 at the
 * zenith, 5 at the horizon (eq. 3). zenith_deg: 0..90. */
double murk_sky_path(double zenith_deg);

/* The luminance at a zenith distance of 0..90 degrees divided by that at the
 * zenith. extinction_mag: extinction of the atmosphere in a vertical path, in V
 * magnitudes. */
double murk_night_sky_pattern(double zenith_deg, double extinction_mag);

/* The illuminance [lux] of a horizontal plane under a night sky with
 * mag_per_arcsec2 at the zenith. */
double murk_night_sky_lux(double mag_per_arcsec2, double extinction_mag);

#endif
