/* Images in 8-bit sRGB, and PNG files. */
#ifndef MURK_RENDER_PNG_H
#define MURK_RENDER_PNG_H

#include "base/status.h"
#include "render/provenance.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_raster {
    size_t width, height;
    uint8_t *rgb; /* [height * width * 3] row by row from the top; from
                   * malloc() */
} murk_raster;

/* Creates a black image. The caller frees raster->rgb. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_raster_create(murk_raster *out, size_t width, size_t height,
                               murk_error *err);

/* Fills the part of a rectangle that lies within the image. */
void murk_raster_fill(murk_raster *raster, size_t left, size_t top,
                      size_t width, size_t height, const uint8_t rgb[3]);

/* Writes a PNG file completely or not at all (base/file.h), with texts as iTXt
 * chunks. Fails with MURK_BAD_VALUE (the run has read a file at this path),
 * MURK_RUN_FAILED (the file cannot be written) or MURK_NO_MEMORY. */
murk_status murk_png_write(const murk_raster *raster,
                           const murk_image_text *text, size_t n_text,
                           const char *path, murk_error *err);

#endif
