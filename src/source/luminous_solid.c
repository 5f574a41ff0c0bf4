/* The luminous solid of a luminaire (source/luminous_solid.h): silhouettes of
 * boxes and cylinders, points that are uniform over the silhouette or over the
 * visible outside, and entry points of rays. All draws are inversions, so each
 * takes two numbers. */
#include "source/luminous_solid.h"

#include <math.h>

/* Faces: a box has one across each axis, of the two the one that is seen; a
 * cylinder has a side (0) and a cap (2). */
#define FACES 3

static void areas_of(const murk_luminous_solid *s, double area[FACES])
{
    const double a = 2 * s->half[0], b = 2 * s->half[1], c = 2 * s->half[2];
    area[0] = b * c;
    area[1] = a * c;
    area[2] = a * b;
}

/* The projected areas of the faces along a unit direction. A cylinder's side
 * shows a rectangle. */
static void projected(const murk_luminous_solid *s, murk_vec3 d,
                      double area[FACES])
{
    if (s->radius > 0) {
        area[0] = 4 * s->radius * s->half[2] * hypot(d.x, d.y);
        area[1] = 0;
        area[2] = MURK_PI * s->radius * s->radius * fabs(d.z);
        return;
    }
    areas_of(s, area);
    for (int k = 0; k < FACES; ++k) {
        area[k] *= fabs(murk_component(d, k));
    }
}

double murk_luminous_silhouette(const murk_luminous_solid *s, murk_vec3 d)
{
    double area[FACES];
    projected(s, d, area);
    return area[0] + area[1] + area[2];
}

/* Draws a face in proportion to the areas. *u becomes a uniform number that
 * does not depend on the choice. */
static int draw_face(const double area[FACES], double *u)
{
    double rest = *u * (area[0] + area[1] + area[2]);
    int k = 0;
    while (k + 1 < FACES && rest >= area[k]) {
        rest -= area[k];
        ++k;
    }
    /* Rounding may lead behind the last area. */
    *u = area[k] > 0 ? fmin(rest / area[k], 1) : 0.5;
    return k;
}

/* The point of a cap of a cylinder, or of a face of a box across axis k, on the
 * side of the sign. */
static murk_vec3 flat_point(const murk_luminous_solid *s, int k, double side,
                            double u, double v)
{
    double at[3];
    if (s->radius > 0) {
        const double rho = s->radius * sqrt(u), phi = 2 * MURK_PI * v;
        return murk_vec(rho * cos(phi), rho * sin(phi),
                        copysign(s->half[2], side));
    }
    at[k] = copysign(s->half[k], side);
    at[(k + 1) % 3] = (2 * u - 1) * s->half[(k + 1) % 3];
    at[(k + 2) % 3] = (2 * v - 1) * s->half[(k + 2) % 3];
    return murk_vec(at[0], at[1], at[2]);
}

static murk_vec3 flat_normal(int k, double side)
{
    const double sign = copysign(1, side);
    return murk_vec(k == 0 ? sign : 0, k == 1 ? sign : 0, k == 2 ? sign : 0);
}

/* The normal of a cylinder's side at an angle, of this sine and cosine, from
 * the azimuth of a direction or place. */
static murk_vec3 side_normal(murk_vec3 towards, double cosine, double sine)
{
    const double length = hypot(towards.x, towards.y);
    const double x = towards.x / length, y = towards.y / length;
    return murk_vec(cosine * x - sine * y, cosine * y + sine * x, 0);
}

static murk_vec3 side_point(const murk_luminous_solid *s, murk_vec3 normal,
                            double v)
{
    return murk_vec(s->radius * normal.x, s->radius * normal.y,
                    (2 * v - 1) * s->half[2]);
}

murk_vec3 murk_luminous_leave(const murk_luminous_solid *s, murk_vec3 d,
                              const double u[2])
{
    double area[FACES], first = u[0];
    projected(s, d, area);
    const int k = draw_face(area, &first);
    if (s->radius > 0 && k == 0) {
        /* Uniform across the rectangle that the side shows. */
        const double across = 2 * first - 1;
        return side_point(
            s, side_normal(d, sqrt((1 - across) * (1 + across)), across), u[1]);
    }
    return flat_point(s, k, murk_component(d, k), first, u[1]);
}

/* The areas of the faces that a place sees, and half the angle of a cylinder's
 * side that it sees. */
static double seen_from(const murk_luminous_solid *s, murk_vec3 place,
                        double area[FACES], double *half_angle)
{
    *half_angle = 0;
    if (s->radius > 0) {
        const double rho = hypot(place.x, place.y);
        *half_angle = rho > s->radius ? acos(s->radius / rho) : 0;
        area[0] = 4 * *half_angle * s->radius * s->half[2];
        area[1] = 0;
        area[2] =
            fabs(place.z) > s->half[2] ? MURK_PI * s->radius * s->radius : 0;
    } else {
        areas_of(s, area);
        for (int k = 0; k < FACES; ++k) {
            area[k] *= fabs(murk_component(place, k)) > s->half[k];
        }
    }
    return area[0] + area[1] + area[2];
}

bool murk_luminous_draw(const murk_luminous_solid *s, murk_vec3 place,
                        const double u[2], murk_luminous_point *out)
{
    double area[FACES], half_angle, first = u[0];
    out->area = seen_from(s, place, area, &half_angle);
    if (!(out->area > 0)) {
        return false;
    }
    const int k = draw_face(area, &first);
    if (s->radius > 0 && k == 0) {
        const double angle = (2 * first - 1) * half_angle;
        out->normal = side_normal(place, cos(angle), sin(angle));
        out->point = side_point(s, out->normal, u[1]);
        return true;
    }
    const double side = murk_component(place, k);
    out->normal = flat_normal(k, side);
    out->point = flat_point(s, k, side, first, u[1]);
    return true;
}

/* Meets the face across axis k that the place sees. */
static bool meet_flat(const murk_luminous_solid *s, int k, murk_vec3 place,
                      murk_vec3 sight, murk_luminous_point *out,
                      double *distance_m)
{
    const double at = murk_component(place, k),
                 toward = murk_component(sight, k);
    if (!(fabs(at) > s->half[k]) || !(at * toward < 0)) {
        return false;
    }
    *distance_m = (fabs(at) - s->half[k]) / fabs(toward);
    out->point = murk_along(place, *distance_m, sight);
    out->normal = flat_normal(k, at);
    if (s->radius > 0) {
        return hypot(out->point.x, out->point.y) < s->radius;
    }
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    return fabs(murk_component(out->point, i)) < s->half[i] &&
           fabs(murk_component(out->point, j)) < s->half[j];
}

/* Meets the side of a cylinder from outside: the first root of
 * |place + t sight|^2 = radius^2 in the plane across the axis. */
static bool meet_side(const murk_luminous_solid *s, murk_vec3 place,
                      murk_vec3 sight, murk_luminous_point *out,
                      double *distance_m)
{
    const double a = sight.x * sight.x + sight.y * sight.y;
    const double b = place.x * sight.x + place.y * sight.y;
    const double c =
        place.x * place.x + place.y * place.y - s->radius * s->radius;
    const double root = b * b - a * c;
    if (!(c > 0) || !(b < 0) || !(root > 0)) {
        return false;
    }
    *distance_m = c / (-b + sqrt(root)); /* without cancellation */
    out->point = murk_along(place, *distance_m, sight);
    out->normal =
        murk_vec(out->point.x / s->radius, out->point.y / s->radius, 0);
    return fabs(out->point.z) < s->half[2];
}

bool murk_luminous_meet(const murk_luminous_solid *s, murk_vec3 place,
                        murk_vec3 sight, murk_luminous_point *out,
                        double *distance_m)
{
    double area[FACES], half_angle;
    out->area = seen_from(s, place, area, &half_angle);
    /* At most one face that the place sees is entered first: the solid is
     * convex. */
    if (s->radius > 0) {
        return meet_flat(s, 2, place, sight, out, distance_m) ||
               meet_side(s, place, sight, out, distance_m);
    }
    return meet_flat(s, 0, place, sight, out, distance_m) ||
           meet_flat(s, 1, place, sight, out, distance_m) ||
           meet_flat(s, 2, place, sight, out, distance_m);
}
