/* Drawings cover pixels by the shares that geometry says, keep to the clip
 * rectangle, and have text of the width that they say. Nothing here is random.
 */
#include "check.h"
#include "render/canvas.h"

#include <stdlib.h>

static const murk_ink BLACK = {{0, 0, 0}, 1};

static murk_canvas *create(size_t width, size_t height)
{
    murk_canvas *canvas = NULL;
    murk_error err = {0};
    CHECK(murk_canvas_create(&canvas, width, height, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return canvas;
}

static int red_at(murk_canvas *canvas, size_t x, size_t y)
{
    const murk_raster *r = murk_canvas_raster(canvas);
    return r->rgb[3 * (y * r->width + x)];
}

/* Ink on the image, in black pixels. */
static double ink_of(murk_canvas *canvas)
{
    const murk_raster *r = murk_canvas_raster(canvas);
    double sum = 0;
    for (size_t i = 0; i < r->width * r->height; ++i) {
        sum += 1 - r->rgb[3 * i] / 255.0;
    }
    return sum;
}

static void test_shares_of_pixels(void)
{
    murk_canvas *c = create(20, 20);
    murk_canvas_fill(c, 2, 3, 4.5, 2, BLACK);
    CHECK(red_at(c, 1, 3) == 255 && red_at(c, 2, 3) == 0);
    CHECK(red_at(c, 5, 4) == 0 && red_at(c, 5, 5) == 255);
    CHECK(abs(red_at(c, 6, 3) - 128) <= 1); /* half of the pixel */
    const murk_ink pale = {{55, 155, 255}, 0.5};
    murk_canvas_fill(c, 10, 10, 2, 2, pale);
    CHECK(red_at(c, 10, 10) == 155);
    murk_canvas_destroy(c);
}

static void test_lines(void)
{
    /* A line of width 3 from 5 to 25 is longer by half its width at each end,
     * so that corners are filled; a dashed line is not. */
    const double from[2] = {5, 10}, to[2] = {25, 10};
    murk_pen pen = {BLACK, 3, {0, 0}};
    murk_canvas *c = create(40, 20);
    murk_canvas_line(c, from, to, &pen);
    CHECK_NEAR(ink_of(c), 3 * 23, 0.1);
    murk_canvas_destroy(c);
    c = create(40, 20);
    pen.dash[0] = 4;
    pen.dash[1] = 6;
    murk_canvas_line(c, from, to, &pen);
    CHECK_NEAR(ink_of(c), 3 * 8, 0.1); /* two dashes */
    CHECK(red_at(c, 6, 10) == 0 && red_at(c, 12, 10) == 255);
    murk_canvas_destroy(c);
    /* Ends far outside cost nothing and move nothing. */
    const double left[2] = {-1e9, 10}, right[2] = {1e9, 10};
    c = create(40, 20);
    pen = (murk_pen){BLACK, 2, {0, 0}};
    murk_canvas_line(c, left, right, &pen);
    CHECK_NEAR(ink_of(c), 2 * 40, 0.1);
    murk_canvas_destroy(c);
}

static void test_circles(void)
{
    const double center[2] = {50, 50};
    const double pi = 3.14159265358979;
    murk_canvas *c = create(100, 100);
    murk_canvas_disc(c, center, 40, BLACK);
    CHECK_NEAR(ink_of(c), pi * 1600, 0.005 * pi * 1600);
    murk_canvas_destroy(c);
    c = create(100, 100);
    const murk_pen pen = {BLACK, 2, {0, 0}};
    murk_canvas_circle(c, center, 40, &pen);
    CHECK_NEAR(ink_of(c), pi * 80 * 2, 0.02 * pi * 160);
    CHECK(red_at(c, 50, 50) == 255 && red_at(c, 89, 50) < 128);
    murk_canvas_destroy(c);
}

static void test_clip(void)
{
    murk_canvas *c = create(30, 30);
    murk_canvas_clip(c, 10, 10, 10, 10);
    murk_canvas_fill(c, -100, -100, 500, 500, BLACK);
    CHECK_NEAR(ink_of(c), 100, 0);
    CHECK(red_at(c, 10, 10) == 0 && red_at(c, 19, 19) == 0);
    CHECK(red_at(c, 9, 10) == 255 && red_at(c, 20, 19) == 255);
    murk_canvas_clip(c, 40, 40, 10, 10); /* outside of the image */
    murk_canvas_fill(c, 0, 0, 30, 30, BLACK);
    CHECK_NEAR(ink_of(c), 100, 0);
    murk_canvas_destroy(c);
}

static void test_text(void)
{
    murk_canvas *c = create(300, 40);
    const double one = murk_canvas_text_width(c, 20, "m");
    CHECK(one > 10 && one < 30);
    CHECK_NEAR(murk_canvas_text_width(c, 20, "mmm"), 3 * one, 1e-9);
    CHECK_NEAR(murk_canvas_text_width(c, 40, "m"), 2 * one, 0.1);
    CHECK_NEAR(murk_canvas_text_width(c, 20, ""), 0, 0);
    CHECK(ink_of(c) == 0);
    /* The text stands on the base line, to the left of its end. */
    murk_canvas_text(c, 200, 30, 20, MURK_TEXT_TO, BLACK, "mxz");
    CHECK(ink_of(c) > 50);
    for (size_t y = 0; y < 40; ++y) {
        CHECK(y < 30 || red_at(c, 190, y) == 255);
        CHECK(red_at(c, 210, y) == 255 && red_at(c, 100, y) == 255);
    }
    /* Bytes that are no characters are drawn as replacements. */
    CHECK(murk_canvas_text_width(c, 20, "\xff\xc3\xa9") > one);
    murk_canvas_destroy(c);
}

int main(void)
{
    test_shares_of_pixels();
    test_lines();
    test_circles();
    test_clip();
    test_text();
    return check_done();
}
