/* Turns luminaires from the directions of their files to those of the scene,
 * and lays their openings across the aim. */
#include "world/lamp_shape.h"

#include <math.h>

/* An aim this close to the vertical is vertical: the horizontal direction of a
 * nearly vertical aim would be rounding. */
#define VERTICAL 1e-9

/* The direction of C = 0 at roll 0 by the smallest rotation from straight down
 * to the unit vector `aim`. */
static murk_vec3 smallest_turn(murk_vec3 aim)
{
    const murk_vec3 x = {1, 0, 0}, down = {0, 0, -1};
    const double cosine = murk_dot(down, aim);
    if (hypot(aim.x, aim.y) < VERTICAL) {
        return x; /* down as it is, up by half a turn about x */
    }
    /* Rodrigues' formula with the axis w = down x aim, of length sine. */
    const murk_vec3 w = murk_cross(down, aim);
    const murk_vec3 once = murk_cross(w, x), twice = murk_cross(w, once);
    return murk_unit(murk_along(murk_add(x, once), 1 / (1 + cosine), twice));
}

/* The direction of V = 90 degrees at roll 0: up, at right angles to the aim. */
static murk_vec3 upright(murk_vec3 aim)
{
    const murk_vec3 up = {0, 0, 1};
    if (hypot(aim.x, aim.y) < VERTICAL) {
        return murk_vec(aim.z < 0 ? 1 : -1, 0, 0);
    }
    return murk_unit(murk_along(up, -aim.z, aim));
}

void murk_lamp_shape(murk_source *out, const murk_scene_light *light)
{
    const murk_luminaire *lamp = light->luminaire;
    const murk_vec3 aim = murk_unit(light->direction);
    const murk_vec3 c0 =
        light->has_c0
            ? murk_unit(murk_along(light->c0, -murk_dot(light->c0, aim), aim))
        : lamp->type == MURK_GONIOMETER_C ? smallest_turn(aim)
                                          : upright(aim);
    const murk_vec3 c90 = murk_cross(c0, aim);
    const double c = cos(light->roll_rad), s = sin(light->roll_rad);
    out->intensity = lamp->intensity;
    out->c0 = light->roll_rad == 0
                  ? c0
                  : murk_unit(murk_along(murk_scale(c, c0), s, c90));
    /* The opening. */
    const murk_vec3 across = murk_cross(out->c0, aim);
    out->height_m = light->has_size && lamp->aperture != MURK_APERTURE_POINT
                        ? lamp->height_m
                        : 0;
    if (light->has_size && lamp->aperture == MURK_APERTURE_DISC) {
        out->radius_m = lamp->along_c0_m / 2;
    } else if (light->has_size && lamp->aperture == MURK_APERTURE_RECT) {
        out->edge1 = murk_scale(lamp->along_c0_m, out->c0);
        out->edge2 = murk_scale(lamp->along_c90_m, across);
    }
}
