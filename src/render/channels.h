/* The channels of a picture by the names that they have in OpenEXR files.
 *
 * R, G, B; for each band, with the wavelength in the name (S0 and the comma as
 * in Fichet, Pacanowski and Wilkie, An OpenEXR layout for spectral images, J.
 * Comput. Graph. Tech. 10 (2021) 3): S0.550nm radiance, error.550nm its
 * standard error, surface.550nm and volume.550nm the parts of it, depth.550nm
 * optical depth; error.R, error.G, error.B; Z distance, P.X, P.Y, P.Z position;
 * coverage.count and coverage.clarity. render/render.h defines the
 * quantities. */
#ifndef MURK_RENDER_CHANNELS_H
#define MURK_RENDER_CHANNELS_H

#include "render/render.h"

/* Bytes of the longest name, "standard error at 1234.567 nm", and its end; and
 * the channels of a picture: five for each band, nine of colours, their errors
 * and positions, the distance and two of the coverage. */
#define MURK_CHANNEL_NAME_SIZE 48
#define MURK_CHANNELS_MAX      (5 * MURK_BANDS_MAX + 12)

typedef enum murk_channel_kind {
    MURK_CHANNEL_RADIANCE, /* radiance, standard error and parts */
    MURK_CHANNEL_LENGTH,
    MURK_CHANNEL_DEPTH,
    MURK_CHANNEL_COUNT,
    MURK_CHANNEL_CLARITY
} murk_channel_kind;

typedef struct murk_channel {
    char name[MURK_CHANNEL_NAME_SIZE];
    char title[MURK_CHANNEL_NAME_SIZE]; /* e.g. "radiance at 550 nm" */
    const char *unit;                   /* e.g. "W/m2/sr"; "" if there is
                                         * none */
    murk_channel_kind kind;
    const float *value; /* [height * width], owned by the picture */
} murk_channel;

/* Fills list[MURK_CHANNELS_MAX] and returns the number of channels. With
 * picture NULL the values are NULL; names, titles, units and kinds are those of
 * pictures with that many bands, with or without coverage. */
size_t murk_channels_list(const murk_image *picture, int bands,
                          const double *band_nm, bool has_coverage,
                          murk_channel *list);

/* Returns the number, from 0, of the first of rising bands whose channels would
 * have the same names as those of the next band, because wavelengths in names
 * have 7 digits; -1 if there is none. */
int murk_channels_clash(int bands, const double *band_nm);

/* Finds a channel by name; by layer if the layer has one band; with "radiance"
 * for S0, and with a point instead of the comma. Returns NULL if there is no
 * such channel or several. */
const murk_channel *murk_channel_find(const murk_channel *list, size_t n,
                                      const char *wanted);

#endif
