/* Construction of the shadow of a triangle, reduced by a margin for the
 * rounding of single precision. */
#include "geometry/shadow.h"

/* Margin in float steps by which a ray must miss every edge, and by which
 * eye and point must be away from the plane. A ray's float origin and
 * direction move it by at most 4 units anywhere in the scene, its ends are
 * moved inwards by 8, and Embree's own arithmetic adds at most some 8. Cost:
 * only that rays which pass within the margin are left to Embree. */
#define MARGIN_UNITS 64

bool murk_shadow_make(murk_shadow *s, const murk_triangle *triangle,
                      murk_vec3 eye, double unit_m, double farthest_m)
{
    /* Orient the normal away from the eye. */
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
    /* The plane of the triangle: points behind it by more than the margin. */
    s->normal[3] = normal;
    s->offset[3] = -murk_dot(normal, triangle->a) - margin;
    /* The planes through the eye and each edge. A ray that is d off such a
     * plane at the far end is at least d * nearest / farthest off where it
     * passes the edge. */
    const double side_margin = margin * farthest_m / nearest;
    const murk_vec3 corner[3] = {
        murk_sub(triangle->a, eye),
        murk_sub(is_turned ? triangle->c : triangle->b, eye),
        murk_sub(is_turned ? triangle->b : triangle->c, eye)};
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 side =
            murk_unit(murk_cross(corner[i], corner[(i + 1) % 3]));
        s->normal[i] = side; /* not finite if the eye is on the line of the
                                edge: then murk_shadow_hides() is false */
        s->offset[i] = -murk_dot(side, eye) - side_margin;
    }
    return true;
}
