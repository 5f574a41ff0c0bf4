/* Builds a photon map: orders the records as a kd-tree (photonmap/order.h) and
 * computes the bounding boxes of leaves and of groups of sixteen boxes, level
 * by level (photonmap/tree.h). */
#include "photonmap/map.h"

#include "base/interrupt.h"
#include "base/machine.h"
#include "base/pool.h"
#include "photonmap/order.h"
#include "photonmap/tree.h"

#include <assert.h>
#include <stdlib.h>

#define WHERE "photon map"

static murk_status check(const murk_photon *photons, size_t n, murk_error *err)
{
    if (n > UINT32_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, WHERE,
                         "%.4g photons, must be at most %u", (double)n,
                         (unsigned)UINT32_MAX);
    }
    for (size_t i = 0; i < n; ++i) {
        const float *p = photons[i].position_m;
        if (!(isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]))) {
            return murk_fail(err, MURK_BAD_VALUE, WHERE,
                             "photon %zu lies at (%g, %g, %g) m, must be "
                             "finite",
                             i, (double)p[0], (double)p[1], (double)p[2]);
        }
    }
    return MURK_OK;
}

/* Extends the box min..max so that it contains the box low..high. */
static void extend(float min[3], float max[3], const float low[3],
                   const float high[3])
{
    for (int a = 0; a < 3; ++a) {
        min[a] = low[a] < min[a] ? low[a] : min[a];
        max[a] = high[a] > max[a] ? high[a] : max[a];
    }
}

/* Computes and stores a box: around the photons of a leaf (level 0), or around
 * a group of boxes of the level below. A box that is not in use gets min =
 * +infinity and max = -infinity, so no other box is extended by it. */
static void set_box(murk_photon_map *map, unsigned level, size_t box)
{
    float min[3] = {INFINITY, INFINITY, INFINITY};
    float max[3] = {-INFINITY, -INFINITY, -INFINITY};
    if (level == 0) {
        const size_t end = murk_first_of(map, 0, box + 1);
        for (size_t i = murk_first_of(map, 0, box); i < end; ++i) {
            const float *at = map->photons[i].position_m;
            extend(min, max, at, at);
        }
    } else if (box < map->n_bounds[level]) {
        const murk_bounds *group = map->bounds[level - 1] + box;
        for (int i = 0; i < MURK_WIDE; ++i) {
            extend(
                min, max,
                (float[]){group->min[0][i], group->min[1][i], group->min[2][i]},
                (float[]){group->max[0][i], group->max[1][i],
                          group->max[2][i]});
        }
    }
    /* Store it in its group. */
    murk_bounds *group = map->bounds[level] + box / MURK_WIDE;
    for (int a = 0; a < 3; ++a) {
        group->min[a][box % MURK_WIDE] = min[a];
        group->max[a][box % MURK_WIDE] = max[a];
    }
}

static void leaf_bounds_job(void *context, uint64_t group)
{
    for (size_t i = 0; i < MURK_WIDE; ++i) {
        set_box(context, 0, (size_t)group * MURK_WIDE + i);
    }
}

/* Counts the boxes of each level. Returns the number of groups of all
 * levels. */
static size_t measure_levels(murk_photon_map *map)
{
    size_t bounds = (map->n + MURK_LEAF - 1) / MURK_LEAF;
    size_t all = 0;
    while (bounds > 0) {
        map->n_bounds[map->levels++] = bounds;
        all += murk_groups_of(bounds);
        bounds = bounds > MURK_WIDE ? murk_groups_of(bounds) : 0;
    }
    return all;
}

murk_status murk_photon_map_create(murk_photon_map **out, murk_photon *photons,
                                   size_t n, unsigned threads, murk_error *err)
{
    assert(out && (photons || n == 0) && threads >= 1);
    murk_photon_map *map = NULL;
    murk_status status = check(photons, n, err);
    if (status) {
        goto done;
    }
    map = calloc(1, sizeof *map);
    if (!map) {
        status = murk_no_memory(err, WHERE, "for its tree");
        goto done;
    }
    /* Use the fastest range tests that this machine supports. */
    unsigned n_tests;
    const murk_range_test *const *tests = murk_range_tests(&n_tests);
    map->test = tests[n_tests - 1];
    map->n = n;
    /* Memory for the boxes of all levels. */
    const size_t groups = measure_levels(map);
    if (groups > 0) {
        map->memory = aligned_alloc(64, groups * sizeof *map->memory);
        if (!map->memory) {
            status = murk_no_memory(err, WHERE, "for its tree");
            goto done;
        }
    }
    map->photons = photons;
    photons = NULL;
    murk_bounds *next = map->memory;
    for (unsigned level = 0; level < map->levels; ++level) {
        map->bounds[level] = next;
        next += murk_groups_of(map->n_bounds[level]);
    }
    /* Order the records, then compute the boxes from the leaves upwards. Huge
     * pages make scattered queries of a million photons a sixth faster, and the
     * call takes no longer than it saves here. */
    murk_machine_join_pages(map->photons, n * sizeof *map->photons);
    if (!murk_order(map->photons, n, threads)) {
        status = murk_fail(err, MURK_INTERRUPTED, WHERE, "interrupted");
        goto done;
    }
    if (map->levels > 0) {
        murk_pool_run(threads, murk_groups_of(map->n_bounds[0]),
                      leaf_bounds_job, map);
    }
    for (unsigned level = 1; level < map->levels; ++level) {
        const size_t end = murk_groups_of(map->n_bounds[level]) * MURK_WIDE;
        for (size_t box = 0; box < end; ++box) {
            set_box(map, level, box);
        }
    }
    if (murk_interrupted()) { /* boxes may be missing then */
        status = murk_fail(err, MURK_INTERRUPTED, WHERE, "interrupted");
        goto done;
    }
    *out = map;
    map = NULL;
done:
    free(photons);
    murk_photon_map_destroy(map);
    return status;
}

void murk_photon_map_destroy(murk_photon_map *map)
{
    if (map) {
        free(map->photons);
        free(map->memory);
        free(map);
    }
}

size_t murk_photon_map_count(const murk_photon_map *map)
{
    return map->n;
}

const murk_photon *murk_photon_map_photons(const murk_photon_map *map)
{
    return map->photons;
}

size_t murk_photon_map_memory_bytes(const murk_photon_map *map)
{
    size_t groups = 0;
    for (unsigned level = 0; level < map->levels; ++level) {
        groups += murk_groups_of(map->n_bounds[level]);
    }
    return sizeof *map + map->n * sizeof *map->photons +
           groups * sizeof *map->memory;
}

double murk_photon_map_memory_for(double n)
{
    double bytes = sizeof(murk_photon_map);
    if (n >= 1) {
        bytes += n * sizeof(murk_photon);
        double bounds = ceil(n / MURK_LEAF);
        for (unsigned level = 0; level < MURK_KDTREE_LEVELS && bounds > 0;
             ++level) {
            const double groups = ceil(bounds / MURK_WIDE);
            bytes += groups * sizeof(murk_bounds);
            bounds = bounds > MURK_WIDE ? groups : 0;
        }
    }
    return bytes;
}
