/* Light of the moon: straight from its disc, and scattered by a clear sky.
 *
 * By phase angle (0 at full moon, 90 at the quarters, 180 at new moon),
 * distance, elevation and the extinction of the atmosphere. The full moon is
 * brighter than the trend of its phases by up to 35 % within 7 degrees of
 * opposition. An eclipse is not seen: at phase angles below 1.5 degrees the
 * real moon lies in the earth's shadow.
 *
 * Source: K. Krisciunas and B. E. Schaefer, A model of the brightness of
 * moonlight, Publ. Astron. Soc. Pac. 103 (1991) 1033, doi:10.1086/132921,
 * made for the V band; they found it good to 8..23 %. */
#ifndef MURK_SOURCE_MOONLIGHT_H
#define MURK_SOURCE_MOONLIGHT_H

typedef struct murk_moon {
    double phase_angle_deg; /* 0..180 */
    double distance_m;      /* of its middle from the observer */
    double elevation_deg;   /* apparent, -90..90 */
} murk_moon;

typedef struct murk_moonlight {
    double direct_lux;  /* on a plane at right angles to the light */
    double diffuse_lux; /* on a horizontal plane, from the moonlit sky */
} murk_moonlight;

/* Illuminance [lux] at right angles, outside of the atmosphere. */
double murk_moon_lux(double phase_angle_deg, double distance_m);

/* What the atmosphere takes in a vertical path, in V magnitudes: molecules by
 * the height of the place, ozone, and aerosol by the turbidity (Linke's, at
 * air mass 2: 2 very clear, 3 clear, 5 hazy).
 * Source for the aerosol: P. Ineichen, Solar Energy 82 (2008) 1095,
 * doi:10.1016/j.solener.2008.04.010, at 1 cm of water vapour; the formula at
 * second hand, from code that names it. */
double murk_visual_extinction(double linke_turbidity, double altitude_m);

/* Luminance [cd/m2] that moonlight gives a clear sky at a zenith distance of
 * 0..90 degrees and an angle of separation_deg from the moon, for the given
 * vertical extinction [mag]. While the moon is below the horizon it falls as
 * twilight does: the moon is a small sun. */
double murk_moonlit_sky(const murk_moon *moon, double zenith_deg,
                        double separation_deg, double extinction_mag);

/* Both parts at the ground. The disc's air mass is source/clear_sky.h's. */
murk_moonlight murk_moonlight_at(const murk_moon *moon, double extinction_mag);

#endif
