/* One channel of a picture in false colour, with a legend below it.
 *
 * Colours are viridis (van der Walt, Smith and Firing, matplotlib 1.5, 2015,
 * CC0: https://bids.github.io/colormap): evenly perceived, read alike in grey
 * and by the colour-blind; 33 of its 256 colours and lines between them, within
 * 2 of 255. Values beyond the range take its end's colour; what is no number,
 * or not above 0 where the scale is logarithmic, is grey. */
#ifndef MURK_RENDER_FALSE_COLOUR_H
#define MURK_RENDER_FALSE_COLOUR_H

#include "render/channels.h"
#include "render/png.h"

typedef struct murk_false_colour {
    double low, high; /* low < high; with is_log low > 0 */
    bool is_log;
} murk_false_colour;

/* The scale where the user says none: logarithmic for radiances. */
bool murk_false_colour_is_log(const murk_channel *channel);

/* The range where the user says none. Of radiances, lengths and depths nine
 * hundred and ninety in a thousand of the pixels lie within it; a logarithmic
 * one spans at most 1e6. Counts: 0 to the most; clarity: 0 to 1. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_false_colour_range(murk_false_colour *out,
                                    const murk_channel *channel, size_t n,
                                    bool is_log, murk_error *err);

/* The colour of t in 0..1, and of what is no number. */
void murk_false_colour_at(double t, uint8_t rgb[3]);

/* Bytes that the raster of a picture so wide and high takes at most, with its
 * legend, which is wider than narrow pictures are. */
double murk_false_colour_bytes(size_t width, size_t height);

/* Width and height of the picture that the channel is of. raster->rgb is the
 * caller's to free(). Fails with MURK_NO_MEMORY. */
murk_status murk_false_colour_raster(murk_raster *out,
                                     const murk_channel *channel, size_t width,
                                     size_t height, murk_false_colour colours,
                                     murk_error *err);

#endif
