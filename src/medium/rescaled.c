#include "medium/rescaled.h"

#include "medium/parts.h"

#include <stdlib.h>

murk_status murk_media_rescale(murk_media **out, const murk_media *media,
                               const murk_spectrum *extinction_per_m,
                               murk_error *err)
{
    murk_media *made = malloc(sizeof *made);
    murk_medium *list = malloc((media->n_media + 1) * sizeof *list);
    if (!made || !list) {
        free(made);
        free(list);
        return murk_fail(err, MURK_NO_MEMORY, "media",
                         "no memory for %zu media", media->n_media);
    }
    *made = *media;
    made->borrows_places = true;
    made->media = list;
    for (size_t i = 0; i < media->n_media; ++i) {
        list[i] = media->media[i];
        list[i].extinction_per_m = extinction_per_m[i];
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
