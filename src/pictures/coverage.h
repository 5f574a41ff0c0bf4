/* Fills the channels of coverage of a picture: the number of sensors that see
 * the surface in each pixel, and the largest clarity.
 *
 * The point of the first surface in a pixel is treated as a photon of the
 * surface map (sensing/sight.h), in the band placement.targets.band_nm; for
 * sensors whose type does not detect that band, in the first band that the type
 * detects. */
#ifndef MURK_PICTURES_COVERAGE_H
#define MURK_PICTURES_COVERAGE_H

#include "pictures/viewpoint.h"
#include "render/render.h"

/* The memory of the coverage, in addition to that of the picture [bytes]. */
double murk_picture_coverage_bytes(size_t width, size_t height);

/* Adds the coverage by the sensors of the viewpoint. Fails with MURK_NO_MEMORY
 * or MURK_INTERRUPTED. */
murk_status murk_picture_cover(murk_image *picture,
                               const murk_viewpoint *viewpoint,
                               const murk_stage *stage, unsigned threads,
                               murk_error *err);

#endif
