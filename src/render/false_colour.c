/* Draws one channel of a picture in the colours of viridis, with a legend:
 * chooses the range by quantiles, maps values to colours, and sets round
 * numbers below the bar. */
#include "render/false_colour.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render/canvas.h"
#include "render/glyphs.h"
#include "render/spread.h"

#define CELLS 32 /* between colours of the table: render/false_colour.h */

/* The largest span of a logarithmic range. */
#define SPAN_MAX 1e6

/* Every eighth of the 256 colours of viridis, and the last one:
 * render/false_colour.h. */
static const uint8_t VIRIDIS[CELLS + 1][3] = {
    {68, 1, 84},    {71, 13, 96},   {72, 24, 106},  {72, 35, 116},
    {71, 45, 123},  {69, 54, 129},  {66, 64, 134},  {63, 73, 137},
    {59, 82, 139},  {55, 90, 141},  {51, 99, 141},  {47, 106, 142},
    {44, 114, 142}, {41, 122, 142}, {38, 129, 142}, {35, 137, 142},
    {33, 144, 140}, {31, 152, 139}, {31, 159, 136}, {33, 166, 133},
    {40, 174, 128}, {49, 181, 123}, {62, 188, 116}, {76, 194, 108},
    {93, 201, 99},  {110, 206, 88}, {130, 211, 76}, {150, 216, 63},
    {171, 220, 50}, {192, 223, 36}, {213, 226, 26}, {234, 229, 26},
    {253, 231, 37}};

/* A middle grey is none of the colours of viridis; the legend is black on
 * white. */
static const uint8_t NOTHING[3] = {128, 128, 128}, PAPER[3] = {255, 255, 255},
                     INK[3] = {0, 0, 0};

/* ---- range ---- */

bool murk_false_colour_is_log(const murk_channel *channel)
{
    return channel->kind == MURK_CHANNEL_RADIANCE;
}

static float max_of(const murk_channel *channel, size_t n)
{
    float max = 0;
    for (size_t i = 0; i < n; ++i) {
        max = fmaxf(max, channel->value[i]); /* fmaxf() ignores NAN */
    }
    return max;
}

/* Limits the span of a logarithmic range, and widens an empty range. */
static void widen(murk_false_colour *c)
{
    if (c->is_log) {
        c->low = fmax(c->low, c->high / SPAN_MAX);
        if (!(c->low < c->high)) {
            c->low /= 2;
            c->high *= 2;
        }
    } else if (!(c->low < c->high)) {
        const double by = c->low != 0 ? fabs(c->low) / 2 : 1;
        c->low -= by;
        c->high += by;
    }
}

murk_status murk_false_colour_range(murk_false_colour *out,
                                    const murk_channel *channel, size_t n,
                                    bool is_log, murk_error *err)
{
    /* Clarities and counts have ranges of their own. */
    *out = (murk_false_colour){is_log ? 0.1 : 0, 1, is_log};
    if (!is_log && channel->kind == MURK_CHANNEL_CLARITY) {
        return MURK_OK;
    }
    if (!is_log && channel->kind == MURK_CHANNEL_COUNT) {
        out->high = fmax(1, (double)max_of(channel, n));
        return MURK_OK;
    }
    /* All other channels: quantiles of the pixels that have a value. */
    float *value = malloc(MURK_SPREAD_MAX * sizeof *value);
    if (!value) {
        return murk_no_memory(err, "render", "for a channel's range");
    }
    const size_t step = murk_spread_step(n);
    size_t values = 0;
    for (size_t i = 0; i < n; i += step) {
        const float v = channel->value[i];
        if (isfinite(v) && (!is_log || v > 0)) {
            value[values++] = v;
        }
    }
    if (values > 0) {
        out->low = (double)murk_spread_share(value, values, 0.005);
        out->high = (double)murk_spread_share(value, values, 0.995);
        widen(out);
    }
    free(value);
    return MURK_OK;
}

/* ---- colours ---- */

void murk_false_colour_at(double t, uint8_t rgb[3])
{
    if (!(t == t)) {
        memcpy(rgb, NOTHING, 3);
        return;
    }
    const double at = CELLS * fmax(0, fmin(1, t));
    const int i = (int)fmin(CELLS - 1, at);
    for (int k = 0; k < 3; ++k) {
        const double a = VIRIDIS[i][k], b = VIRIDIS[i + 1][k];
        rgb[k] = (uint8_t)(a + (at - i) * (b - a) + 0.5);
    }
}

/* The position of a value on the scale: 0 at the low and 1 at the high end of
 * the range; NAN for a value that a logarithmic scale cannot show. */
static double place_of(const murk_false_colour *c, double value)
{
    if (!c->is_log) {
        return (value - c->low) / (c->high - c->low);
    }
    return value > 0 ? log(value / c->low) / log(c->high / c->low) : NAN;
}

/* ---- legend ---- */

#define TICKS_MAX 64 /* many times as many as a bar has room for */

typedef struct ticks {
    double value[TICKS_MAX];
    size_t n;
} ticks;

static void add_tick(ticks *t, const murk_false_colour *c, double value)
{
    const double slack = 1e-9; /* of the bar: what rounding moves a tick by */
    const double at = place_of(c, value);
    if (at >= -slack && at <= 1 + slack && t->n < TICKS_MAX) {
        t->value[t->n++] = value;
    }
}

/* Round numbers within the range, about `wanted` of them. */
static ticks ticks_of(const murk_false_colour *c, bool is_whole, double wanted)
{
    ticks t = {.n = 0};
    const double decades = c->is_log ? log10(c->high / c->low) : 0;
    if (decades >= 1.5) {
        const double step = fmax(1, ceil(decades / wanted));
        const double first = ceil(log10(c->low) - 1e-9);
        for (int k = 0; k < TICKS_MAX; ++k) {
            add_tick(&t, c, pow(10, first + k * step));
        }
        return t;
    }
    double step = murk_canvas_step((c->high - c->low) / wanted);
    step = is_whole ? fmax(1, step) : step;
    const double first = ceil(c->low / step - 1e-9);
    for (int k = 0; k < TICKS_MAX; ++k) {
        const double value = (first + k) * step;
        add_tick(&t, c, fabs(value) < 1e-9 * step ? 0 : value);
    }
    return t;
}

typedef struct legend {
    size_t scale, pad, width; /* width of the whole image */
    size_t top;               /* first row, below the picture */
    char title[96];
} legend;

static size_t legend_height(const legend *l)
{
    return l->scale * (2 * MURK_GLYPH_HEIGHT + 24);
}

static void draw_legend(murk_raster *raster, const legend *l,
                        const murk_channel *channel, const murk_false_colour *c)
{
    /* The title and the bar of colours. */
    const size_t s = l->scale, left = l->pad, across = l->width - 2 * l->pad;
    const size_t bar = l->top + (MURK_GLYPH_HEIGHT + 7) * s;
    murk_raster_fill(raster, 0, l->top, l->width, legend_height(l), PAPER);
    murk_text_draw(raster, left, l->top + 4 * s, s, l->title, INK);
    for (size_t x = 0; x < across; ++x) {
        uint8_t rgb[3];
        murk_false_colour_at(((double)x + 0.5) / (double)across, rgb);
        murk_raster_fill(raster, left + x, bar, 1, 8 * s, rgb);
    }
    /* Ticks, as many as fit with their numbers; a number that would touch the
     * number before it, or that does not fit into the image, is left out. */
    const double fits = (double)across / (double)(7 * MURK_GLYPH_ADVANCE * s);
    const ticks t = ticks_of(c, channel->kind == MURK_CHANNEL_COUNT,
                             fmax(1, fmin(8, fits)));
    size_t free_from = 0;
    for (size_t i = 0; i < t.n; ++i) {
        char text[32];
        snprintf(text, sizeof text, "%.5g", t.value[i]);
        const double at = place_of(c, t.value[i]) * (double)(across - 1);
        const size_t x = left + (size_t)fmax(0, at + 0.5);
        const size_t wide = murk_text_width(text, s);
        const size_t from = x > wide / 2 ? x - wide / 2 : 0;
        const size_t last = l->width > wide ? l->width - wide : 0;
        murk_raster_fill(raster, x, bar + 8 * s, s, 2 * s, INK);
        if (from >= free_from && from <= last + s) {
            murk_text_draw(raster, from < last ? from : last, bar + 11 * s, s,
                           text, INK);
            free_from = from + wide + MURK_GLYPH_ADVANCE * s / 2;
        }
    }
}

static bool any_grey(const murk_channel *channel, size_t n,
                     const murk_false_colour *c)
{
    for (size_t i = 0; i < n; ++i) {
        if (isnan(place_of(c, (double)channel->value[i]))) {
            return true;
        }
    }
    return false;
}

/* Computes the sizes of the legend for a title that is `title` pixels long at
 * scale 1. */
static void measure(legend *l, size_t width, size_t title)
{
    l->scale = width > 600 ? (width + 200) / 400 : 1;
    l->pad = 16 * l->scale;
    const size_t needed = title * l->scale + 2 * l->pad;
    l->width = width > needed ? width : needed;
}

static legend legend_of(const murk_channel *channel, size_t width,
                        size_t height, const murk_false_colour *c)
{
    legend l = {.top = height};
    const size_t n = width * height;
    snprintf(l.title, sizeof l.title, "%s%s%s%s%s", channel->title,
             *channel->unit ? ", " : "", channel->unit,
             c->is_log ? " (log)" : "",
             !any_grey(channel, n, c) ? ""
             : c->is_log              ? " (grey: 0 or none)"
                                      : " (grey: none)");
    measure(&l, width, murk_text_width(l.title, 1));
    return l;
}

double murk_false_colour_bytes(size_t width, size_t height)
{
    legend l = {.top = height};
    measure(&l, width, sizeof l.title * MURK_GLYPH_ADVANCE);
    return 3 * (double)l.width * (double)(height + legend_height(&l));
}

murk_status murk_false_colour_raster(murk_raster *out,
                                     const murk_channel *channel, size_t width,
                                     size_t height, murk_false_colour colours,
                                     murk_error *err)
{
    const legend l = legend_of(channel, width, height, &colours);
    const murk_status status =
        murk_raster_create(out, l.width, height + legend_height(&l), err);
    if (status) {
        return status;
    }
    murk_raster_fill(out, 0, 0, l.width, height, PAPER);
    for (size_t y = 0; y < height; ++y) {
        uint8_t *row = out->rgb + y * l.width * 3;
        for (size_t x = 0; x < width; ++x) {
            const double value = (double)channel->value[y * width + x];
            murk_false_colour_at(place_of(&colours, value), row + 3 * x);
        }
    }
    draw_legend(out, &l, channel, &colours);
    return MURK_OK;
}
