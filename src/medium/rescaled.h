/* The same regions, whose media extinguish otherwise: for optical depths in
 * some media alone, or in media seen in another way. */
#ifndef MURK_MEDIUM_RESCALED_H
#define MURK_MEDIUM_RESCALED_H

#include "medium/media.h"

/* extinction_per_m[murk_media_count(media)], 0 or more: in place of the media's
 * own, times the same densities. What a region hides it still hides. Grids are
 * not copied, and `media` must outlive it. Scattering and collisions are not
 * for this: albedo and phase function are still the media's own. Fails with
 * MURK_NO_MEMORY. *out is the caller's: murk_media_destroy(). */
murk_status murk_media_rescale(murk_media **out, const murk_media *media,
                               const murk_spectrum *extinction_per_m,
                               murk_error *err);

#endif
