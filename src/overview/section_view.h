/* One view of a scene as architects draw it: the world is cut by a plane at
 * right angles to an axis, surfaces in the plane are lines, and everything
 * beyond the plane is seen along the axis without perspective. */
#ifndef MURK_OVERVIEW_SECTION_VIEW_H
#define MURK_OVERVIEW_SECTION_VIEW_H

#include "path/viewpoint.h"
#include "render/canvas.h"
#include "world/stage.h"

/* Things of different colours differ in brightness, width or shape, too, for
 * prints in grey and for colour-blind people. */
#define MURK_SECTION_WALL     ((murk_ink){{25, 25, 25}, 1})
#define MURK_SECTION_SHEET    ((murk_ink){{20, 110, 180}, 1})
#define MURK_SECTION_SOLID    ((murk_ink){{0, 130, 130}, 1})
#define MURK_SECTION_MEDIUM   ((murk_ink){{85, 130, 210}, 1})
#define MURK_SECTION_DOMAIN   ((murk_ink){{90, 90, 90}, 1})
#define MURK_SECTION_TINT_MAX 0.4 /* opacity of the densest medium */

typedef struct murk_section_view {
    /* Set by the caller: the axes of the world (0 x, 1 y, 2 z) to the right, up
     * and along the direction of sight, which is towards larger coordinates
     * with sign +1. */
    int right, up, along;
    double sign;
    double cut_m; /* coordinate of the plane on the axis `along` */
    /* The rectangle of the picture in pixels (whole numbers), the coordinates
     * of its lower left corner, and pixels per metre. */
    double left, top, width, height;
    double low[2], scale;
} murk_section_view;

/* What the pixels of a view show, filled by murk_section_sample(). Arrays have
 * a value for each pixel, row by row from the top. */
typedef struct murk_section_pixels {
    float *depth_m;   /* from the plane to the first surface that is no
                       * transmitting sheet; NAN: none */
    float *facing;    /* absolute cosine between the normal of that surface and
                       * the sight */
    float *normal[2]; /* components of the normal to the right and up */
    float *extinction_per_m; /* in the plane, in the first band */
    uint8_t *sheets;         /* transmitting sheets before the surface */
    double extinction_max_per_m, depth_max_m;
    size_t width, height;
} murk_section_pixels;

/* The place of the picture that shows a place of the world. */
void murk_section_find(const murk_section_view *view, murk_vec3 place,
                       double out[2]);

/* The lengths of a direction to the right and down in the picture. */
void murk_section_direction(const murk_section_view *view, murk_vec3 direction,
                            double out[2]);

/* Looks at the world beyond the plane, one ray a pixel. Release *out in any
 * case. Fails with MURK_NO_MEMORY. */
murk_status murk_section_sample(murk_section_pixels *out,
                                const murk_section_view *view,
                                const murk_stage *stage, unsigned threads,
                                murk_error *err);
void murk_section_release(murk_section_pixels *pixels);

/* Draws surfaces beyond the plane in light grey, and media in the plane as a
 * tint; an extinction of max_per_m has the strongest tint. */
void murk_section_draw_beyond(murk_canvas *canvas,
                              const murk_section_view *view,
                              const murk_section_pixels *pixels,
                              double max_per_m);

/* Draws the surfaces that the plane cuts, in the given width. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_section_draw_cut(murk_canvas *canvas,
                                  const murk_section_view *view,
                                  const murk_stage *stage, double line_width,
                                  murk_error *err);

/* Draws the outline of a box, of a box moved by `placed`, or of a ball. */
void murk_section_draw_box(murk_canvas *canvas, const murk_section_view *view,
                           const murk_box *box, const murk_affine *placed,
                           const murk_pen *pen);
void murk_section_draw_ball(murk_canvas *canvas, const murk_section_view *view,
                            murk_vec3 center, double radius_m,
                            const murk_pen *pen);

#endif
