/* Irradiance under a cloudless sky, by Linke turbidity.
 *
 * The model of Ineichen and Perez, Solar Energy 73 (2002) 151,
 * doi:10.1016/S0038-092X(02)00045-2, gives the irradiance by sun and sky at the
 * ground. Linke turbidity is the number of clean and dry atmospheres that have
 * the same attenuation at air mass 2: 2 very clear, 3 clear, 5 hazy, 7 a large
 * town. The irradiances are sums over all wavelengths; source/solar_spectrum.h
 * distributes them over bands. */
#ifndef MURK_SOURCE_CLEAR_SKY_H
#define MURK_SOURCE_CLEAR_SKY_H

/* The solar irradiance at 1 au: Gueymard, Solar Energy 168 (2018) 2,
 * doi:10.1016/j.solener.2018.04.001. */
#define MURK_SOLAR_CONSTANT_W_PER_M2 1361.1

/* The irradiance outside of the atmosphere, on a plane at right angles to the
 * rays, at a distance from the sun. */
double murk_extraterrestrial_w_per_m2(double distance_m);

/* The relative air mass: the length of the path through the atmosphere divided
 * by that of the vertical path, by apparent zenith angle (Kasten and Young,
 * Appl. Opt. 28 (1989) 4735, doi:10.1364/AO.28.004735). 1 at the zenith, 38 at
 * the horizon; infinite for a sun more than a degree below the horizon. */
double murk_relative_airmass(double apparent_zenith_deg);

/* The air mass in units of vertical sea-level atmospheres of 1013.25 hPa. */
double murk_absolute_airmass(double apparent_zenith_deg, double pressure_hpa);

/* Irradiance at the ground. */
typedef struct murk_clear_sky {
    double global_w_per_m2;  /* on a horizontal plane: direct and diffuse */
    double direct_w_per_m2;  /* of the sun, at right angles to the rays */
    double diffuse_w_per_m2; /* of the sky, on a horizontal plane */
} murk_clear_sky;

/* The irradiance under a clear sky; 0 for a sun at or below the horizon, or if
 * the air mass is not finite. linke: the Linke turbidity, at least 1; the
 * altitude is above sea level, and the model was made for altitudes up to about
 * 3000 m. */
murk_clear_sky murk_clear_sky_at(double apparent_zenith_deg,
                                 double absolute_airmass, double linke,
                                 double altitude_m,
                                 double extraterrestrial_w_per_m2);

#endif
