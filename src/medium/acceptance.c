/* Apparent extinction for a finite acceptance angle: replaces the extinction
 * of each medium in a shallow copy of the media. See medium/acceptance.h for
 * the formula. */
#include "medium/acceptance.h"

#include "medium/media_parts.h"

#include <assert.h>

double murk_medium_accepted(const murk_medium *medium, int band,
                            double acceptance_rad)
{
    return murk_phase_share_within(&medium->phase[band], acceptance_rad);
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
    const murk_status status = murk_media_check_acceptance(media, err);
    if (status) {
        return status;
    }
    murk_media *made = murk_media_shallow_copy(media);
    if (!made) {
        return murk_fail(err, MURK_NO_MEMORY, "acceptance_deg",
                         "no memory for %zu media", media->n_media);
    }
    murk_medium *list = made->media;
    for (size_t i = 0; i < media->n_media; ++i) {
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            list[i].extinction_per_m.band[band] *=
                1 - list[i].albedo.band[band] *
                        murk_medium_accepted(&list[i], band, acceptance_rad);
        }
    }
    *out = made;
    return MURK_OK;
}
