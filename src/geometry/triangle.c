/* Distances to triangles, and intersections of lines with spheres, in double
 * precision. */
#include "geometry/triangle.h"

/* See murk_triangle_is_degenerate(). */
#define DEGENERATE_SINE 0x1p-31

bool murk_triangle_is_degenerate(const murk_triangle *t)
{
    const murk_vec3 ab = murk_sub(t->b, t->a);
    const murk_vec3 ac = murk_sub(t->c, t->a);
    const double sides = murk_length(ab) * murk_length(ac);
    return !(murk_length(murk_cross(ab, ac)) > DEGENERATE_SINE * sides) ||
           !(murk_length(murk_sub(t->c, t->b)) > 0);
}

static double segment_distance2(murk_vec3 a, murk_vec3 b, murk_vec3 p)
{
    const murk_vec3 ab = murk_sub(b, a);
    const double along = murk_dot(murk_sub(p, a), ab) / murk_dot(ab, ab);
    const double cut = fmin(1, fmax(0, along));
    const murk_vec3 off = murk_sub(p, murk_along(a, cut, ab));
    return murk_dot(off, off);
}

double murk_triangle_distance2(const murk_triangle *t, murk_vec3 p)
{
    const murk_vec3 n = murk_triangle_normal(t);
    const murk_vec3 pa = murk_sub(p, t->a);
    const murk_vec3 pb = murk_sub(p, t->b);
    const murk_vec3 pc = murk_sub(p, t->c);
    const bool projects_inside =
        murk_dot(murk_cross(murk_sub(t->b, t->a), pa), n) >= 0 &&
        murk_dot(murk_cross(murk_sub(t->c, t->b), pb), n) >= 0 &&
        murk_dot(murk_cross(murk_sub(t->a, t->c), pc), n) >= 0;
    if (projects_inside) {
        const double height = murk_dot(pa, n);
        return height * height / murk_dot(n, n);
    }
    return fmin(segment_distance2(t->a, t->b, p),
                fmin(segment_distance2(t->b, t->c, p),
                     segment_distance2(t->c, t->a, p)));
}

bool murk_sphere_roots(murk_vec3 center, double radius, murk_vec3 o,
                       murk_vec3 d, double t[2])
{
    /* Computed from the point of closest approach, which keeps digits if the
     * sphere is small and far away. */
    const murk_vec3 from = murk_sub(o, center);
    const double d2 = murk_dot(d, d);
    const double middle = -murk_dot(from, d) / d2;
    const murk_vec3 nearest = murk_along(from, middle, d);
    const double half2 = (radius * radius - murk_dot(nearest, nearest)) / d2;
    if (!(half2 > 0)) {
        return false;
    }
    t[0] = middle - sqrt(half2);
    t[1] = middle + sqrt(half2);
    return true;
}
