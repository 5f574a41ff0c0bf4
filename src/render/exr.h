/* A picture as an OpenEXR file: 32-bit float channels, ZIP-compressed
 * scanlines, what it is of and how it was made in the header.
 *
 * Channels: R, G, B; for each band, by its wavelength (S0 and the comma as in
 * Fichet, Pacanowski and Wilkie, An OpenEXR layout for spectral images, J.
 * Comput. Graph. Tech. 10 (2021) 3), S0.550nm radiance, error.550nm its
 * standard error, surface.550nm and volume.550nm its parts, depth.550nm optical
 * depth; error.R, error.G, error.B; Z distance, P.X, P.Y, P.Z position. What
 * each is: render/render.h. */
#ifndef MURK_RENDER_EXR_H
#define MURK_RENDER_EXR_H

#include "render/render.h"

/* One line of the header. */
typedef struct murk_exr_text {
    const char *name, *text;
} murk_exr_text;

typedef struct murk_exr {
    const murk_picture *picture;
    const double *band_nm; /* [bands], rising */
    const murk_exr_text *header;
    size_t n_header;
} murk_exr;

/* Writes it whole under another name beside `path`, then renames. Fails with
 * MURK_BAD_FILE or MURK_NO_MEMORY. */
murk_status murk_exr_write(const murk_exr *exr, const char *path,
                           murk_error *err);

#endif
