/* Who sees what a picture shows: fills its coverage's channels.
 *
 * Each pixel's first surface is a point that the sensors look at as they look
 * at photons (sensing/sight.h), in the band placement.targets.band_nm or, for
 * those that do not take it, in their own first one. */
#ifndef MURK_APP_PICTURE_COVERAGE_H
#define MURK_APP_PICTURE_COVERAGE_H

#include "app/viewpoint.h"
#include "render/render.h"

/* Memory beside the picture's [bytes]. */
double murk_picture_coverage_bytes(size_t width, size_t height);

/* By the viewpoint's sensors. Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_picture_cover(murk_image *picture,
                               const murk_viewpoint *viewpoint,
                               const murk_stage *stage, unsigned threads,
                               murk_error *err);

#endif
