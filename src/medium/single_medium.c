/* A shallow copy of the media with unit extinction in one medium and none in
 * the others (medium/single_medium.h). */
#include "medium/single_medium.h"

#include "medium/media_parts.h"

#include <assert.h>

murk_status murk_media_single(murk_media **out, const murk_media *media,
                              size_t medium, murk_error *err)
{
    assert(medium < media->n_media);
    murk_media *made = murk_media_shallow_copy(media);
    if (!made) {
        return murk_fail(err, MURK_NO_MEMORY, "media",
                         "no memory for %zu media", media->n_media);
    }
    for (size_t i = 0; i < made->n_media; ++i) {
        made->media[i].extinction_per_m =
            murk_spectrum_flat(i == medium, MURK_BANDS_MAX);
    }
    for (int band = 0; band < MURK_BANDS_MAX; ++band) {
        made->in_band[band] = true;
    }
    *out = made;
    return MURK_OK;
}
