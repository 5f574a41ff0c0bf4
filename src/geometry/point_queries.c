/* Questions about a single point: which solid encloses the point, and whether a
 * surface is near.
 *
 * The enclosing solid is found by casting rays and counting crossings (odd:
 * inside). Two directions that agree decide. If they do not agree, the second
 * counts if a third direction agrees with it, else the first. Nearness is
 * Embree's point query, with exact distances in double precision. */
#include "geometry/mount_clearance.h"
#include "geometry/triangle.h"
#include "geometry/walk.h"

/* Solids that a ray may be inside of at the same time. More would need 64
 * nested solids; those beyond are ignored. */
#define OPEN_SOLIDS_MAX 64

/* Removes the solid from the list if it is there, otherwise appends it.
 * Returns the new length. */
static size_t toggle(uint16_t *open, size_t n, uint16_t solid)
{
    for (size_t i = 0; i < n; ++i) {
        if (open[i] == solid) {
            for (--n; i < n; ++i) {
                open[i] = open[i + 1];
            }
            return n;
        }
    }
    if (n < OPEN_SOLIDS_MAX) {
        open[n++] = solid;
    }
    return n;
}

/* The innermost solid around `point`, found along one direction: solids
 * crossed an odd number of times enclose the point, and the first of them
 * crossed is the innermost. */
static uint16_t solid_along(const murk_surfaces *s, murk_vec3 point,
                            murk_vec3 direction)
{
    uint16_t open[OPEN_SOLIDS_MAX];
    size_t n = 0;
    murk_walk w;
    if (!murk_walk_begin(&w, s, point, direction, INFINITY,
                         MURK_MASK(MURK_FACE_SOLID))) {
        return 0;
    }
    while (murk_walk_next(&w)) {
        const murk_primitive p = murk_primitive_of(&s->soup, &w.ray.hit);
        murk_vec3 normal;
        if (murk_walk_locate(&w, p, &normal) > 0) {
            n = toggle(
                open, n,
                murk_soup_solid(&s->soup, murk_primitive_number(&s->soup, p)));
        }
    }
    return n > 0 ? open[0] : 0;
}

uint16_t murk_surfaces_solid_at(const murk_surfaces *s, murk_vec3 point)
{
    if (s->soup.solids == 0) {
        return 0;
    }
    /* Three irregular directions: a modelled edge is unlikely to be parallel
     * to one of them. If a ray hits an edge and counts a crossing twice, the
     * other two directions outvote it. */
    const uint16_t a =
        solid_along(s, point, murk_unit(murk_vec(0.53, 0.31, 0.79)));
    const uint16_t b =
        solid_along(s, point, murk_unit(murk_vec(-0.37, 0.83, 0.41)));
    if (a == b) {
        return a;
    }
    const uint16_t c =
        solid_along(s, point, murk_unit(murk_vec(0.71, -0.43, -0.57)));
    return c == b ? b : a;
}

typedef struct nearness {
    const murk_surfaces *s;
    murk_vec3 point;
    double radius_m;
    const murk_mount_clearance *clearance; /* NULL: every surface counts */
    bool is_near;
} nearness;

/* Tests by the exact distance whether a primitive is nearer than the radius; if
 * so, ends the visit. A callback of murk_ray_scene_visit(). */
static bool visit_near(void *context, murk_primitive p)
{
    nearness *near = context;
    const murk_soup *soup = &near->s->soup;
    double distance;
    if (p.is_sphere) {
        const murk_stored_sphere *b = &soup->sphere[p.index];
        distance = near->clearance
                       ? murk_mount_clearance_to_sphere(near->clearance, b,
                                                        near->point)
                       : fabs(murk_length(murk_sub(near->point, b->center)) -
                              b->radius);
    } else {
        const murk_triangle t = murk_soup_triangle(soup, p.index);
        distance =
            near->clearance
                ? murk_mount_clearance_to_face(near->clearance, &t, near->point)
                : sqrt(murk_triangle_distance2(&t, near->point));
    }
    near->is_near = distance < near->radius_m;
    return near->is_near;
}

static bool any_near(const murk_surfaces *s, murk_vec3 point, double radius_m,
                     const murk_mount_clearance *clearance)
{
    if (!s->scene || !(radius_m > 0) ||
        !murk_ray_is_sound(point, murk_vec(0, 0, 1))) {
        return false;
    }
    nearness near = {.s = s,
                     .point = murk_sub(point, s->soup.anchor),
                     .radius_m = radius_m,
                     .clearance = clearance};
    murk_ray_scene_visit(s, near.point, fmin(radius_m, MURK_RAY_MAX_M),
                         visit_near, &near);
    return near.is_near;
}

bool murk_surfaces_near(const murk_surfaces *s, murk_vec3 point,
                        double radius_m)
{
    return any_near(s, point, radius_m, NULL);
}

bool murk_surfaces_near_mount(const murk_surfaces *s, murk_vec3 point,
                              double radius_m, const murk_mount_site *site,
                              double above_m)
{
    const murk_mount_clearance clearance = {
        .site = murk_sub(site->position, s->soup.anchor),
        .normal = site->normal,
        .above_m = above_m,
        .slack_m = 2 * s->leave_m};
    return any_near(s, point, radius_m, &clearance);
}
