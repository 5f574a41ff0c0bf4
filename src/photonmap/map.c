/* Builds a photon map: orders the records as a kd-tree (photonmap/order.h) and
 * computes the bounding boxes of leaves and of groups of sixteen boxes, level
 * by level (photonmap/tree.h). */
#include "photonmap/map.h"

#include "base/interrupt.h"
#include "base/machine.h"
#include "base/pool.h"
#include "base/ranks.h"
#include "photonmap/order.h"
#include "photonmap/tree.h"

#include <assert.h>
#include <stdbool.h>
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

/* The groups of leaves of one rank: `first`, and every `step`-th after it. */
typedef struct leaf_groups {
    murk_photon_map *map;
    size_t first, step;
} leaf_groups;

static void leaf_bounds_job(void *context, uint64_t k)
{
    const leaf_groups *of_rank = context;
    const size_t group = of_rank->first + (size_t)k * of_rank->step;
    for (size_t i = 0; i < MURK_WIDE; ++i) {
        set_box(of_rank->map, 0, group * MURK_WIDE + i);
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

/* Memory for the boxes of all levels, and the place of each level. The ranks
 * that share a map share its boxes. */
static murk_status make_bounds(murk_photon_map *map, bool is_shared,
                               murk_status status, murk_error *err)
{
    const size_t size = measure_levels(map) * sizeof(murk_bounds);
    const murk_ranks_here here = murk_ranks_on_machine();
    const bool is_for_ranks = is_shared && here.count > 1;
    murk_block *block = &map->bounds_memory;
    block->is_for_ranks = is_for_ranks;
    /* Vector registers are loaded from whole cache lines, as pages of a file
     * have them. */
    if (!status && is_for_ranks && here.number == 0) {
        status = murk_block_resize(block, size, INFINITY, err);
    } else if (!status && !is_for_ranks && size > 0) {
        *block = murk_block_of(aligned_alloc(64, size), size);
        status =
            block->bytes ? MURK_OK : murk_no_memory(err, WHERE, "for its tree");
    }
    if (is_shared) {
        status = murk_ranks_share_block(block, status, err);
    }
    murk_bounds *next = map->bounds_memory.bytes;
    for (unsigned level = 0; level < map->levels && !status; ++level) {
        map->bounds[level] = next;
        next += murk_groups_of(map->n_bounds[level]);
    }
    return status;
}

/* The boxes of the leaves, of which the ranks that share the map divide the
 * groups, and then those above. */
static murk_status fill_bounds(murk_photon_map *map, unsigned threads,
                               bool is_shared, murk_status status,
                               murk_error *err)
{
    const murk_ranks_here here = murk_ranks_on_machine();
    const bool is_first = !is_shared || here.number == 0;
    if (!status && map->levels > 0) {
        leaf_groups of_rank = {.map = map,
                               .step = is_shared ? here.count : 1,
                               .first = is_shared ? here.number : 0};
        const size_t groups = murk_groups_of(map->n_bounds[0]);
        murk_pool_run(
            threads, (groups + of_rank.step - 1 - of_rank.first) / of_rank.step,
            leaf_bounds_job, &of_rank);
        status = murk_interrupt_check(err);
    }
    status = is_shared ? murk_ranks_agree(status, err) : status;
    /* The upper levels have few boxes. */
    for (unsigned level = 1; level < map->levels && !status && is_first;
         ++level) {
        const size_t end = murk_groups_of(map->n_bounds[level]) * MURK_WIDE;
        for (size_t box = 0; box < end; ++box) {
            set_box(map, level, box);
        }
    }
    return is_shared ? murk_ranks_agree(status, err) : status;
}

/* Takes the block of records, and makes a map of it, also for ranks that share
 * it. */
static murk_status create(murk_photon_map **out, murk_block *records,
                          unsigned threads, bool is_shared, murk_status status,
                          murk_error *err)
{
    assert(out && threads >= 1);
    murk_photon_map *map = calloc(1, sizeof *map);
    murk_block block = *records;
    *records = (murk_block){0};
    if (!status) {
        status = check(block.bytes, block.size / sizeof(murk_photon), err);
    }
    if (!status && !map) {
        status = murk_no_memory(err, WHERE, "for its tree");
    }
    if (is_shared) {
        status = murk_ranks_share_block(&block, status, err);
    }
    if (status) {
        murk_block_release(&block);
        free(map);
        return status;
    }
    map->block = block;
    map->photons = block.bytes;
    map->n = block.size / sizeof *map->photons;
    /* Use the fastest range tests that this machine supports. */
    unsigned n_tests;
    const murk_range_test *const *tests = murk_range_tests(&n_tests);
    map->test = tests[n_tests - 1];
    /* Order the records, then compute the boxes from the leaves upwards. Huge
     * pages make scattered queries of a million photons a sixth faster, and the
     * call takes no longer than it saves here. */
    status = make_bounds(map, is_shared, status, err);
    if (block.place == MURK_BLOCK_ON_HEAP) {
        murk_machine_join_pages(map->photons, block.size);
    }
    if (is_shared) {
        status = murk_order_shared(map->photons, map->n, threads, status, err);
    } else if (!status && !murk_order(map->photons, map->n, threads)) {
        status = murk_fail(err, MURK_INTERRUPTED, WHERE, "interrupted");
    }
    status = fill_bounds(map, threads, is_shared, status, err);
    if (status) {
        murk_photon_map_destroy(map);
    } else {
        *out = map;
    }
    return status;
}

murk_status murk_photon_map_create(murk_photon_map **out, murk_photon *photons,
                                   size_t n, unsigned threads, murk_error *err)
{
    assert(photons || n == 0);
    murk_block block = murk_block_of(photons, n * sizeof *photons);
    return create(out, &block, threads, false, MURK_OK, err);
}

murk_status murk_photon_map_create_in(murk_photon_map **out,
                                      murk_block *records, unsigned threads,
                                      murk_error *err)
{
    return create(out, records, threads, false, MURK_OK, err);
}

murk_status murk_photon_map_create_shared(murk_photon_map **out,
                                          murk_block *records, unsigned threads,
                                          murk_status status, murk_error *err)
{
    return create(out, records, threads, murk_ranks_count() > 1, status, err);
}

void murk_photon_map_destroy(murk_photon_map *map)
{
    if (map) {
        murk_block_release(&map->block);
        murk_block_release(&map->bounds_memory);
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

bool murk_photon_map_is_in_file(const murk_photon_map *map)
{
    return map->block.place == MURK_BLOCK_IN_SCRATCH_FILE;
}

size_t murk_photon_map_memory_bytes(const murk_photon_map *map)
{
    size_t groups = 0;
    for (unsigned level = 0; level < map->levels; ++level) {
        groups += murk_groups_of(map->n_bounds[level]);
    }
    return sizeof *map + map->n * sizeof *map->photons +
           groups * sizeof(murk_bounds);
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
