/* Diffuse attenuation: how fast the sun's downward irradiance falls with depth,
 * and the absorption that a measured fall stands for. It is not the beam
 * attenuation, which is several times as much in turbid water.
 *
 * Kirk, Limnol. Oceanogr. 29 (1984) 350, doi:10.4319/lo.1984.29.2.0350, by
 * simulation with a harbour's phase function (backward share .019), mean over
 * the depths down to 1 % of the light:
 *
 *   Kd = sqrt(a^2 + G b a) / m,  G = .473 m - .218
 *
 * with absorption a, scattering b, and m the cosine of the sun's direction in
 * the water. Molecules scatter half of their light backward; their share of
 * b gets a G of 1.8, which fits this program's own light (the physics test of
 * diffuse attenuation is the check) at scattering below half the absorption,
 * between 1.7 and 1.9. */
#ifndef MURK_PRESET_WATER_KD_H
#define MURK_PRESET_WATER_KD_H

/* All in 1/m; scattering by particles and by the water's molecules. */
typedef struct murk_water_iop {
    double absorption_per_m, particles_per_m, molecules_per_m;
} murk_water_iop;

/* Cosine in water of index 1.34, below a level surface. */
double murk_water_sun_cosine(double zenith_in_air_deg);

double murk_water_kd(const murk_water_iop *water, double sun_cosine);

/* The absorption for which murk_water_kd() is kd_per_m: 0 or more. */
double murk_water_absorption_of_kd(double kd_per_m, double particles_per_m,
                                   double molecules_per_m, double sun_cosine);

#endif
