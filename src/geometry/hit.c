/* Nearest intersection of a ray with the surfaces, and the start of the ray
 * that leaves a surface.
 *
 * Embree names the nearest primitive; distance and normal are computed in
 * double precision from that primitive (geometry/walk.h). In corners of opaque
 * surfaces the hit is moved back along the ray, so that the next ray starts in
 * the space that the ray came through. */
#include "geometry/triangle.h"
#include "geometry/walk.h"

/* Within EDGE_UNITS float steps of an edge, rounding may have chosen the wrong
 * one of two opaque triangles that meet there at an angle. Such a hit is moved
 * back along the ray by DRAW_BACK_UNITS float steps (at most by half of the
 * distance), into the space that the ray has passed, so that the ray which
 * leaves the hit does not start behind the neighbouring triangle. A neighbour
 * tilted by less than EDGE_SINE (14 degrees) needs no such care: the step of
 * murk_surfaces_leave() clears that neighbour. EDGE_UNITS exceeds the few float
 * steps by which Embree's hit may be off (geometry/ray_scene.h);
 * DRAW_BACK_UNITS is twice EDGE_UNITS / EDGE_SINE. Cost: in a room of ten
 * metres one hit in a million, in a corner, lies up to 1e-5 of the largest
 * coordinate before the surface. */
#define EDGE_UNITS      8
#define DRAW_BACK_UNITS 64
#define EDGE_SINE       0.25

/* More than the square of the longest edge, for the largest magnitude 1 of
 * coordinates: 12, with a margin for rounding. */
#define EDGE2_MAX 13

/* A search up to a distance goes this many float steps farther. The sum of
 * MURK_WALK_AGREE_UNITS, by which Embree's distance may exceed that of the
 * plane, and DRAW_BACK_UNITS is 128; the rest is for rounding. */
#define BEYOND_UNITS 256

/* True if Embree's hit point is within EDGE_UNITS float steps of an edge. The
 * distance to an edge is a barycentric coordinate times the height over that
 * side. */
static bool is_near_edge(const murk_walk *w, const murk_triangle *t,
                         murk_vec3 normal)
{
    const double limit = EDGE_UNITS * w->s->unit_m;
    const double limit2 = limit * limit / murk_dot(normal, normal);
    const double u = (double)w->ray.hit.u, v = (double)w->ray.hit.v;
    const double share[3] = {1 - u - v, u, v};
    const murk_vec3 side[3] = {murk_sub(t->c, t->b), murk_sub(t->a, t->c),
                               murk_sub(t->b, t->a)};
    for (int i = 0; i < 3; ++i) {
        if (share[i] * fabs(share[i]) < limit2 * murk_dot(side[i], side[i])) {
            return true;
        }
    }
    return false;
}

/* True only if is_near_edge() is false: a bound of all edges takes the place of
 * the edges, which need not be computed then. */
static bool is_clear_of_edges(const murk_walk *w, murk_vec3 normal)
{
    const double reach = w->s->soup.extent * EDGE_UNITS * w->s->unit_m;
    const double u = (double)w->ray.hit.u, v = (double)w->ray.hit.v;
    double minimum = 1 - u - v;
    minimum = u < minimum ? u : minimum;
    minimum = v < minimum ? v : minimum;
    return minimum > 0 && minimum * minimum * murk_dot(normal, normal) >
                              EDGE2_MAX * reach * reach;
}

typedef struct corner_search {
    const murk_soup *soup;
    murk_vec3 point, normal;
    double radius_m;
    bool is_corner;
} corner_search;

/* Finds a triangle of any kind of face near the point that is tilted against
 * the hit triangle. A callback of murk_ray_scene_visit(). */
static bool find_corner(void *context, murk_primitive p)
{
    corner_search *search = context;
    if (p.is_sphere) {
        return false;
    }
    const murk_triangle t = murk_soup_triangle(search->soup, p.index);
    const murk_vec3 normal = murk_triangle_normal(&t);
    const murk_vec3 tilt = murk_cross(normal, search->normal);
    search->is_corner = murk_dot(tilt, tilt) >
                            EDGE_SINE * EDGE_SINE * murk_dot(normal, normal) *
                                murk_dot(search->normal, search->normal) &&
                        murk_triangle_distance2(&t, search->point) <
                            search->radius_m * search->radius_m;
    return search->is_corner;
}

/* True if a triangle that is tilted against the hit triangle by more than
 * EDGE_SINE lies within 2 * EDGE_UNITS float steps of the point. `normal` is
 * the normal of the hit triangle. */
static bool is_in_corner(const murk_walk *w, murk_vec3 point, murk_vec3 normal)
{
    corner_search search = {.soup = &w->s->soup,
                            .point = point,
                            .normal = normal,
                            .radius_m = 2 * EDGE_UNITS * w->s->unit_m};
    murk_ray_scene_visit(w->s, point, search.radius_m, find_corner, &search);
    return search.is_corner;
}

/* The distance of the hit; if an opaque triangle was hit in a corner, less by
 * DRAW_BACK_UNITS float steps, but by half of the distance at least. */
static double drawn_back(const murk_walk *w, murk_primitive p, murk_vec3 normal,
                         double distance)
{
    const murk_soup *soup = &w->s->soup;
    if (p.is_sphere || p.index >= soup->first_triangle[MURK_FACE_SOLID] ||
        is_clear_of_edges(w, normal)) {
        return distance;
    }
    const murk_triangle t = murk_soup_triangle(soup, p.index);
    if (!is_near_edge(w, &t, normal) ||
        !is_in_corner(w, murk_along(w->origin, distance, w->direction),
                      normal)) {
        return distance;
    }
    return fmax(distance - DRAW_BACK_UNITS * w->s->unit_m, distance / 2);
}

bool murk_surfaces_hit(const murk_surfaces *s, murk_vec3 origin,
                       murk_vec3 direction, double max_m, murk_hit *hit)
{
    return murk_surfaces_hit_near(s, origin, direction, max_m, INFINITY, hit);
}

bool murk_surfaces_hit_near(const murk_surfaces *s, murk_vec3 origin,
                            murk_vec3 direction, double max_m, double near_m,
                            murk_hit *hit)
{
    const double beyond_m = near_m + BEYOND_UNITS * s->unit_m;
    max_m = max_m > beyond_m ? beyond_m : max_m;
    murk_walk w;
    if (!murk_walk_begin(&w, s, origin, direction, max_m, MURK_MASK_ALL)) {
        return false;
    }
    /* Skip candidates that lie behind the true origin: Embree's ray starts
     * slightly before the true origin. */
    murk_vec3 normal;
    murk_primitive p;
    double distance;
    do {
        if (!murk_walk_next(&w)) {
            return false;
        }
        p = murk_primitive_of(&s->soup, &w.ray.hit);
        distance = murk_walk_locate(&w, p, &normal);
    } while (!(distance > 0));
    /* The distance in double precision decides whether the hit is within
     * range. */
    if (!(distance <= max_m)) {
        return false;
    }
    /* The reported normal points against the ray. */
    const double side = murk_dot(normal, direction) > 0 ? -1 : 1;
    const double scale = p.is_sphere ? 1 / murk_length(normal)
                                     : s->soup.plane[p.index].inverse_length;
    const size_t number = murk_primitive_number(&s->soup, p);
    *hit = (murk_hit){.distance_m = drawn_back(&w, p, normal, distance),
                      .normal = murk_scale(side * scale, normal),
                      .triangle = (uint32_t)number,
                      .material = murk_soup_material(&s->soup, number),
                      .solid = murk_soup_solid(&s->soup, number)};
    return true;
}

murk_vec3 murk_surfaces_leave(const murk_surfaces *s, murk_vec3 point,
                              murk_vec3 normal)
{
    return murk_along(point, s->leave_m, normal);
}

double murk_surfaces_leave_step_m(const murk_surfaces *s)
{
    return s->leave_m;
}
