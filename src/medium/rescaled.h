/* Media with other extinctions in the same regions: for optical depths in
 * some media only, or with an apparent extinction. */
#ifndef MURK_MEDIUM_RESCALED_H
#define MURK_MEDIUM_RESCALED_H

#include "medium/media.h"

/* Replaces the extinction of each medium by
 * extinction_per_m[murk_media_count(media)], 0 or more; densities stay.
 * Regions that replace others still do. Grids are not copied, and `media`
 * must outlive *out. For optical depths only: albedo and phase function are
 * those of the original media. Fails with MURK_NO_MEMORY. The caller owns
 * *out and releases it with murk_media_destroy(). */
murk_status murk_media_rescale(murk_media **out, const murk_media *media,
                               const murk_spectrum *extinction_per_m,
                               murk_error *err);

#endif
