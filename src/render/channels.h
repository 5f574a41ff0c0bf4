/* A picture's channels by name, as they stand in OpenEXR files.
 *
 * R, G, B; for each band, by its wavelength (S0 and the comma as in Fichet,
 * Pacanowski and Wilkie, An OpenEXR layout for spectral images, J. Comput.
 * Graph. Tech. 10 (2021) 3), S0.550nm radiance, error.550nm its standard error,
 * surface.550nm and volume.550nm its parts, depth.550nm optical depth; error.R,
 * error.G, error.B; Z distance, P.X, P.Y, P.Z position; coverage.count and
 * coverage.clarity. What each is: render/render.h. */
#ifndef MURK_RENDER_CHANNELS_H
#define MURK_RENDER_CHANNELS_H

#include "render/render.h"

/* Bytes of the longest name, "standard error at 1234.567 nm", and its end; and
 * the channels of a picture: five for each band, nine of colours and positions,
 * the distance and two of the coverage. */
#define MURK_CHANNEL_NAME_SIZE 48
#define MURK_CHANNELS_MAX      (5 * MURK_BANDS_MAX + 12)

typedef enum murk_channel_kind {
    MURK_CHANNEL_RADIANCE, /* and its error and parts */
    MURK_CHANNEL_LENGTH,
    MURK_CHANNEL_DEPTH,
    MURK_CHANNEL_COUNT,
    MURK_CHANNEL_CLARITY
} murk_channel_kind;

typedef struct murk_channel {
    char name[MURK_CHANNEL_NAME_SIZE];
    char title[MURK_CHANNEL_NAME_SIZE]; /* "radiance at 550 nm" */
    const char *unit;                   /* "W/m2/sr"; "" where there is none */
    murk_channel_kind kind;
    const float *value; /* [height * width], the picture's */
} murk_channel;

/* Fills list[MURK_CHANNELS_MAX] and returns how many there are. picture NULL:
 * names alone, of pictures with that many bands, with coverage or without. */
size_t murk_channels_list(const murk_image *picture, int bands,
                          const double *band_nm, bool has_coverage,
                          murk_channel *list);

/* The first band, of bands that rise, whose channels would have the names of
 * the next one's, as wavelengths there have 7 digits; -1: none. */
int murk_channels_clash(int bands, const double *band_nm);

/* The channel that is meant: by its name, by its layer alone where that has one
 * band, "radiance" for S0, and a point for the comma. NULL: none, or several.
 */
const murk_channel *murk_channel_find(const murk_channel *list, size_t n,
                                      const char *wanted);

#endif
