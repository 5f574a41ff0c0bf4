/* Cameras: position, projection, and the ray of each point of the picture.
 *
 * The picture has `width` by `height` pixels. Points of the picture are counted
 * in pixels from the upper left corner, x to the right and y down, so that the
 * center of the first pixel is (0.5, 0.5).
 *
 * Perspective: a pinhole camera. Equirectangular: a panorama with longitude
 * along x and latitude along y, with equal angles for equal distances. Forward
 * is in the center, backward at both sides, up and down are the upper and the
 * lower edge. The pixels have different solid angles, the largest at the
 * horizon. Orthographic: all rays are parallel to the axis of the camera and
 * begin in a plane through its position. A pixel shows the radiance in that one
 * direction, as a mean over the area of the pixel; the picture has a scale, and
 * no solid angle. The mean of a picture times its area is the radiant intensity
 * [W/sr] that passes through the area towards the camera.
 *
 * A clip plane hides everything on the side of the camera: surfaces, media and
 * light sources. A ray begins where it crosses the plane. Light that reaches
 * what is seen is not clipped. */
#ifndef MURK_RENDER_CAMERA_H
#define MURK_RENDER_CAMERA_H

#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>

/* A plane that hides everything on the side of the camera. */
typedef struct murk_clip {
    bool is_set;
    murk_vec3 point, normal; /* normal: unit, of either sign */
} murk_clip;

typedef enum murk_projection {
    MURK_PERSPECTIVE,
    MURK_EQUIRECTANGULAR,
    MURK_ORTHOGRAPHIC
} murk_projection;

typedef struct murk_camera {
    murk_projection projection;
    murk_vec3 from;
    murk_vec3 forward, right, up; /* unit, at right angles */
    double step[2]; /* perspective: width and height of a pixel in a plane at
                     * distance 1; orthographic: of a pixel [m] */
    size_t width, height; /* pixels */
    murk_clip clip;
} murk_camera;

/* The word of a scene for a projection: "perspective". */
const char *murk_projection_name(murk_projection projection);

/* A perspective camera that looks from one point to another, with square
 * pixels. `up` points upwards in the picture as far as the direction allows; it
 * must not be parallel to the direction. */
murk_camera murk_camera_aimed(murk_vec3 from, murk_vec3 to, murk_vec3 up,
                              double vfov_rad, size_t width, size_t height);

/* A perspective camera with the given angles of view, above 0 and below pi,
 * from the left to the right edge and from the lower to the upper edge. The
 * shape of a pixel follows from the angles and the numbers of pixels. forward
 * and right are unit vectors at right angles. */
murk_camera murk_camera_view(murk_vec3 from, murk_vec3 forward, murk_vec3 right,
                             double hfov_rad, double vfov_rad, size_t width,
                             size_t height);

/* A panorama camera with +z up. The horizontal direction of `toward` is in the
 * center; `toward` must not be vertical. */
murk_camera murk_camera_around(murk_vec3 from, murk_vec3 toward, size_t width,
                               size_t height);

/* An orthographic camera that looks from one point towards another, with square
 * pixels. The picture is width_m wide; `from` is in the middle. */
murk_camera murk_camera_parallel(murk_vec3 from, murk_vec3 to, murk_vec3 up,
                                 double width_m, size_t width, size_t height);

/* A ray of a camera. */
typedef struct murk_camera_ray {
    murk_vec3 origin, direction;
    double skipped_m; /* from the camera, or its plane if orthographic, to the
                       * origin */
} murk_camera_ray;

/* The ray of a direction through the point (x, y) of the picture, from where it
 * shows something: behind the clip plane, and in the domain. Surfaces nearer
 * than margin_m behind the plane count as lying in the plane and are hidden.
 * False if the ray shows nothing: it does not cross the plane, or passes by the
 * domain. Without a clip plane, the ray of a camera that is not orthographic
 * begins at the camera, which stands in the domain. */
bool murk_camera_begin(murk_camera_ray *out, const murk_camera *camera,
                       double x, double y, murk_vec3 direction,
                       const murk_box *domain, double margin_m);

/* The unit direction of a point of the picture. */
murk_vec3 murk_camera_sight(const murk_camera *camera, double x, double y);

/* The unit direction of a random point of a pixel for u and v in (0, 1):
 * uniform over the pixel, or over the solid angle of the pixel of a panorama.
 */
murk_vec3 murk_camera_draw(const murk_camera *camera, size_t column, size_t row,
                           double u, double v);

/* The place of the picture that shows the point at `direction` from the camera;
 * the length matters only for an orthographic camera. False if the
 * picture does not show the direction; *x and *y have then no meaning. */
bool murk_camera_find(const murk_camera *camera, murk_vec3 direction, double *x,
                      double *y);

/* The solid angle of a pixel [sr]; 0 for an orthographic camera. */
double murk_camera_solid_angle(const murk_camera *camera, size_t column,
                               size_t row);

#endif
