/* A hash table with chained buckets: each point enters the bucket of its cell.
 * The number of buckets is at least twice the number of points, so a search
 * looks at few points of other cells. */
#include "base/cells.h"

#include <stdint.h>
#include <stdlib.h>

#define FIRST_BUCKETS 1024 /* 4 kB: small beside any scene */

/* Different cells may hash to the same bucket; the caller separates their
 * points by distance. */
struct murk_cells {
    double size_m;
    size_t n, capacity, buckets; /* buckets: a power of two, at least twice the
                                  * capacity */
    uint32_t *head;              /* [buckets] number of the newest point + 1; 0:
                                  * empty */
    uint32_t *next; /* [capacity] number of the next point of the chain + 1; 0:
                     * the chain ends */
    uint32_t *hash; /* [capacity] hash of the cell of each point */
};

/* Cell numbers are limited to this magnitude, within the range of int64_t;
 * doubles of this size no longer resolve single cells. */
#define CELL_LIMIT 9e18

static int64_t cell_of(double x, double size_m)
{
    return (int64_t)fmax(-CELL_LIMIT, fmin(CELL_LIMIT, floor(x / size_m)));
}

/* Mixes one axis after the other into the hash by shifts and multiplications,
 * with 2^64 divided by the golden ratio and a constant of the finalisation of
 * MurmurHash3 (A. Appleby, public domain). A change of one bit of a cell number
 * changes about half of the bits of the hash. */
static uint32_t hash_of(const int64_t cell[3])
{
    uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis) {
        h = (h ^ (uint64_t)cell[axis]) * UINT64_C(0x9e3779b97f4a7c15);
        h = (h ^ h >> 33) * UINT64_C(0xff51afd7ed558ccd);
        h ^= h >> 33;
    }
    return (uint32_t)h;
}

static murk_status no_memory(size_t n, murk_error *err)
{
    return murk_no_memory(err, "", "to sort %zu points", n);
}

murk_status murk_cells_create(murk_cells **out, double size_m, murk_error *err)
{
    murk_cells *made = calloc(1, sizeof *made);
    if (!made) {
        return no_memory(0, err);
    }
    made->size_m = size_m;
    made->buckets = FIRST_BUCKETS;
    made->head = calloc(FIRST_BUCKETS, sizeof *made->head);
    if (!made->head) {
        murk_cells_destroy(made);
        return no_memory(0, err);
    }
    *out = made;
    return MURK_OK;
}

void murk_cells_destroy(murk_cells *cells)
{
    if (cells) {
        free(cells->head);
        free(cells->next);
        free(cells->hash);
        free(cells);
    }
}

static void chain(murk_cells *cells, size_t i)
{
    uint32_t *head = &cells->head[cells->hash[i] & (cells->buckets - 1)];
    cells->next[i] = *head;
    *head = (uint32_t)i + 1;
}

static murk_status grow(murk_cells *cells, murk_error *err)
{
    const size_t capacity =
        cells->capacity ? 2 * cells->capacity : FIRST_BUCKETS / 2;
    /* Double the capacity (FIRST_BUCKETS / 2 points at first), with two buckets
     * for each point. If an allocation fails, the table stays as it was: `next`
     * and `hash` may be longer than before, but keep their values, and the old
     * buckets remain. */
    uint32_t *next = realloc(cells->next, capacity * sizeof *next);
    if (next) {
        cells->next = next;
    }
    uint32_t *hash = realloc(cells->hash, capacity * sizeof *hash);
    if (hash) {
        cells->hash = hash;
    }
    uint32_t *head = calloc(2 * capacity, sizeof *head);
    if (!next || !hash || !head) {
        free(head);
        return no_memory(cells->n, err);
    }
    free(cells->head);
    cells->head = head;
    cells->capacity = capacity;
    cells->buckets = 2 * capacity;
    for (size_t i = 0; i < cells->n; ++i) {
        chain(cells, i);
    }
    return MURK_OK;
}

murk_status murk_cells_add(murk_cells *cells, murk_vec3 point, murk_error *err)
{
    if (cells->n >= UINT32_MAX) {
        return no_memory(cells->n, err);
    }
    if (cells->n == cells->capacity) {
        const murk_status status = grow(cells, err);
        if (status) {
            return status;
        }
    }
    const int64_t cell[3] = {cell_of(point.x, cells->size_m),
                             cell_of(point.y, cells->size_m),
                             cell_of(point.z, cells->size_m)};
    const size_t i = cells->n++;
    cells->hash[i] = hash_of(cell);
    chain(cells, i);
    return MURK_OK;
}

bool murk_cells_search(const murk_cells *cells, murk_vec3 point,
                       double radius_m, murk_cells_visit visit, void *context)
{
    const double at[3] = {point.x, point.y, point.z};
    int64_t first[3], last[3];
    for (int axis = 0; axis < 3; ++axis) {
        first[axis] = cell_of(at[axis] - radius_m, cells->size_m);
        last[axis] = cell_of(at[axis] + radius_m, cells->size_m);
    }
    int64_t cell[3];
    for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
        for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
            for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) {
                const size_t bucket = hash_of(cell) & (cells->buckets - 1);
                for (uint32_t i = cells->head[bucket]; i;
                     i = cells->next[i - 1]) {
                    if (visit(context, i - 1)) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}
