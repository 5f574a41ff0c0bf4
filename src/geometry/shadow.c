#include "geometry/shadow.h"

/* The ray must pass every edge, and eye and point must keep away from the
 * plane, by this much. A ray's float origin and direction move it by at most
 * 4 units anywhere in the scene, its ends are drawn in by 8, and Embree's own
 * arithmetic adds at most some 8. Costs: nothing but a call to Embree for rays
 * that pass this near. */
#define MARGIN_UNITS 64

bool murk_shadow_make(murk_shadow *s, const murk_triangle *triangle,
                      murk_vec3 eye, double unit_m, double farthest_m)
{
    const double margin = MARGIN_UNITS * unit_m;
    const double nearest = sqrt(murk_triangle_distance2(triangle, eye));
    murk_vec3 normal = murk_unit(murk_triangle_normal(triangle));
    double height = murk_dot(murk_sub(triangle->a, eye), normal);
    const bool is_turned = height < 0;
    if (is_turned) {
        normal = murk_scale(-1, normal);
        height = -height;
    }
    if (!(height > margin)) {
        return false;
    }
    s->normal[3] = normal;
    s->offset[3] = -murk_dot(normal, triangle->a) - margin;
    /* A ray that is d off a side plane at its far end is at least
     * d * nearest / farthest off where it passes the edge. */
    const double side_margin = margin * farthest_m / nearest;
    const murk_vec3 corner[3] = {
        murk_sub(triangle->a, eye),
        murk_sub(is_turned ? triangle->c : triangle->b, eye),
        murk_sub(is_turned ? triangle->b : triangle->c, eye)};
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 side =
            murk_unit(murk_cross(corner[i], corner[(i + 1) % 3]));
        s->normal[i] = side; /* not finite when eye and edge are in line: then
                                murk_shadow_hides() is false */
        s->offset[i] = -murk_dot(side, eye) - side_margin;
    }
    return true;
}
