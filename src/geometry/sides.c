/* Finds the outer side of each triangle of a closed mesh.
 *
 * Patches of neighbouring triangles are oriented to one side each
 * (geometry/closed.h). Three rays from the largest triangle of a patch then
 * tell by majority whether that side is outside: the number of crossings ahead
 * is even. The answer holds for the whole patch only if the mesh does not cross
 * itself, so all edges are first tested against all triangles. */
#include "base/log.h"
#include "base/position.h"
#include "geometry/boundary_mesh.h"
#include "geometry/placed_shapes.h"
#include "geometry/triangle.h"

#include <stdlib.h>
#include <string.h>

/* Hits closer to a ray's start than this, in float steps
 * (geometry/ray_scene.h), are the triangle on which the ray starts; above the
 * error of Embree's distance. */
#define OWN_UNITS 4

/* ---- self-intersection ---- */

typedef struct piercing {
    const murk_soup *soup;
    const uint32_t *same;
    murk_vec3 from, to;
    uint32_t ends[2]; /* the end vertices of the edge, after merging */
    bool is_pierced;
} piercing;

/* Notes whether an edge passes through a triangle that does not share a vertex
 * with the edge: the ends of the edge are then on different sides of the
 * triangle. */
static void find_piercing(void *context, size_t triangle, double distance_m)
{
    piercing *p = context;
    const uint32_t *corner = p->soup->corner + 3 * triangle;
    (void)distance_m;
    for (int i = 0; i < 3; ++i) {
        const uint32_t v = p->same[corner[i]];
        if (v == p->ends[0] || v == p->ends[1]) {
            return;
        }
    }
    const murk_triangle t = murk_soup_triangle(p->soup, triangle);
    const murk_vec3 normal = murk_triangle_normal(&t);
    p->is_pierced |= murk_dot(murk_sub(p->from, t.a), normal) *
                         murk_dot(murk_sub(p->to, t.a), normal) <
                     0;
}

/* Counts edges that pass through triangles of the same mesh; *first is the
 * middle of the first such edge. Each edge belongs to two triangles and is
 * found twice, so halves are counted. */
static void count_crossings(murk_boundary_mesh *b, const uint32_t *same,
                            murk_vec3 *first)
{
    const murk_soup *soup = &b->shape->soup;
    size_t halves = 0;
    for (size_t i = 0; i < soup->triangles; ++i) {
        for (size_t k = 0; k < 3 && !b->is_copy[i]; ++k) {
            const uint32_t from = soup->corner[3 * i + k];
            const uint32_t to = soup->corner[3 * i + (k + 1) % 3];
            /* Trace a ray along the edge and test each triangle that the ray
             * meets. */
            piercing p = {.soup = soup,
                          .same = same,
                          .from = murk_vertex(soup->vertex, from),
                          .to = murk_vertex(soup->vertex, to),
                          .ends = {same[from], same[to]}};
            const murk_vec3 edge = murk_sub(p.to, p.from);
            const double length = murk_length(edge);
            murk_boundary_mesh_gather(b, murk_add(p.from, soup->anchor),
                                      murk_scale(1 / length, edge), 0, length,
                                      find_piercing, &p);
            if (p.is_pierced && halves++ == 0) {
                *first = murk_add(murk_along(p.from, 0.5, edge), soup->anchor);
            }
        }
    }
    b->crossings = (halves + 1) / 2;
}

/* ---- outer sides ---- */

/* True if the winding's normal of a triangle points into the mesh: the
 * majority of three rays that start on that side, in irregular directions
 * that are unlikely to hit an edge. */
static bool points_inside(const murk_boundary_mesh *b, size_t triangle)
{
    const double tilt[3][2] = {{0.31, 0.17}, {-0.23, 0.29}, {0.13, -0.37}};
    const murk_soup *soup = &b->shape->soup;
    const murk_triangle t = murk_soup_triangle(soup, triangle);
    const murk_vec3 middle =
        murk_scale(1.0 / 3, murk_add(t.a, murk_add(t.b, t.c)));
    const murk_vec3 normal = murk_unit(murk_triangle_normal(&t));
    murk_vec3 side, other;
    murk_frame(normal, &side, &other);
    int odd = 0;
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 d = murk_unit(murk_along(
            murk_along(normal, tilt[i][0], side), tilt[i][1], other));
        odd += murk_boundary_mesh_is_odd(b, murk_add(middle, soup->anchor), d,
                                         OWN_UNITS * b->shape->unit_m);
    }
    return odd >= 2;
}

static murk_status learn_sides(murk_boundary_mesh *b, const murk_patches *p,
                               const char *where, murk_error *err)
{
    const murk_soup *soup = &b->shape->soup;
    murk_status status = MURK_OK;
    uint32_t *largest = malloc((p->patches + 1) * sizeof *largest);
    double *area = calloc(p->patches + 1, sizeof *area);
    bool *is_inward = malloc(soup->triangles + 1);
    if (!largest || !area || !is_inward) {
        status = murk_no_memory(err, where, "for the sides of %zu triangles",
                                soup->triangles);
        goto done;
    }
    /* The largest triangle of each patch, where rounding matters least. */
    for (size_t i = 0; i < soup->triangles; ++i) {
        const murk_triangle t = murk_soup_triangle(soup, i);
        const double own = murk_triangle_area(&t);
        if (own > area[p->patch[i]]) {
            area[p->patch[i]] = own;
            largest[p->patch[i]] = (uint32_t)i;
        }
    }
    for (size_t k = 0; k < p->patches; ++k) {
        const uint32_t i = largest[k];
        /* The orientation of the patch, stored at its largest triangle. */
        is_inward[i] = points_inside(b, i) != p->is_turned[i];
    }
    for (size_t k = 0; k < p->patches; ++k) {
        area[k] = is_inward[largest[k]] ? 1 : 0;
    }
    for (size_t i = 0; i < soup->triangles; ++i) {
        is_inward[i] = (area[p->patch[i]] > 0) != p->is_turned[i];
    }
    b->is_inward = is_inward;
    is_inward = NULL;
done:
    free(is_inward);
    free(area);
    free(largest);
    return status;
}

murk_status murk_boundary_mesh_find_sides(murk_boundary_mesh *b,
                                          const char *where, murk_error *err)
{
    const murk_soup *soup = &b->shape->soup;
    murk_patches p;
    murk_status status = murk_patches_find(&p, soup->vertex, soup->vertices,
                                           soup->corner, soup->triangles, err);
    if (status) {
        goto done;
    }
    /* An open mesh bounds nothing. */
    if (p.open_edges > 0) {
        status = murk_fail(
            err, MURK_BAD_VALUE, where,
            "the mesh is open: %zu of its edges belong to an odd number of "
            "its %zu triangles, must be 0 open edges to bound a region",
            p.open_edges, soup->triangles);
        goto done;
    }
    /* Repeated triangles do not count; the copies are known before rays are
     * traced. */
    b->is_copy = p.is_copy;
    p.is_copy = NULL;
    murk_vec3 first = {0, 0, 0};
    /* For a mesh that crosses itself or is one-sided is_inward stays NULL. */
    count_crossings(b, p.same, &first);
    if (b->crossings > 0) {
        murk_warn(where,
                  "the mesh crosses itself: %zu of its edges pass through its "
                  "triangles, the first near %s m; where parts of it overlap, "
                  "twice inside counts as outside",
                  b->crossings, murk_position_show(first).text);
    }
    if (b->crossings == 0 && p.are_orientable) {
        status = learn_sides(b, &p, where, err);
    }
done:
    murk_patches_release(&p);
    return status;
}
