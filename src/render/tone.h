/* Radiance to what a screen shows: exposure, a tone curve, sRGB.
 *
 * Linear RGB times 2^stops is compressed by its luminance L, as Reinhard et
 * al. have it: L (1 + L / 16) / (1 + L), so that 4 and more is white; middle
 * grey is 0.18. What is brighter than white keeps its colour as far as that can
 * be shown, negative parts are cut, what is no number is black. The curve does
 * not depend on the picture: at given stops two pictures compare.
 *
 * Source: Reinhard, Stark, Shirley and Ferwerda, ACM Trans. Graph. 21 (2002)
 * 267, doi:10.1145/566654.566575, eqs. 1 and 4; sRGB: IEC 61966-2-1. */
#ifndef MURK_RENDER_TONE_H
#define MURK_RENDER_TONE_H

#include "render/png.h"
#include "render/render.h"

/* Stops that make the log mean of the luminance middle grey, over the pixels
 * that are within 2^12 of the 99th percentile of those with any light. 0 where
 * all is dark. To a hundredth of a stop. Fails with MURK_NO_MEMORY. */
murk_status murk_tone_stops(double *out, const murk_image *picture,
                            murk_error *err);

/* One colour. */
void murk_tone_pixel(const double rgb[3], double stops, uint8_t out[3]);

/* raster->rgb is the caller's to free(). Fails with MURK_NO_MEMORY. */
murk_status murk_tone_raster(murk_raster *out, const murk_image *picture,
                             double stops, murk_error *err);

#endif
