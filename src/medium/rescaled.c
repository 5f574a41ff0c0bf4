/* A shallow copy of the media with other extinctions (medium/rescaled.h). */
#include "medium/rescaled.h"

#include "medium/media_parts.h"

murk_status murk_media_rescale(murk_media **out, const murk_media *media,
                               const murk_spectrum *extinction_per_m,
                               murk_error *err)
{
    murk_media *made = murk_media_shallow_copy(media);
    if (!made) {
        return murk_fail(err, MURK_NO_MEMORY, "media",
                         "no memory for %zu media", media->n_media);
    }
    for (size_t i = 0; i < media->n_media; ++i) {
        made->media[i].extinction_per_m = extinction_per_m[i];
    }
    for (int band = 0; band < MURK_BANDS_MAX; ++band) {
        made->in_band[band] = false;
        for (size_t i = 0; i < media->n_places; ++i) {
            made->in_band[band] |=
                extinction_per_m[media->places[i].medium].band[band] > 0;
        }
    }
    *out = made;
    return MURK_OK;
}
