/* The size distribution of droplets: the modified gamma distribution
 *
 *   n(r) = N norm r^a exp(-b r^c), r in um, r > 0,
 *
 * with a = alpha and c = gamma of Deirmendjian; c = 1 is the gamma distribution
 * of Hansen and Travis. The factor norm makes N the number of counted droplets
 * per volume. The structs hold the shape only; results are for N = 1, and the
 * caller multiplies them by N.
 *
 * Droplets are counted from a radius of MURK_COUNTED_FROM_UM, because counters
 * do not detect smaller ones and they hardly affect light. For fog and cloud
 * this makes no difference; Haze L has 2.2 % of the droplets below that radius.
 *
 * Sources: Deirmendjian, Electromagnetic Scattering on Spherical
 * Polydispersions (1969); Hansen & Travis, Space Sci. Rev. 16 (1974) 527,
 * doi:10.1007/BF00168069. */
#ifndef MURK_PRESET_DROPLET_SIZES_H
#define MURK_PRESET_DROPLET_SIZES_H

#include "base/status.h"

#define MURK_COUNTED_FROM_UM .02 /* see above */

typedef struct murk_droplets {
    double a, b, c; /* exponents a and c; b in um^-c */
} murk_droplets;

/* Fails with MURK_BAD_VALUE at `where` for shapes that no fog, cloud or haze
 * has. The limits bound the computing time: a 0..40, c .1..6, b > 0, effective
 * radius .05..50 um, effective variance .003..10, at least 1 % of the droplets
 * counted. */
murk_status murk_droplets_check(const murk_droplets *shape, const char *where,
                                murk_error *err);

double murk_droplets_effective_radius_um(const murk_droplets *shape);
double murk_droplets_effective_variance(const murk_droplets *shape);

/* The liquid water [g/m3] of one counted droplet per cubic centimetre. */
double murk_droplets_water_g_per_m3(const murk_droplets *shape);

/* The distribution as a function of the size parameter x (preset/mie.h) at a
 * wavelength [nm]. */
typedef struct murk_droplet_population {
    murk_droplets shape;
    double radius_um; /* radius at x = 1 */
    /* logarithm of `norm` for counted droplets */
    double log_norm;
} murk_droplet_population;

murk_droplet_population murk_droplet_population_of(const murk_droplets *shape,
                                                   double wavelength_nm);

/* n(r) r^3 [um2] at size parameter x for N = 1, where an integral of n(r) r^2
 * dr is an integral of n(r) r^3 d(ln x). */
double murk_droplet_area(const murk_droplet_population *population, double x);

/* The range of size parameters, *min to *max, outside of which about 1e-7 of
 * the cross sections lies at each end, cut to the range that murk_mie_solve()
 * accepts. */
void murk_droplet_ends(const murk_droplet_population *population, double *min,
                       double *max);

#endif
