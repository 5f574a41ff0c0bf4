/* The sky of a clear night without moon: airglow, zodiacal light, stars, and
 * what towns add.
 *
 * It is a free, constant level. Astronomers state it at the zenith, in V
 * magnitudes per square arc second: 22 at the darkest places, 21.6 far from
 * towns, 18 over a city. A meter of sky quality reads this number.
 *
 * Towards the horizon there is more air that glows and more that dims; the
 * horizontal illuminance below follows both, Krisciunas and Schaefer's eq. 2.
 *
 * Sources: K. Krisciunas and B. E. Schaefer, Publ. Astron. Soc. Pac. 103
 * (1991) 1033, doi:10.1086/132921, for the scale and the law with zenith
 * distance. */
#ifndef MURK_SOURCE_NIGHT_SKY_H
#define MURK_SOURCE_NIGHT_SKY_H

/* A dark rural sky [V mag/arcsec2 at the zenith]. */
#define MURK_NIGHT_SKY_MAGNITUDE 21.6

/* Luminance [cd/m2] of a sky of so many V magnitudes per square arc second,
 * and back. 21.6 is 2.5e-4 cd/m2. The scale is good to some percent: it takes
 * the eye's spectral response for that of the V filter. */
double murk_sky_luminance(double mag_per_arcsec2);
double murk_sky_magnitude(double cd_per_m2);

/* Air mass along a line of sight to a scattering or glowing layer: 1 at the
 * zenith, 5 at the horizon (eq. 3). zenith_deg: 0..90. */
double murk_sky_path(double zenith_deg);

/* Luminance at a zenith distance of 0..90 degrees over that at the zenith.
 * extinction_mag: what the atmosphere takes in a vertical path, in V
 * magnitudes. */
double murk_night_sky_pattern(double zenith_deg, double extinction_mag);

/* Illuminance [lux] of a horizontal plane below the night sky that has
 * mag_per_arcsec2 at the zenith. */
double murk_night_sky_lux(double mag_per_arcsec2, double extinction_mag);

#endif
