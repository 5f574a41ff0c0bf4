/* Text in images: characters of 5 by 8 pixels (the last row is for descenders),
 * enlarged by an integer factor. The characters that legends need are defined;
 * other characters leave a gap. */
#ifndef MURK_RENDER_GLYPHS_H
#define MURK_RENDER_GLYPHS_H

#include "render/png.h"

/* Pixels at scale 1. */
#define MURK_GLYPH_HEIGHT  8
#define MURK_GLYPH_ADVANCE 6 /* from one character to the next */

/* The width of a text in pixels. */
size_t murk_text_width(const char *text, size_t scale);

void murk_text_draw(murk_raster *raster, size_t left, size_t top, size_t scale,
                    const char *text, const uint8_t rgb[3]);

#endif
