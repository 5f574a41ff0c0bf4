/* Area of the intersection of a plane and a box: a square in the plane that is
 * larger than the box is clipped by the six sides of the box in turn (I. E.
 * Sutherland and G. W. Hodgman, Communications of the ACM 17 (1974) 32,
 * doi:10.1145/360767.360802), and the area of the remaining polygon is the sum
 * of the triangles of a fan. */
#include "world/plane_area.h"

#include <math.h>
#include <stddef.h>

/* A square has 4 corners, and clipping by each of 6 sides adds at most one: 10,
 * rounded up to a power of two. */
#define CORNERS_MAX 16

typedef struct polygon {
    size_t n;
    murk_vec3 corner[CORNERS_MAX];
} polygon;

/* Clips a polygon: keeps the part with sign * (x - bound) <= 0 on an axis. */
static polygon cut(const polygon *p, int axis, double bound, double sign)
{
    polygon out = {0};
    for (size_t i = 0; i < p->n && out.n + 2 <= CORNERS_MAX; ++i) {
        const murk_vec3 a = p->corner[i], b = p->corner[(i + 1) % p->n];
        const double da = sign * (murk_component(a, axis) - bound),
                     db = sign * (murk_component(b, axis) - bound);
        if (da <= 0) {
            out.corner[out.n++] = a;
        }
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
            out.corner[out.n++] = murk_along(a, da / (da - db), murk_sub(b, a));
        }
    }
    return out;
}

double murk_plane_area(const murk_box *box, murk_vec3 point, murk_vec3 normal)
{
    /* Two unit vectors u, v span the plane. */
    const murk_vec3 n = murk_unit(normal);
    const murk_vec3 other =
        fabs(n.x) < .6 ? murk_vec(1, 0, 0) : murk_vec(0, 1, 0);
    const murk_vec3 u = murk_unit(murk_cross(n, other)), v = murk_cross(n, u);
    /* The square must cover the box as seen from the point. */
    const murk_vec3 middle = murk_scale(.5, murk_add(box->min, box->max));
    const double reach = murk_length(murk_sub(box->max, box->min)) +
                         murk_length(murk_sub(point, middle));
    polygon p = {.n = 4};
    for (int i = 0; i < 4; ++i) {
        const double s = i == 1 || i == 2 ? reach : -reach,
                     t = i >= 2 ? reach : -reach;
        p.corner[i] = murk_along(murk_along(point, s, u), t, v);
    }
    /* Clip by the two sides of the box on each axis. */
    for (int axis = 0; axis < 3; ++axis) {
        p = cut(&p, axis, murk_component(box->max, axis), 1);
        p = cut(&p, axis, murk_component(box->min, axis), -1);
    }
    /* Add twice the area vectors of the triangles of a fan. */
    murk_vec3 twice = murk_vec(0, 0, 0);
    for (size_t i = 2; i < p.n; ++i) {
        twice =
            murk_add(twice, murk_cross(murk_sub(p.corner[i - 1], p.corner[0]),
                                       murk_sub(p.corner[i], p.corner[0])));
    }
    return murk_length(twice) / 2;
}
