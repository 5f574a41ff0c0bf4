/* Copies of media with other extinctions in the same regions, for optical
 * depths only: albedo and phase function stay those of the original media, so
 * scattering and collisions would be wrong. Regions that replace others still
 * do. Grids are not copied, and the original media must outlive the copy. The
 * caller owns *out and releases it with murk_media_destroy(). */
#ifndef MURK_MEDIUM_RESCALED_H
#define MURK_MEDIUM_RESCALED_H

#include "medium/media.h"

/* Replaces the extinction of each medium by
 * extinction_per_m[murk_media_count(media)], 0 or more; densities stay. Fails
 * with MURK_NO_MEMORY. */
murk_status murk_media_rescale(murk_media **out, const murk_media *media,
                               const murk_spectrum *extinction_per_m,
                               murk_error *err);

/* Only `medium` keeps an extinction: 1 per metre times density, in all bands.
 * An optical depth in the copy is the density path [m] of the medium; the
 * optical depth in `media` is the sum over all media of extinction_per_m times
 * density path. (The density of a profile is an extinction, so the density path
 * of a profile has no unit.) Fails with MURK_NO_MEMORY. */
murk_status murk_media_single(murk_media **out, const murk_media *media,
                              size_t medium, murk_error *err);

/* Apparent extinctions for an instrument with a finite acceptance angle, 0..pi.
 *
 * Light that is scattered by less than the acceptance angle still reaches the
 * detector, so the instrument counts it as transmitted. The apparent extinction
 * is sigma_t - sigma_s F,   F = 2 pi int_0^acceptance p(theta) sin(theta), for
 * each medium and band. Half of the extinction of a raindrop is diffraction by
 * less than 0.02 degrees, and some 22 % of the scattering of sea water is by
 * less than 0.93 degrees, so the reading of a transmissometer or camera depends
 * on the acceptance angle.
 *
 * Fails with MURK_NO_MEMORY, or as murk_media_check_acceptance().
 *
 * Sources: Voss and Austin, J. Atmos. Oceanic Technol. 10 (1993) 113; Boss
 * et al., Opt. Express 17 (2009) 1535, doi:10.1364/OE.17.001535. */
murk_status murk_media_accepting(murk_media **out, const murk_media *media,
                                 double acceptance_rad, murk_error *err);

/* Checks that murk_media_accepting() is defined for all media of regions. Fails
 * with MURK_BAD_VALUE at a medium whose albedo is a grid, because sigma_s is
 * then not one number times sigma_t. */
murk_status murk_media_check_acceptance(const murk_media *media,
                                        murk_error *err);

#endif
