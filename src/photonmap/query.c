/* Queries of a photon map: all photons within a ball, and the k nearest
 * photons. Both descend through groups of sixteen bounding boxes. A ball query
 * finds all photons of a box that lies completely within the ball without
 * testing each photon, and fetches the memory of the next box while one is
 * searched; the k-nearest query visits the boxes of each group in order of
 * distance and keeps the nearest photons in a heap. */
#include "photonmap/map.h"
#include "photonmap/tree.h"

#include <assert.h>
#include <float.h>

#define CACHE_LINE 64 /* bytes, of most processors */

/* ---- within a ball ---- */

typedef struct ball_query {
    const murk_photon_map *map;
    murk_query_sphere ball;
    uint32_t *found; /* NULL: count only */
    size_t n;        /* found so far */
} ball_query;

/* Adds the records first to end - 1. Runs are written in pieces of a fixed
 * length, for which compilers use vector instructions. */
static void add_run(ball_query *q, size_t first, size_t end)
{
    const size_t n = end - first;
    if (q->found) {
        uint32_t *out = q->found + q->n;
        size_t i = 0;
        for (; i + MURK_LEAF <= n; i += MURK_LEAF) {
            for (size_t k = 0; k < MURK_LEAF; ++k) {
                out[i + k] = (uint32_t)first + (uint32_t)(i + k);
            }
        }
        for (; i < n; ++i) {
            out[i] = (uint32_t)(first + i);
        }
    }
    q->n += n;
}

static void add_leaf(ball_query *q, size_t leaf)
{
    const size_t first = murk_first_of(q->map, 0, leaf);
    uint32_t in = q->map->test->leaf(
        q->map->photons + first,
        (uint32_t)(murk_first_of(q->map, 0, leaf + 1) - first), &q->ball);
    if (!q->found) {
        q->n += (size_t)__builtin_popcount(in);
        return;
    }
    for (; in; in &= in - 1) {
        q->found[q->n++] = (uint32_t)first + (uint32_t)__builtin_ctz(in);
    }
}

/* Asks the processor to fetch the memory that a search of the box will read:
 * the records of a leaf, or the boxes of the level below. The last leaf may be
 * shorter; to ask for memory behind it does no harm. */
static void prefetch(const murk_photon_map *map, unsigned level, size_t box)
{
    const char *memory = level == 0
                             ? (const char *)(map->photons + box * MURK_LEAF)
                             : (const char *)(map->bounds[level - 1] + box);
    const size_t bytes =
        level == 0 ? MURK_LEAF * sizeof *map->photons : sizeof(murk_bounds);
    for (size_t i = 0; i < bytes; i += CACHE_LINE) {
        __builtin_prefetch(memory + i);
    }
}

static void search_group(ball_query *q, unsigned level, size_t group)
{
    const murk_photon_map *map = q->map;
    uint32_t whole;
    uint32_t met =
        map->test->bounds(map->bounds[level] + group, &q->ball, &whole);
    while (met) {
        const unsigned i = (unsigned)__builtin_ctz(met);
        const size_t box = group * MURK_WIDE + i;
        met &= met - 1;
        /* Fetch the next box that must be searched while this one is
         * searched. */
        const uint32_t next = met & ~whole;
        if (next) {
            prefetch(map, level,
                     group * MURK_WIDE + (unsigned)__builtin_ctz(next));
        }
        if (whole >> i & 1) {
            add_run(q, murk_first_of(map, level, box),
                    murk_first_of(map, level, box + 1));
        } else if (level == 0) {
            add_leaf(q, box);
        } else {
            search_group(q, level - 1, box);
        }
    }
}

static bool round_center(float out[3], murk_vec3 center)
{
    out[0] = (float)center.x;
    out[1] = (float)center.y;
    out[2] = (float)center.z;
    return isfinite(out[0]) && isfinite(out[1]) && isfinite(out[2]);
}

/* False if no photon can be within the radius. */
static bool make_ball(murk_query_sphere *out, murk_vec3 center, double radius_m)
{
    const float radius = (float)radius_m;
    out->radius2 = radius * radius;
    return radius_m >= 0 && round_center(out->center, center);
}

static size_t search(const murk_photon_map *map, murk_vec3 center,
                     double radius_m, uint32_t *found)
{
    ball_query q = {.map = map, .found = found};
    if (!make_ball(&q.ball, center, radius_m) || map->levels == 0) {
        return 0;
    }
    if (q.ball.radius2 > FLT_MAX) { /* the distance to an unused box would be
                                     * within the radius, too */
        add_run(&q, 0, map->n);
    } else {
        search_group(&q, map->levels - 1, 0);
    }
    return q.n;
}

size_t murk_photon_map_within(const murk_photon_map *map, murk_vec3 center,
                              double radius_m, uint32_t *found)
{
    assert(map && (found || map->n == 0));
    return search(map, center, radius_m, found);
}

size_t murk_photons_within(const murk_photon *photon, size_t n,
                           murk_vec3 center, double radius_m, uint32_t *found)
{
    murk_query_sphere ball;
    unsigned tests;
    size_t count = 0;
    if (!make_ball(&ball, center, radius_m)) {
        return 0;
    }
    /* All tests give the same bits, and a distance that overflows is within a
     * radius that does, as search() has it. */
    const murk_range_test *test = murk_range_tests(&tests)[0];
    for (size_t first = 0; first < n; first += MURK_LEAF) {
        const size_t left = n - first;
        uint32_t in =
            test->leaf(photon + first,
                       (uint32_t)(left < MURK_LEAF ? left : MURK_LEAF), &ball);
        for (; in; in &= in - 1) {
            found[count++] = (uint32_t)first + (uint32_t)__builtin_ctz(in);
        }
    }
    return count;
}

size_t murk_photons_chosen_within(const murk_photon *photon, uint32_t *chosen,
                                  size_t n, murk_vec3 center, double radius_m)
{
    murk_query_sphere ball;
    size_t remaining = 0;
    if (!make_ball(&ball, center, radius_m)) {
        return 0;
    }
    for (size_t i = 0; i < n; ++i) {
        const float *at = photon[chosen[i]].position_m;
        const float x = at[0] - ball.center[0], y = at[1] - ball.center[1],
                    z = at[2] - ball.center[2];
        chosen[remaining] = chosen[i];
        remaining += x * x + y * y + z * z <= ball.radius2;
    }
    return remaining;
}

size_t murk_photon_map_count_within(const murk_photon_map *map,
                                    murk_vec3 center, double radius_m)
{
    assert(map);
    return search(map, center, radius_m, NULL);
}

/* ---- nearest ---- */

/* The arrays found and distance2 are a heap with the farthest photon on top,
 * until they are sorted at the end. */
typedef struct nearest_query {
    const murk_photon_map *map;
    float center[3];
    size_t k, n;
    uint32_t *found;
    double *distance2;
} nearest_query;

static bool comes_before(double d_a, uint32_t a, double d_b, uint32_t b)
{
    return d_a < d_b || (d_a == d_b && a < b);
}

/* Puts a photon into the heap of the first n places, moving the hole at i
 * down. */
static void settle(nearest_query *q, size_t n, size_t i, double d,
                   uint32_t photon)
{
    for (size_t child; (child = 2 * i + 1) < n; i = child) {
        if (child + 1 < n &&
            comes_before(q->distance2[child], q->found[child],
                         q->distance2[child + 1], q->found[child + 1])) {
            ++child;
        }
        if (!comes_before(d, photon, q->distance2[child], q->found[child])) {
            break;
        }
        q->distance2[i] = q->distance2[child];
        q->found[i] = q->found[child];
    }
    q->distance2[i] = d;
    q->found[i] = photon;
}

static void push(nearest_query *q, double d, uint32_t photon)
{
    size_t i = q->n++;
    while (i > 0) {
        const size_t parent = (i - 1) / 2;
        if (!comes_before(q->distance2[parent], q->found[parent], d, photon)) {
            break;
        }
        q->distance2[i] = q->distance2[parent];
        q->found[i] = q->found[parent];
        i = parent;
    }
    q->distance2[i] = d;
    q->found[i] = photon;
}

/* True if a photon at the squared distance d may be among the k nearest. */
static bool may_count(const nearest_query *q, double d)
{
    return q->n < q->k || d <= q->distance2[0];
}

static void offer_leaf(nearest_query *q, size_t leaf)
{
    const size_t first = murk_first_of(q->map, 0, leaf);
    const uint32_t n = (uint32_t)(murk_first_of(q->map, 0, leaf + 1) - first);
    float distance2[MURK_LEAF];
    q->map->test->leaf_distance2(q->map->photons + first, n, q->center,
                                 distance2);
    for (uint32_t i = 0; i < n; ++i) {
        const double d = (double)distance2[i];
        const uint32_t photon = (uint32_t)first + i;
        if (q->n < q->k) {
            push(q, d, photon);
        } else if (comes_before(d, photon, q->distance2[0], q->found[0])) {
            settle(q, q->n, 0, d, photon);
        }
    }
}

static void nearest_in_group(nearest_query *q, unsigned level, size_t group)
{
    const murk_photon_map *map = q->map;
    float distance2[MURK_WIDE];
    map->test->bounds_distance2(map->bounds[level] + group, q->center,
                                distance2);
    const size_t rest = map->n_bounds[level] - group * MURK_WIDE;
    uint32_t left = rest < MURK_WIDE ? (1u << rest) - 1 : (1u << MURK_WIDE) - 1;
    while (left) {
        unsigned nearest = (unsigned)__builtin_ctz(left);
        for (uint32_t m = left & (left - 1); m; m &= m - 1) {
            const unsigned i = (unsigned)__builtin_ctz(m);
            nearest = distance2[i] < distance2[nearest] ? i : nearest;
        }
        if (!may_count(q, (double)distance2[nearest])) {
            return;
        }
        left &= ~(1u << nearest);
        if (level == 0) {
            offer_leaf(q, group * MURK_WIDE + nearest);
        } else {
            nearest_in_group(q, level - 1, group * MURK_WIDE + nearest);
        }
    }
}

size_t murk_photon_map_nearest(const murk_photon_map *map, murk_vec3 center,
                               size_t k, uint32_t *found, double *distance2_m2)
{
    assert(map && ((found && distance2_m2) || k == 0 || map->n == 0));
    nearest_query q = {
        .map = map, .k = k, .found = found, .distance2 = distance2_m2};
    if (k == 0 || map->levels == 0 || !round_center(q.center, center)) {
        return 0;
    }
    nearest_in_group(&q, map->levels - 1, 0);
    for (size_t last = q.n; last-- > 1;) {
        const double d = q.distance2[last];
        const uint32_t photon = q.found[last];
        q.distance2[last] = q.distance2[0];
        q.found[last] = q.found[0];
        settle(&q, last, 0, d, photon);
    }
    return q.n;
}
