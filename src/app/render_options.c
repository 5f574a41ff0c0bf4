/* Options of murk render: size, exposure and range of a picture. */
#include "app/render_options.h"

#include "render/render.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Pixels along a side: the range of the key of a scene. */
#define SIDE_MAX     65536
#define EXPOSURE_MAX 100.0 /* stops: 2^100 is beyond any radiance */

static bool is_side(unsigned long n)
{
    return n >= 1 && n <= SIDE_MAX;
}

/* "640x480" */
murk_status murk_option_pixels(murk_options *out, const char *name,
                               const char *value, murk_error *err)
{
    char *end = NULL, *last = NULL;
    const bool begins = *value >= '0' && *value <= '9';
    const unsigned long width = begins ? strtoul(value, &end, 10) : 0;
    const bool goes_on =
        begins && *end == 'x' && end[1] >= '0' && end[1] <= '9';
    const unsigned long height = goes_on ? strtoul(end + 1, &last, 10) : 0;
    if (!is_side(width) || !is_side(height) || *last ||
        (uint64_t)width * height > MURK_PIXELS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be WIDTHxHEIGHT, such as 640x480: each "
                         "1..%d, %llu pixels together at most",
                         value, SIDE_MAX, (unsigned long long)MURK_PIXELS_MAX);
    }
    out->render.pixels[0] = width;
    out->render.pixels[1] = height;
    return MURK_OK;
}

murk_status murk_option_exposure(murk_options *out, const char *name,
                                 const char *value, murk_error *err)
{
    char *end;
    const double stops = strtod(value, &end);
    if (end == value || *end || !(fabs(stops) <= EXPOSURE_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be a number of stops, %g..%g", value,
                         -EXPOSURE_MAX, EXPOSURE_MAX);
    }
    out->render.has_exposure = true;
    out->render.exposure_stops = stops;
    return MURK_OK;
}

/* "LOW:HIGH" */
murk_status murk_option_range(murk_options *out, const char *name,
                              const char *value, murk_error *err)
{
    char *middle, *end = NULL;
    const double low = strtod(value, &middle);
    const bool goes_on = middle != value && *middle == ':';
    const double high = goes_on ? strtod(middle + 1, &end) : NAN;
    if (!goes_on || end == middle + 1 || *end || !isfinite(low) ||
        !isfinite(high) || !(low < high)) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be LOW:HIGH, two numbers, the first less "
                         "than the second",
                         value);
    }
    out->render.has_range = true;
    out->render.range[0] = low;
    out->render.range[1] = high;
    return MURK_OK;
}

static murk_status needs(const char *option, const char *other, murk_error *err)
{
    return murk_fail(err, MURK_BAD_VALUE, option,
                     "goes with %s, which is not "
                     "given",
                     other);
}

murk_status murk_render_options_check(const murk_options *options,
                                      murk_error *err)
{
    const murk_render_options *r = &options->render;
    if (r->from_sensor > 0 && !options->sensors) {
        return needs("--from-sensor", "--sensors FILE", err);
    }
    if (r->has_exposure && !r->png) {
        return needs("--exposure", "--png", err);
    }
    if (r->has_range && !r->false_colour) {
        return needs("--range", "--false-colour CHANNEL", err);
    }
    if (r->has_scale && !r->false_colour) {
        return needs("--scale", "--false-colour CHANNEL", err);
    }
    if (r->has_range && r->is_log && !(r->range[0] > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, "--range",
                         "%g:%g, must be above 0 with --scale log", r->range[0],
                         r->range[1]);
    }
    return MURK_OK;
}
