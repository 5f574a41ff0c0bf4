/* Many spheres: cross sections and phase function of droplets of all sizes,
 * as fog, cloud and haze hold them.
 *
 * Sizes follow the modified gamma distribution
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
#ifndef MURK_PRESET_DROPLETS_H
#define MURK_PRESET_DROPLETS_H

#include "base/status.h"
#include "preset/mie.h"

#include <stddef.h>

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

/* What one counted droplet does on average. */
typedef struct murk_droplet_optics {
    double extinction_um2, scattering_um2, absorption_um2;
    double mean_cosine;
    size_t radii; /* spheres that were solved */
} murk_droplet_optics;

/* Coefficients [1/m] are cross sections [um2] times this and droplets per
 * cubic centimetre. */
#define MURK_PER_M_OF_UM2 1e-6

/* A shape that passes the check, at a wavelength [nm] of 200..20000, of index
 * `index` at it. Steps in radius are halved until scattering (relative) and
 * mean cosine move by less than `tolerance`, 1e-4..0.1, and absorption by less
 * than ten times that. phase_per_sr[i] is the phase
 * function at the cosine mu[i]; with 0 angles both may be NULL. Fails with
 * MURK_NO_MEMORY, or MURK_RUN_FAILED where the tolerance is not met. */
murk_status murk_droplets_solve(murk_droplet_optics *out,
                                const murk_droplets *shape,
                                double wavelength_nm, murk_mie_index index,
                                double tolerance, size_t angles,
                                const double *mu, double *phase_per_sr,
                                murk_error *err);

/* Angles [degrees], 0..180, that carry the phase function of any droplets: by
 * 12 % each from .005 on, where the forward peak of the largest is flat, then
 * 2 degrees apart, 1 from the rainbows on, .25 in the glory. Gives how many. */
#define MURK_DROPLET_ANGLES_MAX 200
size_t murk_droplet_angles(double angle_deg[MURK_DROPLET_ANGLES_MAX]);

#endif
