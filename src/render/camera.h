/* A camera: position, projection, and the direction of each place of its
 * picture.
 *
 * The picture is `width` by `height` pixels; places on it are counted in pixels
 * from its upper left corner, x to the right and y down, so that the first
 * pixel's middle is (0.5, 0.5).
 *
 * Perspective: a pinhole's picture. Equirectangular: all round, longitude along
 * x and latitude along y, alike by angle; forward is in the middle, what is
 * behind at both sides, up and down are the upper and the lower edge. Its
 * pixels have unlike solid angles, most at the horizon. */
#ifndef MURK_RENDER_CAMERA_H
#define MURK_RENDER_CAMERA_H

#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum murk_projection {
    MURK_PERSPECTIVE,
    MURK_EQUIRECTANGULAR
} murk_projection;

typedef struct murk_camera {
    murk_projection projection;
    murk_vec3 from;
    murk_vec3 forward, right, up; /* unit, at right angles */
    double step[2]; /* perspective: a pixel's width and height in a plane at
                       distance 1 */
    size_t width, height; /* pixels */
} murk_camera;

/* A perspective camera that looks from one point to another, with square
 * pixels. `up` points upwards in the picture as far as the direction allows; it
 * must not be parallel to the direction. */
murk_camera murk_camera_look(murk_vec3 from, murk_vec3 to, murk_vec3 up,
                             double vfov_rad, size_t width, size_t height);

/* Looks forward over these angles, above 0 and below pi, from the left edge to
 * the right and from the lower to the upper: pixels are as square as the
 * angles and counts make them. forward and right: unit, at right angles. */
murk_camera murk_camera_view(murk_vec3 from, murk_vec3 forward, murk_vec3 right,
                             double hfov_rad, double vfov_rad, size_t width,
                             size_t height);

/* Looks all round, +z up; what lies `toward` level is in the middle: not
 * straight up or down. */
murk_camera murk_camera_around(murk_vec3 from, murk_vec3 toward, size_t width,
                               size_t height);

/* The unit direction that a place of the picture looks into. */
murk_vec3 murk_camera_sight(const murk_camera *camera, double x, double y);

/* The same of a place of one pixel for u and v in (0, 1). Perspective: drawn
 * evenly over the pixel; equirectangular: evenly over its solid angle. */
murk_vec3 murk_camera_draw(const murk_camera *camera, size_t column, size_t row,
                           double u, double v);

/* The place of the picture that shows a direction of any length. False if the
 * picture does not show it. */
bool murk_camera_find(const murk_camera *camera, murk_vec3 direction, double *x,
                      double *y);

/* Solid angle of a pixel [sr]. */
double murk_camera_solid_angle(const murk_camera *camera, size_t column,
                               size_t row);

#endif
