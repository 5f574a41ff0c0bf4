/* Clips polygons by planes. Each plane is applied in turn to the polygon
 * that is left (Sutherland & Hodgman, Commun. ACM 17 (1974) 32,
 * doi:10.1145/360767.360802). The area is the sum of the triangles of a fan. */
#include "geometry/polygon.h"

static void add(murk_polygon *p, murk_vec3 corner)
{
    if (p->n < MURK_POLYGON_MAX) {
        p->corner[p->n++] = corner;
    }
}

/* Keeps the part of a polygon that is not below a plane, given the height of
 * each corner above the plane. If the plane is perpendicular to `axis` (else
 * -1) at `bound`, new corners lie in the plane to the last bit. */
static murk_polygon cut(const murk_polygon *p, const double *height, int axis,
                        double bound)
{
    murk_polygon out = {0};
    for (size_t i = 0; i < p->n; ++i) {
        const size_t next = (i + 1) % p->n;
        const murk_vec3 from = p->corner[i], to = p->corner[next];
        const double low = height[i], high = height[next];
        if (low >= 0) {
            add(&out, from);
        }
        if ((low > 0 && high < 0) || (low < 0 && high > 0)) {
            murk_vec3 between =
                murk_along(from, low / (low - high), murk_sub(to, from));
            if (axis >= 0) {
                murk_component_set(&between, axis, bound);
            }
            add(&out, between);
        }
    }
    return out;
}

murk_polygon murk_polygon_of_triangle(const murk_triangle *t)
{
    return (murk_polygon){3, {t->a, t->b, t->c}};
}

murk_polygon murk_polygon_in_box(murk_polygon p, const murk_box *box)
{
    for (int face = 0; face < 6 && p.n > 0; ++face) {
        const int axis = face / 2;
        const bool is_low = face % 2 == 0;
        const double bound = murk_component(is_low ? box->min : box->max, axis);
        double height[MURK_POLYGON_MAX];
        bool is_cut = false;
        for (size_t i = 0; i < p.n; ++i) {
            const double off = murk_component(p.corner[i], axis) - bound;
            height[i] = is_low ? off : -off;
            is_cut |= !(height[i] >= 0);
        }
        if (is_cut) {
            p = cut(&p, height, axis, bound);
        }
    }
    return p;
}

double murk_polygon_area_m2(const murk_polygon *p)
{
    murk_vec3 twice = {0, 0, 0};
    for (size_t i = 2; i < p->n; ++i) {
        twice =
            murk_add(twice, murk_cross(murk_sub(p->corner[i - 1], p->corner[0]),
                                       murk_sub(p->corner[i], p->corner[0])));
    }
    return 0.5 * murk_length(twice);
}

murk_polygon murk_triangle_above(const murk_triangle *t, murk_vec3 normal,
                                 double height)
{
    const murk_polygon p = murk_polygon_of_triangle(t);
    double above[MURK_POLYGON_MAX];
    for (size_t i = 0; i < p.n; ++i) {
        above[i] = murk_dot(normal, p.corner[i]) - height;
    }
    return cut(&p, above, -1, 0);
}
