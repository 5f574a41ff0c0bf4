/* Drawings by FreeType: its smooth rasterizer fills the outlines of letters,
 * and all other shapes as outlines, too. A line is a rectangle as wide as the
 * pen; a circle is a polygon. The rasterizer hands over spans of pixels with
 * their coverage, which are blended into the image. */
#include "render/canvas.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "base/utf8.h"
#include "base/vector.h"

/* FreeType measures in 64ths of a pixel. */
#define UNITS 64.0

/* The largest coordinate [pixels]: coordinates beyond it are set to it, because
 * the numbers of the rasterizer end at 2^15 pixels. */
#define REACH 16384.0

/* A circle is drawn as a polygon whose sides are off by at most 1/20 pixel: the
 * sagitta r (1 - cos(pi / n)) is about r pi^2 / (2 n^2). Circles with radii
 * above 166 pixels have MURK_CANVAS_CORNERS_MAX sides, which are off by
 * more. */
#define SAGITTA 0.05

struct murk_canvas {
    murk_raster raster;
    FT_Library library;
    FT_Face face;
    double clip[4]; /* left, top, right, bottom */
    murk_ink ink;   /* of the shape that is drawn */
};

/* ---- the image ---- */

murk_status murk_canvas_create(murk_canvas **out, size_t width, size_t height,
                               murk_error *err)
{
    murk_canvas *c = calloc(1, sizeof *c);
    murk_status status = MURK_OK;
    if (!c || FT_Init_FreeType(&c->library)) {
        status = murk_no_memory(err, "picture", "for a drawing");
    }
    if (!status && FT_New_Face(c->library, MURK_FONT, 0, &c->face)) {
        status = murk_fail(err, MURK_RUN_FAILED, MURK_FONT,
                           "the font cannot be read, which pictures with text "
                           "need: install the package fonts-dejavu-core");
    }
    if (!status) {
        status = murk_raster_create(&c->raster, width, height, err);
    }
    if (status) {
        murk_canvas_destroy(c);
        return status;
    }
    memset(c->raster.rgb, 255, width * height * 3);
    murk_canvas_clip_nothing(c);
    *out = c;
    return MURK_OK;
}

void murk_canvas_destroy(murk_canvas *c)
{
    if (c) {
        if (c->face) {
            FT_Done_Face(c->face);
        }
        if (c->library) {
            FT_Done_FreeType(c->library);
        }
        free(c->raster.rgb);
        free(c);
    }
}

murk_raster *murk_canvas_raster(murk_canvas *c)
{
    return &c->raster;
}

void murk_canvas_clip(murk_canvas *c, double left, double top, double width,
                      double height)
{
    c->clip[0] = fmax(0, left);
    c->clip[1] = fmax(0, top);
    c->clip[2] = fmin((double)c->raster.width, left + width);
    c->clip[3] = fmin((double)c->raster.height, top + height);
}

void murk_canvas_clip_nothing(murk_canvas *c)
{
    murk_canvas_clip(c, 0, 0, (double)c->raster.width,
                     (double)c->raster.height);
}

/* ---- filling outlines ---- */

static void blend(int y, int count, const FT_Span *spans, void *user)
{
    const murk_canvas *c = user;
    for (int i = 0; i < count; ++i) {
        const double share = c->ink.opacity * spans[i].coverage / 255;
        uint8_t *pixel = c->raster.rgb +
                         3 * ((size_t)y * c->raster.width + (size_t)spans[i].x);
        for (size_t k = 0; k < 3 * (size_t)spans[i].len; ++k) {
            const double there = pixel[k], ink = c->ink.rgb[k % 3];
            pixel[k] = (uint8_t)(there + share * (ink - there) + 0.5);
        }
    }
}

/* Fills an outline in units of FreeType, with y down. */
static void fill_outline(murk_canvas *c, FT_Outline *outline, murk_ink ink)
{
    FT_Raster_Params params = {
        .flags =
            FT_RASTER_FLAG_AA | FT_RASTER_FLAG_DIRECT | FT_RASTER_FLAG_CLIP,
        .gray_spans = blend,
        .user = c,
        .clip_box = {
            (FT_Pos)floor(c->clip[0] + 0.5), (FT_Pos)floor(c->clip[1] + 0.5),
            (FT_Pos)floor(c->clip[2] + 0.5), (FT_Pos)floor(c->clip[3] + 0.5)}};
    const bool is_empty = params.clip_box.xMin >= params.clip_box.xMax ||
                          params.clip_box.yMin >= params.clip_box.yMax;
    c->ink = ink;
    if (!is_empty) {
        FT_Outline_Render(c->library, outline, &params);
    }
}

static FT_Pos units(double pixels)
{
    return (FT_Pos)floor(fmin(fmax(pixels, -REACH), REACH) * UNITS + 0.5);
}

/* Fills what lies in one of two polygons and not in both; `inner` corners of
 * the second polygon follow the `outer` ones of the first. */
static void fill_between(murk_canvas *c, const double (*corner)[2],
                         size_t outer, size_t inner, murk_ink ink)
{
    FT_Vector point[2 * MURK_CANVAS_CORNERS_MAX];
    char tag[2 * MURK_CANVAS_CORNERS_MAX];
    for (size_t i = 0; i < outer + inner; ++i) {
        point[i] = (FT_Vector){units(corner[i][0]), units(corner[i][1])};
        tag[i] = FT_CURVE_TAG_ON;
    }
    short end[2] = {(short)(outer - 1), (short)(outer + inner - 1)};
    FT_Outline outline = {.n_contours = inner > 0 ? 2 : 1,
                          .n_points = (short)(outer + inner),
                          .points = point,
                          .tags = tag,
                          .contours = end,
                          .flags = FT_OUTLINE_EVEN_ODD_FILL};
    fill_outline(c, &outline, ink);
}

void murk_canvas_polygon(murk_canvas *c, const double (*corner)[2], size_t n,
                         murk_ink ink)
{
    fill_between(c, corner, n, 0, ink);
}

void murk_canvas_fill(murk_canvas *c, double left, double top, double width,
                      double height, murk_ink ink)
{
    const double right = left + width, bottom = top + height;
    const double corner[4][2] = {
        {left, top}, {right, top}, {right, bottom}, {left, bottom}};
    murk_canvas_polygon(c, corner, 4, ink);
}

/* ---- lines ---- */

/* Cuts the part [*t0, *t1] of the line from + t (to - from) to what lies within
 * the clip rectangle and `margin` pixels around it. */
static bool clip_line(const murk_canvas *c, const double from[2],
                      const double to[2], double margin, double *t0, double *t1)
{
    const murk_box box = {{c->clip[0] - margin, c->clip[1] - margin, -1},
                          {c->clip[2] + margin, c->clip[3] + margin, 1}};
    return murk_box_clip(&box, murk_vec(from[0], from[1], 0),
                         murk_vec(to[0] - from[0], to[1] - from[1], 0), t0, t1);
}

/* Draws a straight piece of a line as a rectangle that extends `beyond` pixels
 * past either end. With half of the width, two lines meet in a full corner. */
static void draw_piece(murk_canvas *c, const double from[2], const double to[2],
                       const murk_pen *pen, double beyond)
{
    const double dx = to[0] - from[0], dy = to[1] - from[1];
    const double length = hypot(dx, dy), half = pen->width / 2;
    const double ux = length > 0 ? dx / length : 1;
    const double uy = length > 0 ? dy / length : 0;
    const double ax = from[0] - beyond * ux, ay = from[1] - beyond * uy;
    const double bx = to[0] + beyond * ux, by = to[1] + beyond * uy;
    const double corner[4][2] = {{ax - half * uy, ay + half * ux},
                                 {bx - half * uy, by + half * ux},
                                 {bx + half * uy, by - half * ux},
                                 {ax + half * uy, ay - half * ux}};
    murk_canvas_polygon(c, corner, 4, pen->ink);
}

void murk_canvas_line(murk_canvas *c, const double from[2], const double to[2],
                      const murk_pen *pen)
{
    double t0 = 0, t1 = 1;
    const double half = pen->width / 2;
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    if (!isfinite(length) || !clip_line(c, from, to, half, &t0, &t1)) {
        return;
    }
    /* The dashes, counted from the beginning of the whole line. */
    const bool is_dashed = pen->dash[0] > 0 && length > 0;
    const double period =
        is_dashed ? (pen->dash[0] + pen->dash[1]) / length : 2;
    const double dash = is_dashed ? pen->dash[0] / length : 2;
    for (double k = floor(t0 / period); k * period <= t1; ++k) {
        const double a = fmax(t0, k * period);
        const double b = fmin(t1, k * period + dash);
        const double start[2] = {from[0] + a * (to[0] - from[0]),
                                 from[1] + a * (to[1] - from[1])};
        const double end[2] = {from[0] + b * (to[0] - from[0]),
                               from[1] + b * (to[1] - from[1])};
        if (b >= a) {
            draw_piece(c, start, end, pen, is_dashed ? 0 : half);
        }
    }
}

void murk_canvas_rectangle(murk_canvas *c, double left, double top,
                           double width, double height, const murk_pen *pen)
{
    const double right = left + width, bottom = top + height;
    const double corner[4][2] = {
        {left, top}, {right, top}, {right, bottom}, {left, bottom}};
    for (size_t i = 0; i < 4; ++i) {
        murk_canvas_line(c, corner[i], corner[(i + 1) % 4], pen);
    }
}

/* ---- circles ---- */

static size_t sides_of(double radius)
{
    const double sides = ceil(MURK_PI * sqrt(radius / (2 * SAGITTA)));
    return (size_t)fmin(fmax(sides, 12), MURK_CANVAS_CORNERS_MAX);
}

static void on_circle(const double center[2], double radius, size_t i,
                      size_t sides, double out[2])
{
    const double angle = 2 * MURK_PI * (double)i / (double)sides;
    out[0] = center[0] + radius * cos(angle);
    out[1] = center[1] + radius * sin(angle);
}

void murk_canvas_circle(murk_canvas *c, const double center[2], double radius,
                        const murk_pen *pen)
{
    const size_t sides = sides_of(radius);
    const double half = pen->width / 2;
    const bool is_whole = !(pen->dash[0] > 0) && radius < REACH / 2;
    double corner[2 * MURK_CANVAS_CORNERS_MAX][2];
    if (is_whole) {
        for (size_t i = 0; i < sides; ++i) {
            on_circle(center, radius + half, i, sides, corner[i]);
            on_circle(center, fmax(0, radius - half), i, sides,
                      corner[sides + i]);
        }
        fill_between(c, (const double(*)[2])corner, sides, sides, pen->ink);
        return;
    }
    /* Every other side of a dashed circle; all sides of a large one. */
    const size_t step = pen->dash[0] > 0 ? 2 : 1;
    for (size_t i = 0; i < sides; i += step) {
        double t0 = 0, t1 = 1;
        on_circle(center, radius, i, sides, corner[0]);
        on_circle(center, radius, i + 1, sides, corner[1]);
        if (clip_line(c, corner[0], corner[1], pen->width, &t0, &t1)) {
            draw_piece(c, corner[0], corner[1], pen, 0);
        }
    }
}

void murk_canvas_disc(murk_canvas *c, const double center[2], double radius,
                      murk_ink ink)
{
    double corner[MURK_CANVAS_CORNERS_MAX][2];
    const size_t sides = sides_of(radius);
    for (size_t i = 0; i < sides; ++i) {
        on_circle(center, radius, i, sides, corner[i]);
    }
    murk_canvas_polygon(c, (const double(*)[2])corner, sides, ink);
}

/* ---- text ---- */

/* Decodes the character at *text and moves *text behind it; a byte that is not
 * part of a character counts as U+FFFD, the replacement character. */
static FT_ULong next_character(const char **text)
{
    const size_t length = murk_utf8_length(*text);
    const unsigned char *byte = (const unsigned char *)*text;
    FT_ULong code = length == 1   ? byte[0]
                    : length == 0 ? 0xFFFD
                                  : byte[0] & (0x7Fu >> length);
    for (size_t i = 1; i < length; ++i) {
        code = code << 6 | (byte[i] & 0x3Fu);
    }
    *text += length > 0 ? length : 1;
    return code;
}

/* Walks along the text and returns how wide the text is [pixels]. Draws the
 * letters if `ink` is not NULL. */
static double walk_text(murk_canvas *c, double x, double y, double size,
                        const char *text, const murk_ink *ink)
{
    const double begin = x;
    FT_Set_Char_Size(c->face, 0, (FT_F26Dot6)floor(size * UNITS + 0.5), 72, 72);
    while (*text) {
        const FT_ULong code = next_character(&text);
        if (FT_Load_Char(c->face, code,
                         FT_LOAD_NO_BITMAP | FT_LOAD_NO_HINTING)) {
            continue;
        }
        const FT_GlyphSlot slot = c->face->glyph;
        const bool is_near = fabs(x) < REACH && fabs(y) < REACH;
        if (ink && is_near && slot->outline.n_points > 0) {
            const FT_Matrix upside_down = {0x10000, 0, 0, -0x10000};
            FT_Outline_Transform(&slot->outline, &upside_down);
            FT_Outline_Translate(&slot->outline, units(x), units(y));
            fill_outline(c, &slot->outline, *ink);
        }
        x += (double)slot->linearHoriAdvance / 65536; /* 16.16 pixels */
    }
    return x - begin;
}

double murk_canvas_text_width(murk_canvas *c, double size, const char *text)
{
    return walk_text(c, 0, 0, size, text, NULL);
}

void murk_canvas_text(murk_canvas *c, double x, double y, double size,
                      murk_text_anchor anchor, murk_ink ink, const char *text)
{
    const double width = murk_canvas_text_width(c, size, text);
    const double share = anchor == MURK_TEXT_FROM     ? 0
                         : anchor == MURK_TEXT_MIDDLE ? 0.5
                                                      : 1;
    walk_text(c, x - share * width, y, size, text, &ink);
}

double murk_canvas_step(double min)
{
    const double power = pow(10, floor(log10(min)));
    const double m = min / power;
    return power * (m <= 1 ? 1 : m <= 2 ? 2 : m <= 5 ? 5 : 10);
}
