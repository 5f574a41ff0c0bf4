/* Draws one channel of a picture in false colour, with a legend below.
 *
 * Colours are viridis (van der Walt, Smith and Firing, matplotlib 1.5, 2015,
 * CC0: https://bids.github.io/colormap), which is perceptually uniform and
 * readable in grey and by colour-blind people; 33 of the 256 colours are stored
 * and interpolated linearly, within 2 of 255. Values beyond the range have the
 * colour of the end of the range. Values that are no number, or not above 0 on
 * a logarithmic scale, are grey. */
#ifndef MURK_RENDER_FALSE_COLOUR_H
#define MURK_RENDER_FALSE_COLOUR_H

#include "render/channels.h"
#include "render/png.h"

typedef struct murk_false_colour {
    double low, high; /* low < high; with is_log low > 0 */
    bool is_log;
} murk_false_colour;

/* The default scale: logarithmic for radiances. */
bool murk_false_colour_is_log(const murk_channel *channel);

/* The default range. On a linear scale, counts have the range 0 to the maximum
 * (at least 1), and clarities 0 to 1. Every other range contains the middle 99
 * % of the values that can be shown (in a large picture, of a sample:
 * render/spread.h); a logarithmic range spans at most a factor of 1e6. Without
 * such values the range is 0..1, or 0.1..1 if logarithmic. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_false_colour_range(murk_false_colour *out,
                                    const murk_channel *channel, size_t n,
                                    bool is_log, murk_error *err);

/* The colour of t in 0..1; grey if t is no number. */
void murk_false_colour_at(double t, uint8_t rgb[3]);

/* The largest number of bytes of the raster of a picture of that size with a
 * legend. The legend is wider than a narrow picture. */
double murk_false_colour_bytes(size_t width, size_t height);

/* Draws the channel of a picture of that width and height. The caller frees
 * raster->rgb. Fails with MURK_NO_MEMORY. */
murk_status murk_false_colour_raster(murk_raster *out,
                                     const murk_channel *channel, size_t width,
                                     size_t height, murk_false_colour colours,
                                     murk_error *err);

#endif
