/* Moonlight: direct light of the disc, and light scattered by a clear sky.
 *
 * The result depends on phase angle (0 at full moon, 90 at the quarters, 180 at
 * new moon), distance, elevation and the extinction of the atmosphere. Within 7
 * degrees of opposition the full moon is up to 35 % brighter than the trend of
 * the other phases. Eclipses are not modelled: at phase angles below 1.5
 * degrees the real moon lies in the shadow of the earth.
 *
 * Source: K. Krisciunas and B. E. Schaefer, A model of the brightness of
 * moonlight, Publ. Astron. Soc. Pac. 103 (1991) 1033, doi:10.1086/132921, for
 * the V band; the stated error is 8..23 %. */
#ifndef MURK_SOURCE_MOONLIGHT_H
#define MURK_SOURCE_MOONLIGHT_H

/* The moon as seen by the observer. */
typedef struct murk_moon {
    double phase_angle_deg; /* 0..180 */
    double distance_m;      /* from the observer to the center of the moon */
    double elevation_deg;   /* apparent, -90..90 */
} murk_moon;

/* Illuminance at the ground. */
typedef struct murk_moonlight {
    double direct_lux;  /* on a plane at right angles to the light */
    double diffuse_lux; /* on a horizontal plane, from the moonlit sky */
} murk_moonlight;

/* The illuminance [lux] of a plane at right angles to the light, outside of the
 * atmosphere. */
double murk_moon_lux(double phase_angle_deg, double distance_m);

/* The extinction of a vertical path through the atmosphere in V magnitudes:
 * molecules by the altitude of the place, ozone, and aerosol by Linke turbidity
 * (at air mass 2: 2 very clear, 3 clear, 5 hazy). Source for the aerosol: P.
 * Ineichen, Solar Energy 82 (2008) 1095, doi:10.1016/j.solener.2008.04.010, at
 * 1 cm of water vapour; the formula is from a secondary source, code that names
 * the paper. */
double murk_visual_extinction(double linke_turbidity, double altitude_m);

/* The luminance [cd/m2] of a clear sky by moonlight, at a zenith distance of
 * 0..90 degrees and an angle of separation_deg from the moon, for a vertical
 * extinction [mag]. While the moon is below the horizon, the luminance falls
 * like twilight by the sun. */
double murk_moonlit_sky(const murk_moon *moon, double zenith_deg,
                        double separation_deg, double extinction_mag);

/* Both illuminances at the ground. The air mass of the direct light is that of
 * source/clear_sky.h. The direct light is 0 if the moon is at or below the
 * horizon, the light of the sky if the moon is 18 degrees or more below the
 * horizon. */
murk_moonlight murk_moonlight_at(const murk_moon *moon, double extinction_mag);

#endif
