/* Sunlight under a sky without clouds, by Linke's turbidity.
 *
 * The irradiance model of Ineichen and Perez, Solar Energy 73 (2002) 151,
 * doi:10.1016/S0038-092X(02)00045-2: what the whole atmosphere above a place
 * leaves of the sun, weather included. Linke's turbidity says how many clean
 * and dry atmospheres would take as much at air mass 2: 2 very clear, 3 clear,
 * 5 hazy, 7 a large town. Over all wavelengths; spread over bands by
 * source/solar_spectrum.h. */
#ifndef MURK_SOURCE_CLEAR_SKY_H
#define MURK_SOURCE_CLEAR_SKY_H

/* The sun's irradiance at 1 au: Gueymard, Solar Energy 168 (2018) 2,
 * doi:10.1016/j.solener.2018.04.001. */
#define MURK_SOLAR_CONSTANT_W_PER_M2 1361.1

/* Outside of the atmosphere, at right angles, so far from the sun. */
double murk_extraterrestrial_w_per_m2(double distance_m);

/* The way through the atmosphere over the vertical one, by the apparent zenith
 * angle: Kasten and Young, Appl. Opt. 28 (1989) 4735,
 * doi:10.1364/AO.28.004735. 1 at the zenith, 38 at the horizon; infinite for a
 * sun more than a degree below it. */
double murk_relative_airmass(double apparent_zenith_deg);

/* The same in vertical sea-level atmospheres of 1013.25 hPa. */
double murk_absolute_airmass(double apparent_zenith_deg, double pressure_hpa);

typedef struct murk_clear_sky {
    double global_w_per_m2;  /* on a horizontal plane: direct and diffuse */
    double direct_w_per_m2;  /* of the sun, at right angles to its rays */
    double diffuse_w_per_m2; /* of the sky, on a horizontal plane */
} murk_clear_sky;

/* All 0 for a sun at or below the horizon. linke >= 1; altitude above the sea,
 * made for up to 3000 m or so. */
murk_clear_sky murk_clear_sky_at(double apparent_zenith_deg,
                                 double absolute_airmass, double linke,
                                 double altitude_m,
                                 double extraterrestrial_w_per_m2);

#endif
