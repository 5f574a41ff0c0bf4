/* How large droplets are: the modified gamma distribution
 *     n(r) = N norm r^a exp(-b r^c),    r in um, r > 0,
 * of which a = alpha, c = gamma in Deirmendjian's words and c = 1 is the gamma
 * distribution of Hansen and Travis. Only its shape is held here; N
 * multiplies what one droplet does on average.
 *
 * Droplets are counted from a radius of MURK_COUNTED_FROM_UM on: what haze has
 * below no counter sees and light hardly does. For fog and cloud it makes no
 * difference; Haze L has 2.2 % of its number there.
 *
 * Sources: Deirmendjian, Electromagnetic Scattering on Spherical
 * Polydispersions (1969); Hansen & Travis, Space Sci. Rev. 16 (1974) 527,
 * doi:10.1007/BF00168069. */
#ifndef MURK_PRESET_DROPLET_SIZES_H
#define MURK_PRESET_DROPLET_SIZES_H

#include "base/status.h"

#define MURK_COUNTED_FROM_UM .02

typedef struct murk_droplets {
    double a, b, c; /* exponents, and b in um^-c */
} murk_droplets;

/* Hansen and Travis: by effective radius [um] and effective variance, more
 * than 0 and less than 1/3. */
murk_droplets murk_droplets_gamma(double effective_radius_um,
                                  double effective_variance);

/* MURK_BAD_VALUE at `where` for shapes that no fog, cloud or haze has, which
 * bounds the work: a 0..40, c .1..6, effective radius .05..50 um, effective
 * variance .003..10, at least 1 % of the droplets counted. */
murk_status murk_droplets_check(const murk_droplets *shape, const char *where,
                                murk_error *err);

double murk_droplets_effective_radius_um(const murk_droplets *shape);
double murk_droplets_effective_variance(const murk_droplets *shape);

/* Liquid water [g/m3] of one droplet a cubic centimetre. */
double murk_droplets_water_g_per_m3(const murk_droplets *shape);

/* The distribution by the size parameter x at a wavelength [nm]. */
typedef struct murk_droplet_population {
    murk_droplets shape;
    double radius_um; /* of x = 1 */
    double log_norm;
} murk_droplet_population;

murk_droplet_population murk_droplet_population_of(const murk_droplets *shape,
                                                   double wavelength_nm);

/* The distribution times r^2 [um2] at x, for dr = r d(ln x). */
double murk_droplet_area(const murk_droplet_population *population, double x);

/* The sizes that matter: those between which all but 1e-7 of the integral lies,
 * by the weight of each end; none that Mie's series does not take. */
void murk_droplet_ends(const murk_droplet_population *population, double *min,
                       double *max);

#endif
