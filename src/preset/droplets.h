/* Many spheres: cross sections and phase function of droplets of all sizes, as
 * fog, cloud and haze hold them. */
#ifndef MURK_PRESET_DROPLETS_H
#define MURK_PRESET_DROPLETS_H

#include "base/status.h"
#include "preset/droplet_sizes.h"
#include "preset/mie.h"

#include <stddef.h>

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
