/* Distance between a mounted sensor and surfaces, without the surface that
 * carries the sensor.
 *
 * That surface is recognised by place and not by connectivity, because meshes
 * have seams and T-junctions: everything behind the plane of the site or less
 * than above_m over that plane belongs to the surface, and so does a face that
 * is tilted by less than 45 degrees and rises no steeper than it is tilted, as
 * a smoothly curved wall does. The sphere on which the site lies belongs to the
 * surface as a whole. */
#include "geometry/mount_clearance.h"

#include "geometry/polygon.h"

#define OWN_COSINE                                                          \
    0.70710678118654752 /* cosine of 45 degrees: the largest tilt of a face \
                           that continues a curved wall */

static murk_vec3 nearest_on_segment(murk_vec3 a, murk_vec3 b, murk_vec3 p)
{
    const murk_vec3 ab = murk_sub(b, a);
    const double length2 = murk_dot(ab, ab);
    const double share =
        length2 > 0 ? murk_dot(murk_sub(p, a), ab) / length2 : 0;
    return murk_along(a, fmin(1, fmax(0, share)), ab);
}

/* The point of a convex polygon that is nearest to p. `normal`, of any length,
 * is the normal of the polygon by its winding. */
static murk_vec3 nearest_on(const murk_polygon *polygon, murk_vec3 normal,
                            murk_vec3 p)
{
    murk_vec3 nearest = {INFINITY, INFINITY, INFINITY};
    double min = INFINITY;
    bool projects_inside = true;
    for (size_t i = 0; i < polygon->n; ++i) {
        const murk_vec3 a = polygon->corner[i],
                        b = polygon->corner[(i + 1) % polygon->n];
        projects_inside &=
            murk_dot(murk_cross(murk_sub(b, a), murk_sub(p, a)), normal) >= 0;
        const murk_vec3 here = nearest_on_segment(a, b, p);
        const double distance = murk_length(murk_sub(here, p));
        if (distance < min) {
            min = distance;
            nearest = here;
        }
    }
    if (!projects_inside) {
        return nearest;
    }
    const double height = murk_dot(murk_sub(p, polygon->corner[0]), normal) /
                          murk_dot(normal, normal);
    return murk_along(p, -height, normal);
}

/* True if the face may continue a smooth surface: along the way from the site
 * to `place` the slope of such a surface changes from 0 to that of the face, so
 * the rise is at most slope times length. False for a face tilted by 45 degrees
 * or more. */
static bool goes_on_to(const murk_mount_clearance *m, murk_vec3 normal,
                       murk_vec3 place)
{
    const double cosine = fabs(murk_dot(m->normal, murk_unit(normal)));
    const double slope = sqrt(fmax(0, 1 - cosine * cosine)) / cosine;
    const murk_vec3 off = murk_sub(place, m->site);
    const double rise = murk_dot(off, m->normal);
    const double along = murk_length(murk_along(off, -rise, m->normal));
    return cosine > OWN_COSINE && rise <= slope * along + m->slack_m;
}

double murk_mount_clearance_to_face(const murk_mount_clearance *m,
                                    const murk_triangle *face, murk_vec3 point)
{
    const double floor_m = murk_dot(m->normal, m->site) + m->above_m;
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

double murk_mount_clearance_to_sphere(const murk_mount_clearance *m,
                                      const murk_stored_sphere *b,
                                      murk_vec3 point)
{
    const murk_vec3 off = murk_sub(m->site, b->center);
    if (fabs(murk_length(off) - b->radius) <= m->slack_m) {
        return INFINITY;
    }
    const murk_vec3 from = murk_sub(point, b->center);
    const double distance = murk_length(from);
    /* Heights are measured from the centre of the sphere along the normal of
     * the site. */
    const double floor_m = murk_dot(off, m->normal) + m->above_m;
    const double height = murk_dot(from, m->normal);
    if (!(floor_m < b->radius)) {
        return INFINITY;
    }
    if (distance > 0 && b->radius * height / distance >= floor_m) {
        return fabs(distance - b->radius);
    }
    /* Only the part of the sphere above floor_m counts. The nearest point of
     * the whole sphere is below floor_m here, so the nearest point of that part
     * is on the circle at height floor_m. A point at the center of the sphere
     * gets here, too: if the whole sphere is above floor_m, the distance is the
     * radius. */
    const double aside = sqrt(fmax(0, distance * distance - height * height));
    const double circle =
        sqrt(fmax(0, b->radius * b->radius - floor_m * floor_m));
    return floor_m <= -b->radius ? fabs(distance - b->radius)
                                 : hypot(aside - circle, height - floor_m);
}
