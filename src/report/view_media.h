/* Media as the view draws them: extinction in the cells of a box. */
#ifndef MURK_REPORT_VIEW_MEDIA_H
#define MURK_REPORT_VIEW_MEDIA_H

#include "base/status.h"
#include "medium/media.h"

typedef struct murk_view_media {
    murk_box box;
    size_t size[3];
    uint8_t *cell; /* [size[0] * size[1] * size[2]], x fastest: 255 *
                      sqrt(extinction / largest extinction of all cells), in
                      the first band at the centre of the cell. The square
                      root keeps haze visible beside smoke that is thousands of
                      times thicker. NULL: no medium */
    double min_per_m, max_per_m;
    bool is_even; /* min_per_m is at least 0.99 max_per_m */
} murk_view_media;

/* Samples the media in at most `max` cells, max >= 1, and at most 64 along each
 * side; cells are about cubes. media NULL: no cells. Fails with MURK_NO_MEMORY.
 * Release *out in any case. */
murk_status murk_view_media_make(murk_view_media *out, const murk_media *media,
                                 const murk_box *box, size_t max,
                                 murk_error *err);
void murk_view_media_release(murk_view_media *media);

#endif
