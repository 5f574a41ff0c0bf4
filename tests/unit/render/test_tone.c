/* What a screen shows of radiance, and false colours: by the published curves,
 * and whatever the numbers are. Nothing here is random. */
#include "check.h"
#include "render/false_colour.h"
#include "render/tone.h"

#include <stdlib.h>
#include <string.h>

#define WIDTH  40
#define HEIGHT 25
#define PIXELS (WIDTH * HEIGHT)

static float red[PIXELS], green[PIXELS], blue[PIXELS];

static murk_image picture_of(float value)
{
    for (size_t i = 0; i < PIXELS; ++i) {
        red[i] = green[i] = blue[i] = value;
    }
    return (murk_image){
        .width = WIDTH, .height = HEIGHT, .rgb = {red, green, blue}};
}

static double stops_of(const murk_image *p)
{
    double stops = NAN;
    murk_error err = {0};
    CHECK(murk_tone_stops(&stops, p, &err) == MURK_OK);
    return stops;
}

static int grey_at(double value, double stops)
{
    const double rgb[3] = {value, value, value};
    uint8_t out[3];
    murk_tone_pixel(rgb, stops, out);
    CHECK(out[0] == out[1] && out[1] == out[2]);
    return out[0];
}

/* Reinhard et al., eq. 4, with white at 4; IEC 61966-2-1. */
static void test_the_curve(void)
{
    CHECK(grey_at(0, 0) == 0);
    CHECK(grey_at(4, 0) == 255 && grey_at(1, 2) == 255 && grey_at(9, 0) == 255);
    /* 0.18 (1 + 0.18 / 16) / 1.18 = 0.15426, encoded 0.42920 */
    CHECK(grey_at(0.18, 0) == 109);
    /* a stop is a factor of two */
    CHECK(grey_at(0.09, 1) == 109 && grey_at(0.72, -2) == 109);
    CHECK(grey_at(0.0025, 0) == 8); /* the linear part: 0.0024938 * 12.92 */
}

/* A primary alone: what it is dimmed by follows from its own share of the
 * luminance, .2126, .7152 and .0722 (ITU-R BT.709). */
static void test_primaries_have_their_luminance(void)
{
    static const int want[3] = {236, 205, 248};
    for (int k = 0; k < 3; ++k) {
        double rgb[3] = {0, 0, 0};
        rgb[k] = 1;
        uint8_t out[3];
        murk_tone_pixel(rgb, 0, out);
        CHECK(out[k] == want[k] && out[(k + 1) % 3] == 0);
    }
}

static void test_odd_colours(void)
{
    const double odd[5][3] = {{NAN, 1, 1},
                              {INFINITY, 0, 0},
                              {-1, 0.2, -INFINITY},
                              {1e300, 1e300, 1e300},
                              {0, 0, 0}};
    for (int i = 0; i < 5; ++i) {
        for (double stops = -100; stops <= 100; stops += 50) {
            uint8_t out[3] = {1, 1, 1};
            murk_tone_pixel(odd[i], stops, out);
            CHECK(i != 2 || (out[0] == 0 && out[2] == 0));
            CHECK(i != 4 || out[1] == 0);
        }
    }
}

static void test_exposure_makes_the_log_mean_grey(void)
{
    murk_image p = picture_of(0.36F);
    CHECK_NEAR(stops_of(&p), -1, 1e-12);
    for (size_t i = 0; i < PIXELS / 2; ++i) {
        red[i] = green[i] = blue[i] = 1.44F; /* two stops more in one half */
    }
    CHECK_NEAR(stops_of(&p), -2, 1e-12);
    /* what is no number, dark, or far too dark to matter changes nothing */
    red[0] = NAN;
    green[PIXELS - 1] = INFINITY;
    red[1] = green[1] = blue[1] = 0;
    red[PIXELS - 2] = green[PIXELS - 2] = blue[PIXELS - 2] = 1e-6F;
    CHECK_NEAR(stops_of(&p), -2, 1e-12);
    p = picture_of(0);
    CHECK(stops_of(&p) == 0);
    p = picture_of(NAN);
    CHECK(stops_of(&p) == 0);
    p = picture_of(-1);
    CHECK(stops_of(&p) == 0);
}

/* ---- false colours ---- */

static murk_false_colour range_of(const float *value, murk_channel_kind kind,
                                  bool is_log)
{
    const murk_channel channel = {.kind = kind, .value = value, .unit = ""};
    murk_false_colour out = {0};
    murk_error err = {0};
    CHECK(murk_false_colour_range(&out, &channel, PIXELS, is_log, &err) ==
          MURK_OK);
    CHECK(out.low < out.high && isfinite(out.low) && isfinite(out.high));
    CHECK(!is_log || out.low > 0);
    return out;
}

static void test_ranges(void)
{
    for (size_t i = 0; i < PIXELS; ++i) {
        red[i] = (float)i;
    }
    red[7] = NAN;
    red[8] = INFINITY;
    const murk_false_colour z = range_of(red, MURK_CHANNEL_LENGTH, false);
    CHECK_NEAR(z.low, 5, 1);
    CHECK_NEAR(z.high, 994, 1);
    red[8] = 3;
    const murk_false_colour count = range_of(red, MURK_CHANNEL_COUNT, false);
    CHECK(count.low == 0 && count.high == PIXELS - 1);
    const murk_false_colour log = range_of(red, MURK_CHANNEL_RADIANCE, true);
    CHECK_NEAR(log.low, 6, 1);
    const float alike[4] = {0, -2, 3e38F, NAN};
    for (int i = 0; i < 4; ++i) {
        for (int is_log = 0; is_log < 2; ++is_log) {
            picture_of(alike[i]);
            range_of(red, MURK_CHANNEL_RADIANCE, is_log);
            range_of(red, MURK_CHANNEL_COUNT, is_log);
            range_of(red, MURK_CHANNEL_CLARITY, is_log);
        }
    }
}

static void test_colours(void)
{
    uint8_t rgb[3];
    murk_false_colour_at(0, rgb);
    CHECK(rgb[0] == 68 && rgb[1] == 1 && rgb[2] == 84);
    murk_false_colour_at(INFINITY, rgb);
    CHECK(rgb[0] == 253 && rgb[1] == 231 && rgb[2] == 37);
    murk_false_colour_at(NAN, rgb);
    CHECK(rgb[0] == 128 && rgb[1] == 128 && rgb[2] == 128);
    /* colour 51 of viridis' 256, which is none of the 33: 0.2539, 0.2653,
     * 0.5300 */
    murk_false_colour_at(51 / 255.0, rgb);
    CHECK(abs(rgb[0] - 65) <= 2 && abs(rgb[1] - 68) <= 2 &&
          abs(rgb[2] - 135) <= 2);
}

/* Pictures from a pixel to a wide row get a legend that holds all of its
 * title. */
static void test_any_size_has_a_legend(void)
{
    static const size_t sizes[4][2] = {{1, 1}, {PIXELS, 1}, {3, 7}, {40, 25}};
    const murk_false_colour all[3] = {
        {0, 3, false}, {1e-300, 1e300, true}, {-1e308, 1e308, false}};
    picture_of(2);
    const murk_channel channel = {
        .title = "standard error of green", .unit = "W/m2/sr", .value = red};
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 3; ++k) {
            murk_raster raster = {0};
            murk_error err = {0};
            CHECK(murk_false_colour_raster(&raster, &channel, sizes[i][0],
                                           sizes[i][1], all[k],
                                           &err) == MURK_OK);
            CHECK(raster.width >= 180 && raster.height >= sizes[i][1] + 30);
            free(raster.rgb);
        }
    }
}

/* The legend is wider than a narrow picture, and its letters grow with it. */
static void test_memory_of_legends(void)
{
    static const size_t size[][2] = {{1, 1},   {1, 3000}, {640, 480},
                                     {601, 9}, {3000, 2}, {599, 40}};
    for (size_t i = 0; i < sizeof size / sizeof *size; ++i) {
        const size_t width = size[i][0], height = size[i][1];
        float *value = calloc(width * height, sizeof *value);
        /* as long as titles are, and grey is told of */
        const murk_channel channel = {
            .title = "standard error of radiance at 380.1235 nm",
            .unit = "W/m2/sr",
            .kind = MURK_CHANNEL_RADIANCE,
            .value = value};
        const murk_false_colour colours = {1, 10, true};
        murk_raster raster = {0};
        murk_error err = {0};
        CHECK(!murk_false_colour_raster(&raster, &channel, width, height,
                                        colours, &err));
        const double bytes = murk_false_colour_bytes(width, height);
        const double taken = 3 * (double)raster.width * (double)raster.height;
        CHECK(bytes >= taken && bytes <= 2 * taken);
        CHECK(bytes > 3 * (double)(width * height));
        free(raster.rgb);
        free(value);
    }
}

int main(void)
{
    test_memory_of_legends();
    test_the_curve();
    test_primaries_have_their_luminance();
    test_odd_colours();
    test_exposure_makes_the_log_mean_grey();
    test_ranges();
    test_colours();
    test_any_size_has_a_legend();
    return check_done();
}
