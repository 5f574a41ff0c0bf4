/* Area of a disc that is covered by flat triangles.
 *
 * The area of the intersection of a triangle and a circle is the sum over
 * the three edges of a signed area: the triangle between the circle's centre
 * and the part of the edge inside the circle, and circular sectors for the
 * parts outside. A point query finds all primitives near the disc. */
#include "geometry/disc.h"

#include "geometry/ray_scene.h"
#include "geometry/triangle.h"

/* Allowed relative error of the covered area: rounding of vertices in the plane
 * stays well below this error. */
#define FILLED 1e-3

/* Planes whose normals have a larger cosine count as one plane: 1.4e-3 rad,
 * above the error of the packed normal of a photon record. */
#define PARALLEL 0.999999

/* Signed area between the origin and an edge p-q within the circle: a
 * triangle for the part of the edge inside the circle, sectors for the rest.
 * The sign is that of the direction around the origin. */
static double edge_area(const double p[2], const double q[2], double radius)
{
    const double d[2] = {q[0] - p[0], q[1] - p[1]};
    const double a = d[0] * d[0] + d[1] * d[1];
    if (!(a > 0)) {
        return 0;
    }
    const double b = p[0] * d[0] + p[1] * d[1];
    const double c = p[0] * p[0] + p[1] * p[1] - radius * radius;
    const double root = b * b - a * c;
    double first = 1, last = 1; /* the part of the edge inside the circle, as
                                 * fractions of the length of the edge */
    if (root > 0) {
        first = fmin(fmax((-b - sqrt(root)) / a, 0), 1);
        last = fmin(fmax((-b + sqrt(root)) / a, 0), 1);
    }
    const double from[2] = {p[0] + first * d[0], p[1] + first * d[1]};
    const double to[2] = {p[0] + last * d[0], p[1] + last * d[1]};
    const double *const point[4] = {p, from, to, q};
    double area = 0;
    for (int i = 0; i < 3; ++i) {
        const double *u = point[i], *v = point[i + 1];
        const double cross = u[0] * v[1] - u[1] * v[0];
        area += i == 1 ? 0.5 * cross
                       : 0.5 * radius * radius *
                             atan2(cross, u[0] * v[0] + u[1] * v[1]);
    }
    return area;
}

double murk_disc_area_in_triangle(double corner[3][2], double radius)
{
    double area = 0;
    for (int i = 0; i < 3; ++i) {
        area += edge_area(corner[i], corner[(i + 1) % 3], radius);
    }
    return fabs(area);
}

typedef struct filling {
    const murk_surfaces *s;
    murk_vec3 center, normal, across[2];
    double radius, slack;
    double area;
    bool is_crowded; /* another surface is near */
} filling;

/* Adds the area of a triangle in the plane of the disc, and notes any other
 * surface within the radius, which ends the search. A callback of
 * murk_ray_scene_visit(). */
static bool visit_primitive(void *context, murk_primitive p)
{
    filling *f = context;
    if (p.is_sphere) {
        const murk_stored_sphere *b = &f->s->soup.sphere[p.index];
        const double off = murk_length(murk_sub(f->center, b->center));
        f->is_crowded |= fabs(off - b->radius) < f->radius;
    } else {
        const murk_triangle t = murk_soup_triangle(&f->s->soup, p.index);
        const murk_vec3 vertex[3] = {t.a, t.b, t.c};
        const murk_vec3 normal = murk_unit(murk_triangle_normal(&t));
        /* Project the triangle into the plane of the disc. */
        const bool is_flat =
            fabs(murk_dot(normal, f->normal)) > PARALLEL &&
            fabs(murk_dot(normal, murk_sub(t.a, f->center))) <= f->slack;
        double corner[3][2];
        for (int i = 0; i < 3; ++i) {
            const murk_vec3 offset = murk_sub(vertex[i], f->center);
            corner[i][0] = murk_dot(offset, f->across[0]);
            corner[i][1] = murk_dot(offset, f->across[1]);
        }
        if (is_flat) {
            f->area += murk_disc_area_in_triangle(corner, f->radius);
        } else {
            f->is_crowded |=
                murk_triangle_distance2(&t, f->center) < f->radius * f->radius;
        }
    }
    return f->is_crowded;
}

bool murk_surfaces_fill_disc(const murk_surfaces *s, murk_vec3 center,
                             murk_vec3 normal, double radius_m)
{
    if (!s->scene || !(radius_m > 0 && radius_m < MURK_RAY_MAX_M) ||
        !murk_ray_is_sound(center, normal)) {
        return false;
    }
    /* Find all surfaces within the radius. */
    filling f = {.s = s,
                 .center = murk_sub(center, s->soup.anchor),
                 .normal = normal,
                 .radius = radius_m,
                 .slack = s->leave_m};
    murk_frame(normal, &f.across[0], &f.across[1]);
    murk_ray_scene_visit(s, f.center, radius_m, visit_primitive, &f);
    /* Covered once: the sum of the areas equals the area of the disc. */
    const double whole = MURK_PI * radius_m * radius_m;
    return !f.is_crowded && fabs(f.area - whole) < FILLED * whole;
}
