/* Tone mapping: radiance to 8-bit sRGB, by exposure, a tone curve and the sRGB
 * encoding.
 *
 * Linear RGB times 2^stops is compressed according to the luminance L, as in
 * Reinhard et al.: L (1 + L / 16) / (1 + L), so that luminances from 4 on are
 * white; middle grey is 0.18. Components above 1 and below 0 are cut, and
 * components that are no number count as 0. The curve does not depend on the
 * picture: two pictures with the same stops are comparable.
 *
 * Source: Reinhard, Stark, Shirley and Ferwerda, ACM Trans. Graph. 21 (2002)
 * 267, doi:10.1145/566654.566575, eqs. 1 and 4; sRGB: IEC 61966-2-1. */
#ifndef MURK_RENDER_TONE_H
#define MURK_RENDER_TONE_H

#include "render/png.h"
#include "render/render.h"

/* The exposure in stops for which the mean of log luminance is middle grey. The
 * mean is over the pixels that are at most 12 stops darker than the 99th
 * percentile of all lit pixels. 0 if all pixels are dark. Rounded to a
 * hundredth of a stop. Fails with MURK_NO_MEMORY. */
murk_status murk_tone_stops(double *out, const murk_image *picture,
                            murk_error *err);

/* Maps one colour. */
void murk_tone_pixel(const double rgb[3], double stops, uint8_t out[3]);

/* Maps a picture. The caller frees raster->rgb. Fails with MURK_NO_MEMORY. */
murk_status murk_tone_raster(murk_raster *out, const murk_image *picture,
                             double stops, murk_error *err);

#endif
