/* A picture as an OpenEXR file: 32-bit float channels, ZIP-compressed
 * scanlines, what it is of and how it was made in the header.
 *
 * Channels: render/channels.h. A picture all round is marked as envmap
 * latlong. */
#ifndef MURK_RENDER_EXR_H
#define MURK_RENDER_EXR_H

#include "render/provenance.h"
#include "render/render.h"

typedef struct murk_exr {
    const murk_image *picture;
    const double *band_nm; /* [bands], rising */
    bool is_all_round;     /* equirectangular */
    double pixel_aspect;   /* width over height of a pixel */
    const murk_image_text *header;
    size_t n_header;
} murk_exr;

/* Writes it whole under another name beside `path`, then renames. Fails with
 * MURK_BAD_FILE or MURK_NO_MEMORY. */
murk_status murk_exr_write(const murk_exr *exr, const char *path,
                           murk_error *err);

#endif
