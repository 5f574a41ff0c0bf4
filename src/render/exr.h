/* Writes a picture as an OpenEXR file: 32-bit float channels, ZIP-compressed
 * scanlines, and texts in the header on the scene and the computation.
 *
 * Channels: render/channels.h. Panoramas are marked as envmap latlong. */
#ifndef MURK_RENDER_EXR_H
#define MURK_RENDER_EXR_H

#include "render/provenance.h"
#include "render/render.h"

typedef struct murk_exr {
    const murk_image *picture;
    const double *band_nm; /* [bands] rising */
    bool is_all_round;     /* equirectangular */
    double pixel_aspect;   /* width / height of a pixel */
    const murk_image_text *header;
    size_t n_header;
} murk_exr;

/* Writes the file completely or not at all (base/file.h). Fails with
 * MURK_BAD_VALUE (the run has read a file at this path), MURK_RUN_FAILED (the
 * file cannot be written) or MURK_NO_MEMORY. */
murk_status murk_exr_write(const murk_exr *exr, const char *path,
                           murk_error *err);

#endif
