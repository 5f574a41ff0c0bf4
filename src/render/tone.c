/* Exposure, tone curve (Reinhard et al. 2002, doi:10.1145/566654.566575) and
 * sRGB encoding of a picture. */
#include "render/tone.h"

#include <math.h>
#include <stdlib.h>

#include "render/spread.h"

/* Reflectance of middle grey and the luminance that becomes white:
 * render/tone.h. */
#define MIDDLE_GREY 0.18
#define WHITE       4.0

/* Pixels that are darker than the bright ones by more than this number of stops
 * do not enter the exposure. */
#define STOPS_MAX 12

/* Luminance of linear RGB (ITU-R BT.709). */
static double luminance(double r, double g, double b)
{
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

static double luminance_of(const murk_image *p, size_t i)
{
    return luminance((double)p->rgb[0][i], (double)p->rgb[1][i],
                     (double)p->rgb[2][i]);
}

/* The 99th percentile of the luminance of lit pixels; 0 if all pixels are
 * dark. */
static murk_status find_bright(double *out, const murk_image *p,
                               murk_error *err)
{
    const size_t n = p->width * p->height, step = murk_spread_step(n);
    float *lit = malloc(MURK_SPREAD_MAX * sizeof *lit);
    if (!lit) {
        return murk_no_memory(err, "render", "for an exposure");
    }
    size_t values = 0;
    for (size_t i = 0; i < n; i += step) {
        const double l = luminance_of(p, i);
        if (l > 0 && isfinite(l)) {
            lit[values++] = (float)l;
        }
    }
    *out = values > 0 ? (double)murk_spread_share(lit, values, 0.99) : 0;
    free(lit);
    return MURK_OK;
}

murk_status murk_tone_stops(double *out, const murk_image *p, murk_error *err)
{
    double bright = 0;
    const murk_status status = find_bright(&bright, p, err);
    const double min = status ? 0 : ldexp(bright, -STOPS_MAX);
    double sum = 0, counted = 0;
    for (size_t i = 0; min > 0 && i < p->width * p->height; ++i) {
        const double l = luminance_of(p, i);
        if (l >= min && isfinite(l)) {
            sum += log2(l);
            ++counted;
        }
    }
    if (!status) {
        *out = counted > 0
                   ? round(100 * (log2(MIDDLE_GREY) - sum / counted)) / 100
                   : 0;
    }
    return status;
}

static uint8_t encoded(double linear)
{
    const double c = linear <= 0.0031308 ? 12.92 * linear
                                         : 1.055 * pow(linear, 1 / 2.4) - 0.055;
    return (uint8_t)(255 * fmin(1, c) + 0.5);
}

void murk_tone_pixel(const double rgb[3], double stops, uint8_t out[3])
{
    double c[3];
    for (int k = 0; k < 3; ++k) {
        /* fmax() ignores an argument that is no number */
        c[k] = fmin(1e30, exp2(stops) * fmax(0, rgb[k]));
    }
    const double l = luminance(c[0], c[1], c[2]);
    const double scale = (1 + l / (WHITE * WHITE)) / (1 + l);
    for (int k = 0; k < 3; ++k) {
        out[k] = encoded(scale * c[k]);
    }
}

murk_status murk_tone_raster(murk_raster *out, const murk_image *p,
                             double stops, murk_error *err)
{
    const murk_status status =
        murk_raster_create(out, p->width, p->height, err);
    for (size_t i = 0; !status && i < p->width * p->height; ++i) {
        const double rgb[3] = {(double)p->rgb[0][i], (double)p->rgb[1][i],
                               (double)p->rgb[2][i]};
        murk_tone_pixel(rgb, stops, out->rgb + 3 * i);
    }
    return status;
}
