/* Density path of one medium: the optical depth with all other media removed
 * and the extinction set to 1 per metre times density. */
#ifndef MURK_MEDIUM_SINGLE_MEDIUM_H
#define MURK_MEDIUM_SINGLE_MEDIUM_H

#include "medium/media.h"

/* A copy of the media in which only `medium` has an extinction: 1 per metre
 * times density, in all bands. An optical depth in the copy is the density
 * path [m] of the medium; the optical depth in `media` is the sum over all
 * media of extinction_per_m times density path. (The density of a profile is
 * an extinction, so the density path of a profile has no unit.) Regions that
 * replace others still do. Grids are not copied, and `media` must outlive
 * the copy. For optical depths only. The caller owns *out and releases it
 * with murk_media_destroy(). */
murk_status murk_media_single(murk_media **out, const murk_media *media,
                              size_t medium, murk_error *err);

#endif
