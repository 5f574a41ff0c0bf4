/* Closed parts and orientable patches of a triangle mesh.
 *
 * Vertices at equal coordinates are merged by sorting. All edges are sorted, so
 * that the triangles around one edge are neighbours in the list, and a
 * union-find structure joins them (Tarjan, J. ACM 22 (1975) 215,
 * doi:10.1145/321879.321884). For patches the union-find also stores whether
 * the winding of a triangle is opposite to that of the parent of the
 * triangle. */
#include "geometry/closed.h"

#include "base/sort.h"

#include <stdlib.h>

/* A vertex position, to be sorted. */
typedef struct place {
    float x, y, z;
    uint32_t vertex;
} place;

/* One edge of one triangle: both end vertices in rising order, the third
 * vertex of the triangle, and the triangle. */
typedef struct edge {
    uint32_t low, high, opposite, triangle;
} edge;

static int order_places(const void *left, const void *right)
{
    const place *a = left, *b = right;
    const int by_x = MURK_ORDER(a->x, b->x), by_y = MURK_ORDER(a->y, b->y);
    return by_x ? by_x : by_y ? by_y : MURK_ORDER(a->z, b->z);
}

static int order_edges(const void *left, const void *right)
{
    const edge *a = left, *b = right;
    const int by_low = MURK_ORDER(a->low, b->low);
    const int by_high = MURK_ORDER(a->high, b->high);
    const int by_opposite = MURK_ORDER(a->opposite, b->opposite);
    return by_low        ? by_low
           : by_high     ? by_high
           : by_opposite ? by_opposite
                         : MURK_ORDER(a->triangle, b->triangle);
}

/* Sets same[v] to one representative of all vertices with the coordinates of
 * v. */
static bool weld(uint32_t *same, const float *vertex, size_t vertices)
{
    place *places = malloc((vertices ? vertices : 1) * sizeof *places);
    if (!places) {
        return false;
    }
    for (size_t i = 0; i < vertices; ++i) {
        const float *v = vertex + 3 * i;
        places[i] = (place){v[0], v[1], v[2], (uint32_t)i};
    }
    qsort(places, vertices, sizeof *places, order_places);
    size_t first = 0;
    for (size_t i = 0; i < vertices; ++i) {
        if (order_places(&places[first], &places[i]) != 0) {
            first = i;
        }
        same[places[i].vertex] = places[first].vertex;
    }
    free(places);
    return true;
}

/* Lists the edges of all triangles, sorted by end vertices, then by the
 * opposite vertex: the copies of a triangle are adjacent. */
static void list_edges(edge *edges, const uint32_t *corner,
                       const uint32_t *same, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = same[corner[3 * i + k]];
            const uint32_t b = same[corner[3 * i + (k + 1) % 3]];
            const uint32_t c = same[corner[3 * i + (k + 2) % 3]];
            edges[3 * i + k] =
                (edge){a < b ? a : b, a < b ? b : a, c, (uint32_t)i};
        }
    }
    qsort(edges, 3 * n, sizeof *edges, order_edges);
}

/* The vertices and edges of a mesh, and a union-find of the triangles, in which
 * each triangle stores whether the winding is opposite to that of the parent.
 */
typedef struct topology {
    uint32_t *same;   /* [vertices] representative of the vertices at a place */
    edge *edges;      /* [3 * triangles] sorted */
    uint32_t *parent; /* [triangles] */
    bool *against;    /* [triangles] winding opposite to the parent's */
} topology;

/* Each triangle starts as a set of its own. False when out of memory; call
 * topology_release() also then. */
static bool topology_init(topology *t, const float *vertex, size_t vertices,
                          const uint32_t *corner, size_t n)
{
    *t = (topology){.same = malloc((vertices + 1) * sizeof *t->same),
                    .edges = malloc((3 * n + 1) * sizeof *t->edges),
                    .parent = malloc((n + 1) * sizeof *t->parent),
                    .against = calloc(n + 1, sizeof *t->against)};
    if (!t->same || !t->edges || !t->parent || !t->against ||
        !weld(t->same, vertex, vertices)) {
        return false;
    }
    for (size_t i = 0; i < n; ++i) {
        t->parent[i] = (uint32_t)i;
    }
    list_edges(t->edges, corner, t->same, n);
    return true;
}

static void topology_release(topology *t)
{
    free(t->same);
    free(t->edges);
    free(t->parent);
    free(t->against);
}

/* Representative of a set, the lowest triangle; *turned: the winding of i is
 * opposite to that of the representative. */
static uint32_t root(const topology *t, uint32_t i, bool *turned)
{
    *turned = false;
    while (t->parent[i] != i) {
        const uint32_t up = t->parent[i];
        /* Path halving: two steps become one and their reversals add up. The
         * entry of a root is false. */
        t->against[i] ^= t->against[up];
        t->parent[i] = t->parent[up];
        *turned ^= t->against[i];
        i = t->parent[i];
    }
    return i;
}

/* Joins the sets of two triangles, whose windings are opposite if `turned` is
 * true. False if both are in one set already and their windings there
 * contradict `turned`. */
static bool join(const topology *t, uint32_t a, uint32_t b, bool turned)
{
    bool turned_a, turned_b;
    const uint32_t i = root(t, a, &turned_a), j = root(t, b, &turned_b);
    const bool between = turned ^ turned_a ^ turned_b;
    if (i == j) {
        return !between;
    }
    t->parent[i > j ? i : j] = i > j ? j : i;
    t->against[i > j ? i : j] = between;
    return true;
}

static bool is_same_edge(const edge *a, const edge *b)
{
    return a->low == b->low && a->high == b->high;
}

murk_status murk_closed_parts(const float *vertex, size_t vertices,
                              const uint32_t *corner, size_t n, bool *is_closed,
                              murk_error *err)
{
    topology t;
    bool turned;
    bool *odd = calloc(n + 1, sizeof *odd);
    murk_status status = MURK_OK;
    if (!topology_init(&t, vertex, vertices, corner, n) || !odd) {
        status = murk_no_memory(err, "geometry",
                                "to look for closed parts of %zu triangles", n);
        goto done;
    }
    /* Join the triangles around each edge, and mark one triangle of each edge
     * with an odd number of triangles. An even number closes the surface, also
     * if four triangles meet at the edge. Copies of a triangle do not count. */
    for (size_t i = 0, first = 0, around = 0; i < 3 * n; ++i) {
        const edge *e = &t.edges[i];
        if (!is_same_edge(e, &t.edges[first])) {
            first = i;
            around = 0;
        }
        around += i == first || e->opposite != t.edges[i - 1].opposite;
        join(&t, t.edges[first].triangle, e->triangle, false);
        if (i + 1 == 3 * n || !is_same_edge(e, e + 1)) {
            odd[t.edges[first].triangle] |= around % 2 == 1;
        }
    }
    /* One odd edge makes the whole part open. */
    for (size_t i = 0; i < n; ++i) {
        is_closed[i] = true;
    }
    for (size_t i = 0; i < n; ++i) {
        if (odd[i]) {
            is_closed[root(&t, (uint32_t)i, &turned)] = false;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        is_closed[i] = is_closed[root(&t, (uint32_t)i, &turned)];
    }
done:
    topology_release(&t);
    free(odd);
    return status;
}

/* ---- patches ---- */

/* True if the winding of the triangle runs along the edge from the low to
 * the high vertex. */
static bool rises(const edge *e, const uint32_t *corner, const uint32_t *same)
{
    const uint32_t *c = corner + 3 * (size_t)e->triangle;
    for (size_t k = 0; k < 3; ++k) {
        if (same[c[k]] == e->low && same[c[(k + 1) % 3]] == e->high) {
            return true;
        }
    }
    return false;
}

/* Joins the patches of two triangles at an edge. Neighbours have the same
 * orientation if their windings run along the edge in opposite directions;
 * copies of one triangle if the windings run in the same direction. */
static void unite(murk_patches *p, const topology *t, const edge *a,
                  const edge *b, bool are_copies, const uint32_t *corner)
{
    const bool same_direction =
        rises(a, corner, t->same) == rises(b, corner, t->same);
    p->are_orientable &=
        join(t, a->triangle, b->triangle, same_direction != are_copies);
}

static void join_patches(murk_patches *p, const topology *t, size_t n_edges,
                         const uint32_t *corner)
{
    const edge *edges = t->edges;
    p->are_orientable = true;
    for (size_t i = 0; i < n_edges;) {
        const size_t first = i;
        size_t around = 0, last_other = i;
        /* Go through the triangles around one edge: copies join their
         * original, the others are counted. */
        for (; i < n_edges && is_same_edge(&edges[i], &edges[first]); ++i) {
            if (i > first && edges[i].opposite == edges[i - 1].opposite) {
                p->is_copy[edges[i].triangle] = true;
                unite(p, t, &edges[i - 1], &edges[i], true, corner);
            } else {
                ++around;
                last_other = i;
            }
        }
        /* Only an edge of exactly two triangles continues the patch. */
        p->open_edges += around % 2;
        if (around == 2) {
            unite(p, t, &edges[first], &edges[last_other], false, corner);
        }
    }
}

murk_status murk_patches_find(murk_patches *p, const float *vertex,
                              size_t vertices, const uint32_t *corner, size_t n,
                              murk_error *err)
{
    *p = (murk_patches){.patch = malloc((n + 1) * sizeof *p->patch),
                        .is_turned = calloc(n + 1, sizeof *p->is_turned),
                        .is_copy = calloc(n + 1, sizeof *p->is_copy)};
    topology t;
    murk_status status = MURK_OK;
    if (!topology_init(&t, vertex, vertices, corner, n) || !p->patch ||
        !p->is_turned || !p->is_copy) {
        status = murk_no_memory(err, "geometry",
                                "to look for the sides of %zu triangles", n);
        goto done;
    }
    /* Join patches along the sorted edges, then number them. A root is the
     * lowest triangle of the patch, so it has a number before all others. */
    join_patches(p, &t, 3 * n, corner);
    for (size_t i = 0; i < n; ++i) {
        const uint32_t top = root(&t, (uint32_t)i, &p->is_turned[i]);
        p->patch[i] = top == i ? (uint32_t)p->patches++ : p->patch[top];
    }
    p->same = t.same;
    t.same = NULL;
done:
    topology_release(&t);
    return status;
}

void murk_patches_release(murk_patches *p)
{
    free(p->patch);
    free(p->is_turned);
    free(p->is_copy);
    free(p->same);
    *p = (murk_patches){0};
}
