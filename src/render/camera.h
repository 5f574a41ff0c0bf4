/* A pinhole camera: where it stands, where each place of its picture looks.
 *
 * The picture is `width` by `height` square pixels; places on it are counted in
 * pixels from its upper left corner, x to the right and y down, so that the
 * first pixel's middle is (0.5, 0.5). */
#ifndef MURK_RENDER_CAMERA_H
#define MURK_RENDER_CAMERA_H

#include "base/vector.h"

#include <stddef.h>

typedef struct murk_camera {
    murk_vec3 from;
    murk_vec3 forward, right, up; /* unit */
    double tangent;               /* of half the vertical angle of scenery */
    size_t width, height;         /* pixels */
} murk_camera;

/* Looks from one point to another, `up` being up in the picture as far as may
 * be: not parallel to the way it looks. */
murk_camera murk_camera_look(murk_vec3 from, murk_vec3 to, murk_vec3 up,
                             double vfov_rad, size_t width, size_t height);

/* The unit direction that a place of the picture looks into. */
murk_vec3 murk_camera_sight(const murk_camera *camera, double x, double y);

#endif
