/* Shallow copies of media with other extinctions (medium/rescaled.h). */
#include "medium/rescaled.h"

#include "medium/media_parts.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* A copy with a list of media of its own; places and boundaries are borrowed.
 */
static murk_status copy_media(murk_media **out, const murk_media *media,
                              const char *where, murk_error *err)
{
    murk_media *made = malloc(sizeof *made);
    murk_medium *list = malloc((media->n_media + 1) * sizeof *list);
    if (!made || !list) {
        free(made);
        free(list);
        return murk_no_memory(err, where, "for %zu media", media->n_media);
    }
    *made = *media;
    made->borrows_places = true;
    made->media = list;
    memcpy(list, media->media, media->n_media * sizeof *list);
    *out = made;
    return MURK_OK;
}

/* Notes the bands in which the medium of some region now has an extinction. */
static void note_bands(murk_media *media)
{
    for (int band = 0; band < MURK_BANDS_MAX; ++band) {
        media->in_band[band] = false;
        for (size_t i = 0; i < media->n_places; ++i) {
            const murk_medium *medium = &media->media[media->places[i].medium];
            media->in_band[band] |= medium->extinction_per_m.band[band] > 0;
        }
    }
}

murk_status murk_media_rescale(murk_media **out, const murk_media *media,
                               const murk_spectrum *extinction_per_m,
                               murk_error *err)
{
    const murk_status status = copy_media(out, media, "media", err);
    for (size_t i = 0; !status && i < media->n_media; ++i) {
        (*out)->media[i].extinction_per_m = extinction_per_m[i];
    }
    if (!status) {
        note_bands(*out);
    }
    return status;
}

murk_status murk_media_single(murk_media **out, const murk_media *media,
                              size_t medium, murk_error *err)
{
    assert(medium < media->n_media && media->n_media <= MURK_MEDIA_MAX);
    murk_spectrum extinction_per_m[MURK_MEDIA_MAX];
    for (size_t i = 0; i < media->n_media; ++i) {
        extinction_per_m[i] = murk_spectrum_flat(i == medium, MURK_BANDS_MAX);
    }
    return murk_media_rescale(out, media, extinction_per_m, err);
}

murk_status murk_media_check_acceptance(const murk_media *media,
                                        murk_error *err)
{
    for (size_t i = 0; i < media->n_places; ++i) {
        const murk_medium *medium = &media->media[media->places[i].medium];
        if (medium->albedo_grid) {
            return murk_fail(err, MURK_BAD_VALUE,
                             medium->where ? medium->where : "medium",
                             "its albedo is a grid: a sensor with "
                             "acceptance_deg needs one number a band");
        }
    }
    return MURK_OK;
}

murk_status murk_media_accepting(murk_media **out, const murk_media *media,
                                 double acceptance_rad, murk_error *err)
{
    assert(acceptance_rad >= 0);
    murk_status status = murk_media_check_acceptance(media, err);
    if (!status) {
        status = copy_media(out, media, "acceptance_deg", err);
    }
    for (size_t i = 0; !status && i < media->n_media; ++i) {
        murk_medium *medium = &(*out)->media[i];
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            medium->extinction_per_m.band[band] *=
                1 - medium->albedo.band[band] *
                        murk_phase_share_within(&medium->phase[band],
                                                acceptance_rad);
        }
    }
    return status;
}
