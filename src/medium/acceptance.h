/* Apparent extinction for an instrument with a finite acceptance angle.
 *
 * Light that is scattered by less than the acceptance angle still reaches the
 * detector, so the instrument counts it as transmitted. The apparent extinction
 * is sigma_t - sigma_s F,   F = 2 pi int_0^acceptance p(theta) sin(theta), for
 * each medium and band. Half of the extinction of a raindrop is diffraction by
 * less than 0.02 degrees, and some 22 % of the scattering of sea water is by
 * less than 0.93 degrees, so the reading of a transmissometer or camera depends
 * on the acceptance angle.
 *
 * Sources: Voss and Austin, J. Atmos. Oceanic Technol. 10 (1993) 113; Boss
 * et al., Opt. Express 17 (2009) 1535, doi:10.1364/OE.17.001535. */
#ifndef MURK_MEDIUM_ACCEPTANCE_H
#define MURK_MEDIUM_ACCEPTANCE_H

#include "medium/media.h"

/* The share F of one medium in one band. */
double murk_medium_accepted(const murk_medium *medium, int band,
                            double acceptance_rad);

/* Checks that F is defined for all media in use. Fails with MURK_BAD_VALUE
 * at a medium whose albedo is a grid, because the scattering share is then
 * not one number. */
murk_status murk_media_check_acceptance(const murk_media *media,
                                        murk_error *err);

/* A copy of the media with the apparent extinctions, for optical depths
 * only: albedo and phase function are unchanged, so scattering and
 * collisions would be wrong. acceptance_rad is 0..pi. Grids are not copied,
 * and `media` must outlive the copy. Fails as murk_media_check_acceptance()
 * or with MURK_NO_MEMORY. The caller owns *out and releases it with
 * murk_media_destroy(). */
murk_status murk_media_accepting(murk_media **out, const murk_media *media,
                                 double acceptance_rad, murk_error *err);

#endif
