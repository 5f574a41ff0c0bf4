/* Thin sheets along a sightline: how much the sheets between two points
 * transmit.
 *
 * The walk along a ray goes through the Embree scene of all surfaces. Most
 * sightlines in a building cross no pane, and panes lie in few planes, such as
 * those of the walls. So the planes of the sheets are listed once for a scene,
 * and a sightline that crosses none of the planes at a sheet is not walked.
 *
 * The test is certain. Let a ray cross a plane at X at an angle of the sine s.
 * Embree's test of a triangle in the plane errs by a few float steps: in the
 * height of the hit above the plane, and, times 1 / s, in the distance of X
 * from the edges of the triangle. MARGIN_UNITS exceeds these errors, so a
 * sightline is skipped only if both ends are farther than the margin on one
 * side of the plane, or if X is farther than the margin times 1 / s from the
 * box of the sheets. A ray along the plane has s = 0 and is walked. */
#include "geometry/triangle.h"
#include "geometry/walk.h"

/* Margin in float steps (geometry/ray_scene.h). Rounding moves a ray by at most
 * 4, Embree's arithmetic by some 8, and a corner may be 1 off the plane that it
 * is listed in. */
#define MARGIN_UNITS 64

/* Adds a triangle to the plane that contains the corners to a float step, or to
 * a new plane. False if there are too many planes. */
static bool add_triangle(murk_sheet_planes *planes, const murk_triangle *t,
                         double unit_m)
{
    /* The plane that contains the corners. */
    size_t k = 0;
    for (; k < planes->n; ++k) {
        const murk_vec3 normal = {planes->x[k], planes->y[k], planes->z[k]};
        const double offset = planes->offset[k];
        if (fabs(murk_dot(normal, t->a) + offset) <= unit_m &&
            fabs(murk_dot(normal, t->b) + offset) <= unit_m &&
            fabs(murk_dot(normal, t->c) + offset) <= unit_m) {
            break;
        }
    }
    if (k == MURK_SHEET_PLANES_MAX) {
        return false;
    }
    /* A new plane, that of the triangle. */
    if (k == planes->n) {
        const murk_vec3 normal = murk_unit(murk_triangle_normal(t));
        planes->x[k] = normal.x;
        planes->y[k] = normal.y;
        planes->z[k] = normal.z;
        planes->offset[k] = -murk_dot(normal, t->a);
        planes->box[k] = murk_box_empty();
        ++planes->n;
    }
    murk_box *box = &planes->box[k];
    *box = murk_box_with(murk_box_with(murk_box_with(*box, t->a), t->b), t->c);
    return true;
}

murk_sheet_planes murk_sheet_planes_of(const murk_soup *soup, double unit_m)
{
    murk_sheet_planes planes = {0};
    const size_t end = soup->first_triangle[MURK_FACE_SHEET + 1];
    planes.are_all = soup->first_sphere[MURK_FACE_SHEET] ==
                     soup->first_sphere[MURK_FACE_SHEET + 1];
    for (size_t i = soup->first_triangle[MURK_FACE_SHEET];
         i < end && planes.are_all; ++i) {
        const murk_triangle t = murk_soup_triangle(soup, i);
        planes.are_all = add_triangle(&planes, &t, unit_m);
    }
    return planes;
}

/* True if X, the point in which the line through two points meets a plane, is
 * for certain too far from the box of the plane's sheets. height_a and height_b
 * are the heights of the points above the plane. */
static bool passes_beside(const murk_box *box, murk_vec3 a, murk_vec3 along,
                          double height_a, double height_b, double margin)
{
    const double down = height_a - height_b, length = murk_length(along);
    const murk_vec3 x = murk_along(a, height_a / down, along);
    const double far = margin * (1 + length / fabs(down));
    return x.x < box->min.x - far || x.x > box->max.x + far ||
           x.y < box->min.y - far || x.y > box->max.y + far ||
           x.z < box->min.z - far || x.z > box->max.z + far;
}

/* False if the segment from `a`, which is relative to the anchor, for certain
 * meets no sheet. */
static bool may_meet_sheets(const murk_surfaces *s, murk_vec3 a,
                            murk_vec3 along)
{
    const murk_sheet_planes *planes = &s->sheet_planes;
    const murk_vec3 b = murk_add(a, along);
    if (!planes->are_all || !murk_box_contains(&s->reach, a) ||
        !murk_box_contains(&s->reach, b)) {
        return true;
    }
    const double margin = MARGIN_UNITS * s->unit_m;
    for (size_t k = 0; k < planes->n; ++k) {
        const double height_a = planes->x[k] * a.x + planes->y[k] * a.y +
                                planes->z[k] * a.z + planes->offset[k];
        const double height_b = planes->x[k] * b.x + planes->y[k] * b.y +
                                planes->z[k] * b.z + planes->offset[k];
        const bool is_off = (height_a > margin && height_b > margin) ||
                            (height_a < -margin && height_b < -margin);
        if (!is_off && !passes_beside(&planes->box[k], a, along, height_a,
                                      height_b, margin)) {
            return true;
        }
    }
    return false;
}

double murk_surfaces_sheet_transmittance(const murk_surfaces *s, murk_vec3 from,
                                         murk_vec3 to, int band)
{
    const murk_soup *soup = &s->soup;
    if (soup->first_triangle[MURK_FACE_SHEET] == soup->triangles &&
        soup->first_sphere[MURK_FACE_SHEET] == soup->spheres) {
        return 1;
    }
    const murk_vec3 along = murk_sub(to, from);
    if (!may_meet_sheets(s, murk_sub(from, soup->anchor), along)) {
        return 1;
    }
    const double length = murk_length(along);
    const murk_vec3 direction = murk_scale(1 / length, along);
    murk_walk w;
    if (!murk_walk_begin(&w, s, from, direction, length,
                         MURK_MASK(MURK_FACE_SHEET))) {
        return 1;
    }
    /* A ray through the common edge of two triangles of one pane hits both.
     * Hits closer together than surfaces can be told apart are therefore
     * one. */
    double transmittance = 1, last = s->leave_m;
    while (transmittance > 0 && murk_walk_next(&w)) {
        const murk_primitive p = murk_primitive_of(soup, &w.ray.hit);
        murk_vec3 normal;
        const double distance = murk_walk_locate(&w, p, &normal);
        if (distance > last && distance < length - s->leave_m) {
            const uint8_t material =
                murk_soup_material(soup, murk_primitive_number(soup, p));
            transmittance *= s->material[material].transmit.band[band];
            last = distance + s->leave_m;
        }
    }
    return transmittance;
}
