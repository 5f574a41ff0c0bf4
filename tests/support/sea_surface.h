/* How much light a wind-blown sea sends back: murk's facets, and what others
 * computed. */
#ifndef MURK_TESTS_SEA_SURFACE_H
#define MURK_TESTS_SEA_SURFACE_H

#include "base/stats.h"

#include <stdint.h>

#define SEA_INDEX 1.34

/* Share of light from a medium of index n_from at that cosine that murk's
 * surface sends back; of Lambertian light where the cosine is 0. */
murk_estimate sea_reflected(double n_from, double n_to,
                            double mean_square_slope, double cosine,
                            uint64_t photons, uint32_t seed);

/* Of the sun at that cosine, over slopes of that root mean square: a fit to
 * computed albedos of Cox and Munk's sea. Jin, Qiao, Wang, Fang and Yi, Opt.
 * Express 19 (2011) 26429, doi:10.1364/OE.19.026429, eq. 1, 2 and 4
 * (coefficients at second hand: ClimaAtmos.jl, surface albedo, 2024). */
double sea_sun_by_jin(double cosine, double slope);

/* Of Lambertian light on level water of index n: Walsh's closed form (Duntley,
 * J. Opt. Soc. Am. 32 (1942) 61, doi:10.1364/JOSA.32.000061). */
double sea_sky_by_walsh(double n);

#endif
