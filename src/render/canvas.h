/* Drawings: lines, circles, filled polygons and text, with smooth edges, in an
 * 8-bit image.
 *
 * Places are in pixels from the upper left corner, x to the right and y down,
 * so that the center of the first pixel is (0.5, 0.5). Nothing is drawn outside
 * of the clip rectangle. */
#ifndef MURK_RENDER_CANVAS_H
#define MURK_RENDER_CANVAS_H

#include "render/png.h"

typedef struct murk_canvas murk_canvas;

typedef struct murk_ink {
    uint8_t rgb[3];
    double opacity; /* 0..1 */
} murk_ink;

typedef struct murk_pen {
    murk_ink ink;
    double width;   /* pixels */
    double dash[2]; /* lengths of dashes and gaps in pixels; 0: a whole line.
                       The dashes of a circle are every other side of a polygon
                       instead */
} murk_pen;

/* The place of a text relative to the given point: the point is at the left
 * end, in the middle or at the right end of the base line. */
typedef enum murk_text_anchor {
    MURK_TEXT_FROM,
    MURK_TEXT_MIDDLE,
    MURK_TEXT_TO
} murk_text_anchor;

/* Creates a white image. The caller destroys *out. Fails with MURK_NO_MEMORY,
 * or with MURK_RUN_FAILED if the font is not installed. */
murk_status murk_canvas_create(murk_canvas **out, size_t width, size_t height,
                               murk_error *err);
void murk_canvas_destroy(murk_canvas *canvas); /* NULL is fine */

/* The image, which belongs to the canvas. */
murk_raster *murk_canvas_raster(murk_canvas *canvas);

/* Sets the clip rectangle, which begins as all of the image. */
void murk_canvas_clip(murk_canvas *canvas, double left, double top,
                      double width, double height);
void murk_canvas_clip_nothing(murk_canvas *canvas);

void murk_canvas_line(murk_canvas *canvas, const double from[2],
                      const double to[2], const murk_pen *pen);
void murk_canvas_circle(murk_canvas *canvas, const double center[2],
                        double radius, const murk_pen *pen);
void murk_canvas_rectangle(murk_canvas *canvas, double left, double top,
                           double width, double height, const murk_pen *pen);

/* Fills a disc, a rectangle, or a polygon of n <= MURK_CANVAS_CORNERS_MAX
 * corners. */
#define MURK_CANVAS_CORNERS_MAX 128
void murk_canvas_disc(murk_canvas *canvas, const double center[2],
                      double radius, murk_ink ink);
void murk_canvas_fill(murk_canvas *canvas, double left, double top,
                      double width, double height, murk_ink ink);
void murk_canvas_polygon(murk_canvas *canvas, const double (*corner)[2],
                         size_t n, murk_ink ink);

/* Draws a text in UTF-8 with the font size `size` [pixels]. */
void murk_canvas_text(murk_canvas *canvas, double x, double y, double size,
                      murk_text_anchor anchor, murk_ink ink, const char *text);
double murk_canvas_text_width(murk_canvas *canvas, double size,
                              const char *text);

/* The smallest number not below min that is 1, 2 or 5 times a power of ten: a
 * step of an axis. min > 0. */
double murk_canvas_step(double min);

#endif
