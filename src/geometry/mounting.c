#include "geometry/mounting.h"

#include "geometry/polygon.h"

#define OWN_COSINE 0.70710678118654752 /* cos 45 degrees */

static murk_vec3 nearest_on_segment(murk_vec3 a, murk_vec3 b, murk_vec3 p)
{
    const murk_vec3 ab = murk_sub(b, a);
    const double length2 = murk_dot(ab, ab);
    const double share =
        length2 > 0 ? murk_dot(murk_sub(p, a), ab) / length2 : 0;
    return murk_along(a, fmin(1, fmax(0, share)), ab);
}

/* Of a convex polygon that lies in the plane of `normal` (of any length). */
static murk_vec3 nearest_on(const murk_polygon *polygon, murk_vec3 normal,
                            murk_vec3 p)
{
    murk_vec3 nearest = {INFINITY, INFINITY, INFINITY};
    double min = INFINITY;
    bool is_over = true;
    for (size_t i = 0; i < polygon->n; ++i) {
        const murk_vec3 a = polygon->corner[i],
                        b = polygon->corner[(i + 1) % polygon->n];
        is_over &=
            murk_dot(murk_cross(murk_sub(b, a), murk_sub(p, a)), normal) >= 0;
        const murk_vec3 here = nearest_on_segment(a, b, p);
        const double distance = murk_length(murk_sub(here, p));
        if (distance < min) {
            min = distance;
            nearest = here;
        }
    }
    if (!is_over) {
        return nearest;
    }
    const double height = murk_dot(murk_sub(p, polygon->corner[0]), normal) /
                          murk_dot(normal, normal);
    return murk_along(p, -height, normal);
}

/* A smooth surface goes on so: over the way to its place, its slope came from
 * 0 to what the face has. */
static bool goes_on_to(const murk_mounting *m, murk_vec3 normal,
                       murk_vec3 place)
{
    const double cosine = fabs(murk_dot(m->normal, murk_unit(normal)));
    const double slope = sqrt(fmax(0, 1 - cosine * cosine)) / cosine;
    const murk_vec3 off = murk_sub(place, m->foot);
    const double rise = murk_dot(off, m->normal);
    const double along = murk_length(murk_along(off, -rise, m->normal));
    return cosine > OWN_COSINE && rise <= slope * along + m->slack_m;
}

double murk_mounting_from_face(const murk_mounting *m,
                               const murk_triangle *face, murk_vec3 point)
{
    const double floor_m = murk_dot(m->normal, m->foot) + m->above_m;
    const murk_polygon part = murk_triangle_above(face, m->normal, floor_m);
    if (part.n == 0) {
        return INFINITY;
    }
    const murk_vec3 normal = murk_triangle_normal(face);
    const murk_vec3 nearest = nearest_on(&part, normal, point);
    return goes_on_to(m, normal, nearest)
               ? INFINITY
               : murk_length(murk_sub(nearest, point));
}

double murk_mounting_from_ball(const murk_mounting *m, const murk_ball *b,
                               murk_vec3 point)
{
    const murk_vec3 off = murk_sub(m->foot, b->center);
    if (fabs(murk_length(off) - b->radius) <= m->slack_m) {
        return INFINITY;
    }
    const murk_vec3 from = murk_sub(point, b->center);
    const double distance = murk_length(from);
    /* heights are over the center, along the foot's normal */
    const double floor_m = murk_dot(off, m->normal) + m->above_m;
    const double height = murk_dot(from, m->normal);
    if (!(floor_m < b->radius)) {
        return INFINITY;
    }
    if (distance > 0 && b->radius * height / distance >= floor_m) {
        return fabs(distance - b->radius);
    }
    /* nearest is on the circle that the floor cuts out, or none if that is all
     * of the sphere */
    const double aside = sqrt(fmax(0, distance * distance - height * height));
    const double circle =
        sqrt(fmax(0, b->radius * b->radius - floor_m * floor_m));
    return floor_m <= -b->radius ? fabs(distance - b->radius)
                                 : hypot(aside - circle, height - floor_m);
}
