/* Cross sections and phase function of a population of spherical droplets, as
 * in fog, cloud and haze. */
#ifndef MURK_PRESET_DROPLETS_H
#define MURK_PRESET_DROPLETS_H

#include "base/status.h"
#include "preset/droplet_sizes.h"
#include "preset/mie.h"

#include <stddef.h>

/* The mean optical properties of one counted droplet. */
typedef struct murk_droplet_optics {
    double extinction_um2, scattering_um2, absorption_um2;
    double mean_cosine;
    size_t radii; /* number of spheres that were computed */
} murk_droplet_optics;

/* A coefficient [1/m] is the cross section [um2] times this factor and the
 * number of droplets per cubic centimetre. */
#define MURK_PER_M_OF_UM2 1e-6

/* Computes the optical properties for a shape that passes
 * murk_droplets_check(), at a wavelength [nm] of 200..20000 with the refractive
 * index `index`. The step in radius is halved until there are at least 500
 * spheres, and until scattering (relative) and mean cosine change by at most
 * `tolerance`, 1e-4..0.1, and absorption by at most ten times that, or by less
 * than 1e-3 `tolerance` of the scattering.
 * phase_per_sr[i] becomes the phase function at the cosine mu[i]; with 0 angles
 * both may be NULL. Fails with MURK_NO_MEMORY, or with MURK_RUN_FAILED if the
 * tolerance is not met after seven halvings. */
murk_status murk_droplets_solve(murk_droplet_optics *out,
                                const murk_droplets *shape,
                                double wavelength_nm, murk_mie_index index,
                                double tolerance, size_t angles,
                                const double *mu, double *phase_per_sr,
                                murk_error *err);

/* Angles [degrees], 0..180, that resolve the phase function of any droplets: 0,
 * steps of 12 % from .005, below which the forward peak of the largest droplets
 * is flat, to 10, steps of 2 degrees to 130, of 1 degree, for the rainbows, to
 * 176, and of .5 and .25 degrees, for the glory, from there and from 179 on.
 * Returns the number of angles. */
#define MURK_DROPLET_ANGLES_MAX 200
size_t murk_droplet_angles(double angle_deg[MURK_DROPLET_ANGLES_MAX]);

#endif
