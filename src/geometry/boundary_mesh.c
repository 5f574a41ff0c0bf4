/* Intersections of a ray with one closed mesh: at which distances the ray
 * enters and leaves the mesh, and whether a point is inside.
 *
 * A triangle that the ray hits well inside its edges decides by the side of the
 * triangle whether the ray enters or leaves. Near an edge, rounding may report
 * a neighbouring triangle in addition or miss one. Therefore all hits within a
 * tolerance are treated as one cluster. If the hits of a cluster disagree, are
 * near an edge, or contradict the state the caller believed in, the state is
 * decided by testing points before and beyond the cluster. A point outside of
 * the bounding box of the mesh is outside. For any other point the test casts
 * rays in up to five directions. The first ray that hits nothing (outside) or
 * whose nearest cluster is certain decides; without such a ray, or for a mesh
 * without known sides, the majority of the five decides by the number of
 * crossings (odd: inside). */
#include "geometry/boundary_mesh.h"

#include "geometry/triangle.h"

/* A hit farther than this from every edge is certain, in float steps: some
 * four times the error of a ray in single precision (geometry/ray_scene.h). */
#define EDGE_UNITS 16

/* Number of directions that are tried from a point. The number is odd, so that
 * the majority has no tie. */
#define DIRECTIONS 5

typedef struct gathering {
    murk_ray_context context; /* the first member: Embree passes the address of
                               * the context to the filter */
    const murk_boundary_mesh *boundary_mesh;
    murk_walk walk;
    double from_m;
    murk_meet meet;
    void *receiver;
} gathering;

/* Embree's filter: reports the triangle, unless the triangle is a copy, and
 * rejects the hit, so that Embree continues along the ray. */
static void tell(const struct RTCFilterFunctionNArguments *args)
{
    gathering *g = (gathering *)(void *)args->context;
    const struct RTCHit *hit = (const struct RTCHit *)(const void *)args->hit;
    const struct RTCRay *ray = (const struct RTCRay *)(const void *)args->ray;
    const murk_primitive p =
        murk_primitive_of(&g->boundary_mesh->shape->soup, hit);
    args->valid[0] = 0;
    if (p.is_sphere || g->boundary_mesh->is_copy[p.index]) {
        return;
    }
    murk_vec3 normal;
    g->walk.ray.ray.tfar = ray->tfar;
    const double distance = murk_walk_locate(&g->walk, p, &normal);
    g->meet(g->receiver, p.index, g->from_m + distance);
}

void murk_boundary_mesh_gather(const murk_boundary_mesh *b, murk_vec3 origin,
                               murk_vec3 direction, double from_m, double to_m,
                               murk_meet meet, void *context)
{
    gathering g = {.boundary_mesh = b,
                   .from_m = from_m,
                   .meet = meet,
                   .receiver = context};
    if (murk_walk_begin(&g.walk, b->shape,
                        murk_along(origin, from_m, direction), direction,
                        to_m - from_m, MURK_MASK_ALL)) {
        g.context = g.walk.context;
        struct RTCRay ray = g.walk.ray.ray;
        murk_embree_occluded(b->shape->scene, &g.context.embree, &ray, tell);
    }
}

/* ---- inside by counting crossings ---- */

typedef struct parity {
    double beyond_m;
    bool is_odd;
} parity;

static void add_one(void *context, size_t triangle, double distance_m)
{
    parity *p = context;
    (void)triangle;
    p->is_odd ^= distance_m > p->beyond_m;
}

bool murk_boundary_mesh_is_odd(const murk_boundary_mesh *b, murk_vec3 point,
                               murk_vec3 direction, double beyond_m)
{
    parity p = {.beyond_m = beyond_m};
    murk_boundary_mesh_gather(b, point, direction, 0, INFINITY, add_one, &p);
    return p.is_odd;
}

/* ---- inside by the sides of the triangles ---- */

/* All hits of a ray beyond after_m and up to to_m, which is the distance of the
 * first hit plus the tolerance. */
typedef struct cluster {
    const murk_boundary_mesh *boundary_mesh;
    murk_vec3 origin, direction;
    double after_m, to_m, nearest_m;
    size_t nearest;
    bool enters, leaves;
    bool is_near_edge; /* rounding may have added or lost a neighbouring
                          triangle */
} cluster;

static bool is_near_edge(const cluster *c, const murk_triangle *t,
                         murk_vec3 normal, double distance_m)
{
    const murk_surfaces *s = c->boundary_mesh->shape;
    const murk_vec3 p = murk_sub(
        murk_along(c->origin, distance_m, c->direction), s->soup.anchor);
    const murk_vec3 corner[3] = {t->a, t->b, t->c};
    /* The error of a slanting ray, measured in the plane of the triangle,
     * grows by 1 / cosine of the angle of incidence. */
    const double limit = EDGE_UNITS * s->unit_m * murk_dot(normal, normal) /
                         fabs(murk_dot(normal, c->direction));
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 side = murk_sub(corner[(i + 1) % 3], corner[i]);
        const double off =
            murk_dot(murk_cross(side, murk_sub(p, corner[i])), normal);
        if (!(off > limit * murk_length(side))) {
            return true;
        }
    }
    return false;
}

static void take_in(void *context, size_t triangle, double distance_m)
{
    cluster *c = context;
    const murk_boundary_mesh *b = c->boundary_mesh;
    if (!(distance_m > c->after_m && distance_m <= c->to_m)) {
        return;
    }
    if (b->is_inward) {
        const murk_triangle t = murk_soup_triangle(&b->shape->soup, triangle);
        const murk_vec3 normal = murk_triangle_normal(&t);
        const bool enters =
            b->is_inward[triangle] == (murk_dot(normal, c->direction) > 0);
        c->enters |= enters;
        c->leaves |= !enters;
        c->is_near_edge |= is_near_edge(c, &t, normal, distance_m);
    }
    /* Of equally near triangles the one with the lower number counts, so
     * that the result does not depend on Embree's order. */
    if (distance_m < c->nearest_m ||
        (distance_m == c->nearest_m && triangle < c->nearest)) {
        c->nearest_m = distance_m;
        c->nearest = triangle;
    }
}

/* Distance of the first triangle beyond from_m; INFINITY if there is none up
 * to max_m. */
static double first_met(const murk_boundary_mesh *b, murk_vec3 origin,
                        murk_vec3 direction, double from_m, double max_m,
                        size_t *triangle)
{
    murk_walk w;
    if (!murk_walk_begin(&w, b->shape, murk_along(origin, from_m, direction),
                         direction, max_m - from_m, MURK_MASK_ALL)) {
        return INFINITY;
    }
    while (murk_walk_next(&w)) {
        murk_vec3 normal;
        const murk_primitive p = murk_primitive_of(&b->shape->soup, &w.ray.hit);
        const double distance = murk_walk_locate(&w, p, &normal);
        if (distance > 0) {
            *triangle = p.index;
            return from_m + distance <= max_m ? from_m + distance : INFINITY;
        }
    }
    return INFINITY;
}

/* Collects the first cluster of hits beyond from_m. False if there is no hit
 * up to max_m. */
static bool first_cluster(const murk_boundary_mesh *b, murk_vec3 origin,
                          murk_vec3 direction, double from_m, double max_m,
                          double tolerance_m, cluster *out)
{
    size_t first;
    const double at = first_met(b, origin, direction, from_m, max_m, &first);
    if (!(at < INFINITY)) {
        return false;
    }
    *out = (cluster){.boundary_mesh = b,
                     .origin = origin,
                     .direction = direction,
                     .after_m = from_m,
                     .to_m = at + tolerance_m,
                     .nearest_m = INFINITY};
    take_in(out, first, at);
    murk_boundary_mesh_gather(b, origin, direction,
                              fmax(from_m, at - tolerance_m), out->to_m,
                              take_in, out);
    return true;
}

bool murk_boundary_mesh_holds(const murk_boundary_mesh *b, murk_vec3 point)
{
    /* Irregular directions: a modelled edge is unlikely to be parallel to
     * one of them. They were chosen freely; any such set gives the same
     * answers away from edges. */
    static const murk_vec3 direction[DIRECTIONS] = {{0.53, 0.31, 0.79},
                                                    {-0.37, 0.83, 0.41},
                                                    {0.71, -0.43, -0.57},
                                                    {-0.61, -0.29, 0.73},
                                                    {0.23, 0.59, -0.77}};
    if (!murk_box_contains(&b->shape->reach,
                           murk_sub(point, b->shape->soup.anchor))) {
        return false;
    }
    /* A ray without a hit decides, and so do the sides of a certain cluster;
     * otherwise the direction votes by the number of crossings. */
    int votes = 0;
    for (int i = 0; i < DIRECTIONS; ++i) {
        const murk_vec3 d = murk_unit(direction[i]);
        cluster c;
        if (b->is_inward) {
            if (!first_cluster(b, point, d, 0, INFINITY, b->shape->leave_m,
                               &c)) {
                return false;
            }
            if (c.enters != c.leaves && !c.is_near_edge) {
                return c.leaves;
            }
        }
        votes += murk_boundary_mesh_is_odd(b, point, d, 0) ? 1 : -1;
    }
    return votes > 0;
}

/* True if the middle of the segment between the two distances is inside the
 * mesh. The middle is farthest from both ends, so rounding matters least there.
 * False if to_m is INFINITY: beyond the last hit the ray is outside. */
static bool holds_between(const cluster *c, double from_m, double to_m)
{
    return to_m < INFINITY &&
           murk_boundary_mesh_holds(
               c->boundary_mesh,
               murk_along(c->origin, 0.5 * (from_m + to_m), c->direction));
}

/* Decides whether the ray is inside the mesh before and after a cluster: from
 * the sides of the triangles if the cluster is certain and agrees with *before,
 * otherwise by testing points on both sides of the cluster. *before is not
 * tested again if the cluster begins within the tolerance of from_m. */
static void judge(const murk_boundary_mesh *b, const cluster *c, double from_m,
                  double tolerance_m, bool *before, bool *after)
{
    const bool is_plain =
        b->is_inward && c->enters != c->leaves && !c->is_near_edge;
    if (is_plain && *before == c->leaves) {
        *after = c->enters;
        return;
    }
    if (c->nearest_m - from_m > tolerance_m) {
        *before = holds_between(c, from_m, c->nearest_m);
    }
    size_t next;
    *after = holds_between(
        c, c->to_m,
        first_met(b, c->origin, c->direction, c->to_m, INFINITY, &next));
}

bool murk_boundary_mesh_next(const murk_boundary_mesh *b, murk_vec3 origin,
                             murk_vec3 direction, double from_m, double max_m,
                             double tolerance_m, bool *inside,
                             double *distance_m, murk_vec3 *normal)
{
    cluster c;
    for (; first_cluster(b, origin, direction, from_m, max_m, tolerance_m, &c);
         from_m = c.to_m) {
        bool after;
        judge(b, &c, from_m, tolerance_m, inside, &after);
        if (after != *inside) {
            const murk_triangle t =
                murk_soup_triangle(&b->shape->soup, c.nearest);
            const murk_vec3 n = murk_triangle_normal(&t);
            const double side = murk_dot(n, direction) > 0 ? -1 : 1;
            *distance_m = c.nearest_m;
            *normal = murk_scale(side / murk_length(n), n);
            return true;
        }
    }
    return false;
}
