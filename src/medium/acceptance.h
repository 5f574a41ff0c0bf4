/* Media as an instrument sees them that takes light scattered a little forward
 * for light not scattered at all: what turns by less than its acceptance angle
 * is not lost. Extinction becomes
 *     sigma_t - sigma_s F,   F = 2 pi int_0^acceptance p(theta) sin(theta),
 * by medium and band. Half of what a raindrop takes out is diffracted by less
 * than .02 degrees, and some 22 % of what sea water scatters turns by less than
 * .93 degrees, so what a transmissometer or camera reports depends on it.
 *
 * Sources: Voss and Austin, J. Atmos. Oceanic Technol. 10 (1993) 113; Boss et
 * al., Opt. Express 17 (2009) 1535, doi:10.1364/OE.17.001535. */
#ifndef MURK_MEDIUM_ACCEPTANCE_H
#define MURK_MEDIUM_ACCEPTANCE_H

#include "medium/media.h"

/* F of one medium in one band. */
double murk_medium_accepted(const murk_medium *medium, int band,
                            double acceptance_rad);

/* Whether that can be told of all media in use: fails with MURK_BAD_VALUE at
 * one whose albedo is a grid, so that its share of scattering is not one
 * number. */
murk_status murk_media_check_acceptance(const murk_media *media,
                                        murk_error *err);

/* The same regions with those extinctions, for optical depths; grids are not
 * copied, and `media` must outlive it. acceptance_rad: 0..pi. Scattering and
 * collisions are not for this: albedo and phase function are still those of all
 * light. Fails as murk_media_check_acceptance() or with MURK_NO_MEMORY. *out is
 * the caller's: murk_media_destroy(). */
murk_status murk_media_accepting(murk_media **out, const murk_media *media,
                                 double acceptance_rad, murk_error *err);

#endif
