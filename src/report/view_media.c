/* Samples the extinction of media at the middles of the cells of a box. */
#include "report/view_media.h"

#include "medium/interfaces.h"

#include <math.h>
#include <stdlib.h>

#define CELLS_ALONG 64  /* along the longest side, at most */
#define FULL        255 /* the largest number of one byte */

static murk_vec3 cell_middle(const murk_view_media *m, size_t i)
{
    const size_t at[3] = {i % m->size[0], i / m->size[0] % m->size[1],
                          i / (m->size[0] * m->size[1])};
    const murk_vec3 size = murk_sub(m->box.max, m->box.min);
    return murk_add(
        m->box.min,
        murk_vec(size.x * ((double)at[0] + 0.5) / (double)m->size[0],
                 size.y * ((double)at[1] + 0.5) / (double)m->size[1],
                 size.z * ((double)at[2] + 0.5) / (double)m->size[2]));
}

/* Divides the box into about cubic cells, as small as `maximum` cells in all
 * and CELLS_ALONG cells along the longest side allow. Returns the number of
 * cells. */
static size_t divide(murk_view_media *m, size_t maximum)
{
    const murk_vec3 size = murk_sub(m->box.max, m->box.min);
    const double along[3] = {size.x, size.y, size.z};
    const double longest = fmax(fmax(size.x, size.y), size.z);
    size_t n = 0;
    for (int cells = CELLS_ALONG; n == 0 || n > maximum; --cells) {
        n = 1;
        for (int k = 0; k < 3; ++k) {
            const double share = longest > 0 ? along[k] / longest : 0;
            m->size[k] = (size_t)fmax(1, ceil(cells * share));
            n *= m->size[k];
        }
        if (cells == 1) {
            break;
        }
    }
    return n;
}

murk_status murk_view_media_make(murk_view_media *out, const murk_media *media,
                                 const murk_box *box, size_t maximum,
                                 murk_error *err)
{
    *out = (murk_view_media){.box = *box, .min_per_m = INFINITY};
    if (!media || !murk_media_any(media)) {
        return MURK_OK;
    }
    const size_t n = divide(out, maximum);
    double *value = malloc(n * sizeof *value);
    out->cell = malloc(n);
    if (!value || !out->cell) {
        free(value);
        return murk_no_memory(err, "", "for the media");
    }
    /* values first, because bytes are relative to the largest */
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 p = cell_middle(out, i);
        value[i] =
            murk_media_extinction(media, 0, murk_media_inside(media, p), p);
        out->max_per_m = fmax(out->max_per_m, value[i]);
        out->min_per_m = fmin(out->min_per_m, value[i]);
    }
    for (size_t i = 0; i < n; ++i) {
        const double share = out->max_per_m > 0 ? value[i] / out->max_per_m : 0;
        out->cell[i] = (uint8_t)floor(FULL * sqrt(share) + 0.5);
    }
    out->is_even = !(out->min_per_m < 0.99 * out->max_per_m);
    free(value);
    return MURK_OK;
}

void murk_view_media_release(murk_view_media *media)
{
    free(media->cell);
    *media = (murk_view_media){0};
}
