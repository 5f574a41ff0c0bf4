/* Test whether two closed meshes intersect.
 *
 * Two meshes intersect if the surface of one of them has points inside and
 * points outside of the other. Such points are looked for among the first
 * corners and the centroids of the triangles, and between the places where an
 * edge passes through the other mesh. Points closer to the other surface than
 * the tolerance are touching and do not count. If two surfaces intersect, an
 * edge of one of them passes through a triangle of the other, so each mesh is
 * tested against the other. */
#include "base/sort.h"
#include "geometry/boundary_mesh.h"
#include "geometry/boundary_meshes.h"

#include "geometry/triangle.h"

#include <stdlib.h>

/* The largest number of intersections with the other mesh that are stored for
 * one edge. Further intersections are ignored, on the assumption that the
 * samples between the stored ones or on other edges lead to the same
 * decision. */
#define PLACES_MAX 64

typedef struct sampling {
    const murk_boundary_mesh *other;
    double tolerance_m;
    bool any_inside, any_outside;
    murk_vec3 place;
} sampling;

static bool is_decided(const sampling *s)
{
    return s->any_inside && s->any_outside;
}

/* Notes whether a point of the surface is inside or outside of the other mesh,
 * unless the point is on the other mesh within the tolerance. */
static void sample(sampling *s, murk_vec3 point)
{
    if (is_decided(s) ||
        murk_surfaces_near(s->other->shape, point, s->tolerance_m)) {
        return;
    }
    const bool is_inside = murk_boundary_mesh_holds(s->other, point);
    if (is_inside ? !s->any_inside : !s->any_outside) {
        s->place = point;
    }
    s->any_inside |= is_inside;
    s->any_outside |= !is_inside;
}

typedef struct places {
    size_t n;
    double at_m[PLACES_MAX];
} places;

static void note(void *context, size_t triangle, double distance_m)
{
    places *p = context;
    (void)triangle;
    if (p->n < PLACES_MAX) {
        p->at_m[p->n++] = distance_m;
    }
}

/* Samples the middles of the parts into which the other mesh divides an edge;
 * nothing if the edge does not meet the other mesh. */
static void sample_edge(sampling *s, murk_vec3 from, murk_vec3 to)
{
    const murk_vec3 edge = murk_sub(to, from);
    const double length = murk_length(edge);
    const murk_vec3 direction = murk_scale(1 / length, edge);
    places p = {.n = 0};
    murk_boundary_mesh_gather(s->other, from, direction, 0, length, note, &p);
    if (p.n == 0) {
        return;
    }
    qsort(p.at_m, p.n, sizeof *p.at_m, murk_by_double);
    double last = 0;
    for (size_t i = 0; i <= p.n; ++i) {
        const double next = i < p.n ? fmin(p.at_m[i], length) : length;
        if (next > last) {
            sample(s, murk_along(from, 0.5 * (last + next), direction));
            last = next;
        }
    }
}

static bool has_parts_on_both_sides(const murk_boundary_mesh *one,
                                    const murk_boundary_mesh *other,
                                    double tolerance_m, murk_vec3 *place)
{
    const murk_soup *soup = &one->shape->soup;
    sampling s = {.other = other, .tolerance_m = tolerance_m};
    for (size_t i = 0; i < soup->triangles && !is_decided(&s); ++i) {
        const murk_triangle t = murk_soup_placed_triangle(soup, i);
        sample(&s, t.a);
        sample(&s, murk_scale(1.0 / 3, murk_add(t.a, murk_add(t.b, t.c))));
        sample_edge(&s, t.a, t.b);
        sample_edge(&s, t.b, t.c);
        sample_edge(&s, t.c, t.a);
    }
    *place = s.place;
    return is_decided(&s);
}

bool murk_boundary_meshes_meet(const murk_boundary_meshes *b, int region,
                               int other, murk_vec3 *place)
{
    const murk_boundary_mesh *one = murk_boundary_mesh_of(b, region);
    const murk_boundary_mesh *two = murk_boundary_mesh_of(b, other);
    const murk_box box = murk_surfaces_describe(one->shape).bounds_m;
    const murk_box box2 = murk_surfaces_describe(two->shape).bounds_m;
    return murk_box_overlaps(&box, &box2) &&
           (has_parts_on_both_sides(one, two, b->tolerance_m, place) ||
            has_parts_on_both_sides(two, one, b->tolerance_m, place));
}
