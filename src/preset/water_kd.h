/* Diffuse attenuation: the rate at which the downward irradiance of sunlight
 * falls with depth, and the absorption that follows from a measured rate.
 * Diffuse attenuation is not beam attenuation, which is several times as large
 * in turbid water.
 *
 * Kirk, Limnol. Oceanogr. 29 (1984) 350, doi:10.4319/lo.1984.29.2.0350, by
 * simulation with the phase function of a harbour (backward share .019),
 * averaged over the depths down to 1 % of the light:
 *
 *   Kd = sqrt(a^2 + G b a) / m,  G = .473 m - .218
 *
 * with absorption a, scattering b, and m the cosine of the direction of the sun
 * in the water. Molecules scatter half of the light backward. Their share of b
 * has G = 1.8, a value between 1.7 and 1.9 that fits simulations of this
 * program at scattering below half of the absorption (tested by the physics
 * test of diffuse attenuation). */
#ifndef MURK_PRESET_WATER_KD_H
#define MURK_PRESET_WATER_KD_H

/* The cosine of the direction of the sun in water of index 1.34, below a level
 * surface. */
double murk_water_sun_cosine(double zenith_in_air_deg);

/* The total absorption [1/m], 0 or more, for which Kd is kd_per_m, with
 * scattering by particles and by molecules [1/m]. 0 if kd_per_m is not above 0.
 */
double murk_water_absorption_of_kd(double kd_per_m, double particles_per_m,
                                   double molecules_per_m, double sun_cosine);

#endif
