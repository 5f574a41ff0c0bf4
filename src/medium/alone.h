/* One medium of a world by itself: how much of it a ray crosses. */
#ifndef MURK_MEDIUM_ALONE_H
#define MURK_MEDIUM_ALONE_H

#include "medium/media.h"

/* The same regions, in which that medium alone extinguishes, with 1 per metre
 * times its density, in all bands: an optical depth is then its density path
 * [m], and a world's optical depth the sum over media of extinction_per_m times
 * density path. (A profile's density is its extinction, so its path has no
 * unit.) Regions that replace still hide what lay there. Grids are not copied,
 * and `media` must outlive it. Only for optical depths. *out is the caller's:
 * murk_media_destroy(). */
murk_status murk_media_alone(murk_media **out, const murk_media *media,
                             size_t medium, murk_error *err);

#endif
