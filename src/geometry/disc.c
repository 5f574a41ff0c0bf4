#include "geometry/disc.h"

#include "geometry/triangle.h"
#include "geometry/world.h"

#include <float.h>

/* What the area may be off by, as a share, for rounding of places that lie in
 * the plane. */
#define FILLED 1e-3

/* Cosine of planes that are taken for one: above what packing a record's normal
 * turns it by. */
#define PARALLEL 0.999999

/* Area between the origin and the part of an edge within the circle, and of
 * the circle's sectors where the edge is outside; signed by the way round. */
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
    double first = 1, last = 1; /* along the edge, what is in the circle */
    if (root > 0) {
        first = fmin(fmax((-b - sqrt(root)) / a, 0), 1);
        last = fmin(fmax((-b + sqrt(root)) / a, 0), 1);
    }
    const double from[2] = {p[0] + first * d[0], p[1] + first * d[1]};
    const double to[2] = {p[0] + last * d[0], p[1] + last * d[1]};
    const double *const way[4] = {p, from, to, q};
    double area = 0;
    for (int i = 0; i < 3; ++i) {
        const double *u = way[i], *v = way[i + 1];
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
    bool is_crowded; /* something else is there */
} filling;

static bool look_at(struct RTCPointQueryFunctionArguments *args)
{
    filling *f = args->userPtr;
    const struct RTCHit hit = {.geomID = args->geomID, .primID = args->primID};
    const murk_primitive p = murk_primitive_of(&f->s->soup, &hit);
    if (p.is_ball) {
        const murk_ball *b = &f->s->soup.ball[p.index];
        const double off = murk_length(murk_sub(f->center, b->center));
        f->is_crowded |= fabs(off - b->radius) < f->radius;
    } else {
        const murk_triangle t = murk_soup_triangle(&f->s->soup, p.index);
        const murk_vec3 vertex[3] = {t.a, t.b, t.c};
        const murk_vec3 normal = murk_unit(murk_triangle_normal(&t));
        const bool is_flat =
            fabs(murk_dot(normal, f->normal)) > PARALLEL &&
            fabs(murk_dot(normal, murk_sub(t.a, f->center))) <= f->slack;
        double corner[3][2];
        for (int i = 0; i < 3; ++i) {
            const murk_vec3 way = murk_sub(vertex[i], f->center);
            corner[i][0] = murk_dot(way, f->across[0]);
            corner[i][1] = murk_dot(way, f->across[1]);
        }
        if (is_flat) {
            f->area += murk_disc_area_in_triangle(corner, f->radius);
        } else {
            f->is_crowded |=
                murk_triangle_distance2(&t, f->center) < f->radius * f->radius;
        }
    }
    if (f->is_crowded) {
        args->query->radius = 0; /* nothing further needs a look */
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
    filling f = {.s = s,
                 .center = murk_sub(center, s->soup.anchor),
                 .normal = normal,
                 .radius = radius_m,
                 .slack = s->leave_m};
    murk_frame(normal, &f.across[0], &f.across[1]);
    /* Float rounding of the query must not lose a surface at the rim. */
    const double size =
        fabs(f.center.x) + fabs(f.center.y) + fabs(f.center.z) + radius_m;
    struct RTCPointQuery query = {
        .x = (float)f.center.x,
        .y = (float)f.center.y,
        .z = (float)f.center.z,
        .radius = (float)(radius_m + s->leave_m + size * (double)FLT_EPSILON)};
    struct RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(s->scene, &query, &context, look_at, &f);
    const double whole = MURK_PI * radius_m * radius_m;
    return !f.is_crowded && fabs(f.area - whole) < FILLED * whole;
}
