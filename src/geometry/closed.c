/* Closed parts and orientable patches of a triangle mesh.
 *
 * Vertices at equal coordinates are merged by sorting. All edges are sorted,
 * so that the triangles around one edge are neighbours in the list, and a
 * union-find structure joins them (Tarjan, J. ACM 22 (1975) 215,
 * doi:10.1145/321879.321884). For patches the union-find also stores whether
 * the winding of a triangle agrees with the winding of the root. */
#include "geometry/closed.h"

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

static int order(double a, double b)
{
    return (a > b) - (a < b);
}

static int order_places(const void *left, const void *right)
{
    const place *a = left, *b = right;
    const int by_x = order((double)a->x, (double)b->x);
    const int by_y = order((double)a->y, (double)b->y);
    return by_x ? by_x : by_y ? by_y : order((double)a->z, (double)b->z);
}

static int order_edges(const void *left, const void *right)
{
    const edge *a = left, *b = right;
    const int by_low = order(a->low, b->low);
    const int by_high = order(a->high, b->high);
    const int by_opposite = order(a->opposite, b->opposite);
    return by_low        ? by_low
           : by_high     ? by_high
           : by_opposite ? by_opposite
                         : order(a->triangle, b->triangle);
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

/* Representative of a set; shortens the path by halving. */
static uint32_t root(uint32_t *parent, uint32_t i)
{
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

/* Joins the triangles around each edge, and sets odd[] for one triangle of
 * each edge with an odd number of triangles. An even number closes the
 * surface, also if four triangles meet at the edge. */
static void join(uint32_t *parent, bool *odd, const edge *edges, size_t n_edges)
{
    for (size_t i = 0; i < n_edges;) {
        size_t around = 0;
        const size_t first = i;
        for (; i < n_edges && edges[i].low == edges[first].low &&
               edges[i].high == edges[first].high;
             ++i) {
            const bool is_copy =
                i > first && edges[i].opposite == edges[i - 1].opposite;
            around += !is_copy;
            const uint32_t a = root(parent, edges[first].triangle);
            const uint32_t b = root(parent, edges[i].triangle);
            parent[a > b ? a : b] = a > b ? b : a;
        }
        odd[edges[first].triangle] |= around % 2 == 1;
    }
}

murk_status murk_closed_parts(const float *vertex, size_t vertices,
                              const uint32_t *corner, size_t n, bool *is_closed,
                              murk_error *err)
{
    murk_status status = MURK_OK;
    uint32_t *same = malloc((vertices + 1) * sizeof *same);
    uint32_t *parent = malloc((n + 1) * sizeof *parent);
    bool *odd = calloc(n + 1, sizeof *odd);
    edge *edges = malloc((3 * n + 1) * sizeof *edges);
    if (!same || !parent || !odd || !edges || !weld(same, vertex, vertices)) {
        status = murk_fail(err, MURK_NO_MEMORY, "geometry",
                           "no memory to look for closed parts of %zu "
                           "triangles",
                           n);
        goto done;
    }
    /* Each triangle starts as a part of its own; then edges join parts. */
    for (size_t i = 0; i < n; ++i) {
        parent[i] = (uint32_t)i;
        is_closed[i] = true;
    }
    list_edges(edges, corner, same, n);
    join(parent, odd, edges, 3 * n);
    for (size_t i = 0; i < n; ++i) {
        /* One edge with an odd number of triangles makes the whole part
         * open. */
        if (odd[i]) {
            is_closed[root(parent, (uint32_t)i)] = false;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        is_closed[i] = is_closed[root(parent, (uint32_t)i)];
    }
done:
    free(edges);
    free(odd);
    free(parent);
    free(same);
    return status;
}

/* Union-find in which each triangle stores whether the winding is opposite
 * to that of the parent. */
typedef struct turns {
    uint32_t *parent;
    bool *against; /* winding opposite to the parent's */
} turns;

static uint32_t root_turned(const turns *t, uint32_t i, bool *turned)
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
 * copies of one triangle if the windings run in the same direction. Returns
 * false if the two are already in one patch and the orientations contradict
 * each other. */
static bool unite(const turns *t, const edge *a, const edge *b, bool are_copies,
                  const uint32_t *corner, const uint32_t *same)
{
    const bool same_direction =
        rises(a, corner, same) == rises(b, corner, same);
    const bool turned = same_direction != are_copies;
    bool turned_a, turned_b;
    const uint32_t i = root_turned(t, a->triangle, &turned_a);
    const uint32_t j = root_turned(t, b->triangle, &turned_b);
    const bool between = turned ^ turned_a ^ turned_b;
    if (i == j) {
        return !between;
    }
    const uint32_t high = i > j ? i : j, low = i > j ? j : i;
    t->parent[high] = low;
    t->against[high] = between;
    return true;
}

static void join_patches(murk_patches *p, const turns *t, const edge *edges,
                         size_t n_edges, const uint32_t *corner)
{
    p->are_orientable = true;
    for (size_t i = 0; i < n_edges;) {
        const size_t first = i;
        size_t around = 0, last_other = i;
        /* Go through the triangles around one edge: copies join their
         * original, the others are counted. */
        for (; i < n_edges && edges[i].low == edges[first].low &&
               edges[i].high == edges[first].high;
             ++i) {
            if (i > first && edges[i].opposite == edges[i - 1].opposite) {
                p->is_copy[edges[i].triangle] = true;
                p->are_orientable &=
                    unite(t, &edges[i - 1], &edges[i], true, corner, p->same);
            } else {
                ++around;
                last_other = i;
            }
        }
        /* Only an edge of exactly two triangles continues the patch. */
        p->open_edges += around % 2;
        if (around == 2) {
            p->are_orientable &= unite(t, &edges[first], &edges[last_other],
                                       false, corner, p->same);
        }
    }
}

/* Numbers the patches. A root is the lowest triangle of the patch, so the
 * root has a number before all others. */
static void number_patches(murk_patches *p, const turns *t, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        const uint32_t top = root_turned(t, (uint32_t)i, &p->is_turned[i]);
        p->patch[i] = top == i ? (uint32_t)p->patches++ : p->patch[top];
    }
}

murk_status murk_patches_find(murk_patches *p, const float *vertex,
                              size_t vertices, const uint32_t *corner, size_t n,
                              murk_error *err)
{
    *p = (murk_patches){.patch = malloc((n + 1) * sizeof *p->patch),
                        .is_turned = calloc(n + 1, sizeof *p->is_turned),
                        .is_copy = calloc(n + 1, sizeof *p->is_copy),
                        .same = malloc((vertices + 1) * sizeof *p->same)};
    const turns t = {malloc((n + 1) * sizeof *t.parent),
                     calloc(n + 1, sizeof *t.against)};
    edge *edges = malloc((3 * n + 1) * sizeof *edges);
    murk_status status = MURK_OK;
    if (!p->patch || !p->is_turned || !p->is_copy || !p->same || !t.parent ||
        !t.against || !edges || !weld(p->same, vertex, vertices)) {
        status =
            murk_fail(err, MURK_NO_MEMORY, "geometry",
                      "no memory to look for the sides of %zu triangles", n);
        goto done;
    }
    /* Each triangle starts as a patch of its own. */
    for (size_t i = 0; i < n; ++i) {
        t.parent[i] = (uint32_t)i;
    }
    /* Join patches along the sorted edges, then number the patches. */
    list_edges(edges, corner, p->same, n);
    join_patches(p, &t, edges, 3 * n, corner);
    number_patches(p, &t, n);
done:
    free(edges);
    free(t.parent);
    free(t.against);
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
