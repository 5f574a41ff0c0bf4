/* Orders records by recursive selection at the place where each node is split.
 *
 * A selection counts the records by bins of their coordinate, moves those
 * before the bin of the wanted place, and then those of the bin, to the front,
 * and goes on with that bin alone. Among records with the same coordinate the
 * words of the records take the place of the coordinate. Each step divides the
 * range of numbers by BINS, so the worst case is O(n), too.
 *
 * With several threads and enough leaves, the upper levels are split one after
 * the other, the nodes of a level in parallel with one thread for each node;
 * the subtrees below are then ordered in parallel. Ranks that share the records
 * divide the nodes of a level and the subtrees, too. Otherwise one thread
 * orders the whole tree. */
#include "photonmap/order.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/ranks.h"
#include "photonmap/range_test.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

/* Ranges of up to this size are sorted by insertion, which is faster for them.
 */
#define SMALL 16

/* Bins of a step of the selection, and records that are compared before any of
 * them is moved; the number of a record in its block fits a byte. Half or twice
 * of either takes the same time. */
#define BINS  256
#define BLOCK 128

#define WORDS ((int)(sizeof(murk_photon) / sizeof(uint64_t)))

/* The number of subtrees that several threads order in parallel: several for
 * each thread of most machines, so that all threads finish at about the same
 * time. */
#define SUBTREES 64

/* Up to this number of leaves, one thread orders all records: this takes less
 * time than to start two threads. */
#define LEAVES_SERIAL 256

typedef struct ordering {
    murk_photon *photons;
    size_t n;
    size_t span;          /* leaves in a node of this step, a power of 2 */
    murk_ranks_here here; /* the ranks that share the records, which divide the
                           * nodes of a step, if is_shared */
    bool is_shared;
} ordering;

/* A word of a record as a number: comparing the words one after the other is
 * the order of memcmp(). */
static inline uint64_t word_of(const murk_photon *photon, int i)
{
    uint64_t word;
    memcpy(&word, (const char *)photon + (size_t)i * sizeof word, sizeof word);
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    word = __builtin_bswap64(word);
#endif
    return word;
}

/* Compares all bytes; any fixed order would do. Of the records of a wall many
 * have the same coordinate, so the words are compared here, without a call. */
static int bytes_less(const murk_photon *a, const murk_photon *b)
{
    for (int i = 0; i < WORDS; ++i) {
        const uint64_t x = word_of(a, i), y = word_of(b, i);
        if (x != y) {
            return x < y;
        }
    }
    return 0;
}

static int is_less(const murk_photon *a, const murk_photon *b, int axis)
{
    const float x = a->position_m[axis], y = b->position_m[axis];
    return x < y || (x == y && bytes_less(a, b));
}

/* Copied as bytes, because compilers copy a record member by member. */
static inline void swap(murk_photon *a, murk_photon *b)
{
    unsigned char x[sizeof *a], y[sizeof *b];
    memcpy(x, a, sizeof x);
    memcpy(y, b, sizeof y);
    memcpy(a, y, sizeof y);
    memcpy(b, x, sizeof x);
}

static void sort_small(murk_photon *photons, size_t n, int axis)
{
    for (size_t i = 1; i < n; ++i) {
        const murk_photon moved = photons[i];
        size_t j = i;
        for (; j > 0 && is_less(&moved, &photons[j - 1], axis); --j) {
            photons[j] = photons[j - 1];
        }
        photons[j] = moved;
    }
}

/* Numbers in the order of coordinates. */
static inline uint32_t coordinate_number(float x)
{
    const float no_sign_of_zero = x + 0.0F; /* -0 is 0 */
    uint32_t bits;
    memcpy(&bits, &no_sign_of_zero, sizeof bits);
    return bits ^ (bits >> 31 ? UINT32_MAX : UINT32_C(1) << 31);
}

/* Sorts the n <= MURK_LEAF records of a leaf by x. Each record is first moved
 * to the place given by the number of records before it, which takes no branch;
 * sort_small() then only compares, unless records have equal keys. */
static void sort_leaf(murk_photon *photons, size_t n)
{
    uint64_t key[MURK_LEAF];
    uint32_t place[MURK_LEAF] = {0};
    murk_photon sorted[MURK_LEAF] = {{{0}, 0, 0, 0, 0, 0, 0, 0, 0}};
    for (size_t i = 0; i < n; ++i) {
        /* by x, then by the bytes of y */
        key[i] = (uint64_t)coordinate_number(photons[i].position_m[0]) << 32 |
                 (uint32_t)word_of(&photons[i], 0);
        uint32_t before = 0;
        for (size_t j = 0; j < i; ++j) {
            const uint32_t is_after = key[j] > key[i];
            place[j] += is_after;
            before += 1 - is_after;
        }
        place[i] = before;
    }
    for (size_t i = 0; i < n; ++i) {
        sorted[place[i]] = photons[i];
    }
    memcpy(photons, sorted, n * sizeof *sorted);
    sort_small(photons, n, 0);
}

/* The numbers that is_less() compares one after the other: the coordinate
 * (level 0), then the words of the record. */
static inline uint64_t number_at(const murk_photon *photon, int axis, int level)
{
    return level == 0 ? coordinate_number(photon->position_m[axis])
                      : word_of(photon, level - 1);
}

/* The records that a selection still looks at. */
typedef struct selection {
    murk_photon *photons;
    size_t n;
    int axis;
} selection;

/* The smallest and the largest number of the records. */
static inline __attribute__((always_inline)) void
find_range(const selection *s, int level, uint64_t *low, uint64_t *high)
{
    *low = UINT64_MAX;
    *high = 0;
    for (size_t i = 0; i < s->n; ++i) {
        const uint64_t number = number_at(&s->photons[i], s->axis, level);
        *low = number < *low ? number : *low;
        *high = number > *high ? number : *high;
    }
}

/* Counts the numbers, which are at least `low`, by bins of 2^shift. */
static inline __attribute__((always_inline)) void
count_bins(const selection *s, int level, uint64_t low, unsigned shift,
           uint32_t count[BINS])
{
    memset(count, 0, BINS * sizeof *count);
    for (size_t i = 0; i < s->n; ++i) {
        ++count[(number_at(&s->photons[i], s->axis, level) - low) >> shift];
    }
}

/* The largest coordinate whose number is at most `last`, the number of a
 * coordinate or one below: comparing coordinates takes fewer instructions than
 * making numbers of them. */
static inline float last_coordinate(uint32_t last)
{
    /* No coordinate has the number of -0: the next lower one. */
    const uint32_t number = last == UINT32_MAX >> 1 ? last - 1 : last;
    const uint32_t bits =
        number ^ (number >> 31 ? UINT32_C(1) << 31 : UINT32_MAX);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Moves the records with numbers up to `last` to the front. The records of a
 * block are compared first, without a branch that
 * the processor cannot predict, and those to be moved are then swapped
 * (Edelkamp and Weiss, ACM J. Exp. Algorithmics 24 (2019) 1.4,
 * doi:10.1145/3274660). */
static inline __attribute__((always_inline)) void
partition(const selection *s, int level, uint64_t last)
{
    const float last_m = level == 0 ? last_coordinate((uint32_t)last) : 0;
    size_t front = 0;
    for (size_t first = 0; first < s->n; first += BLOCK) {
        murk_photon *block = s->photons + first;
        const size_t size = s->n - first < BLOCK ? s->n - first : BLOCK;
        uint8_t before[BLOCK];
        size_t count = 0;
        for (size_t i = 0; i < size; ++i) {
            before[count] = (uint8_t)i;
            count += level == 0 ? block[i].position_m[s->axis] <= last_m
                                : number_at(&block[i], s->axis, level) <= last;
        }
        for (size_t i = 0; i < count; ++i) {
            swap(&s->photons[front++], &block[before[i]]);
        }
    }
}

/* Keeps the records whose numbers lie in the bin of record k, the only ones
 * whose order is still unknown, and the range of numbers of this bin. */
static inline __attribute__((always_inline)) void
narrow(selection *s, int level, size_t *k, uint64_t *low, uint64_t *high)
{
    /* Count by bins, and find the bin of record k. */
    unsigned shift = 0;
    while ((*high - *low) >> shift >= BINS) {
        ++shift;
    }
    uint32_t count[BINS];
    count_bins(s, level, *low, shift, count);
    size_t before = 0, bin = 0;
    while (before + count[bin] <= *k) {
        before += count[bin++];
    }
    *low += (uint64_t)bin << shift;
    const uint64_t width_less_1 = (UINT64_C(1) << shift) - 1;
    *high = *high - *low > width_less_1 ? *low + width_less_1 : *high;
    /* Records before the bin, then those of the bin. */
    if (before > 0) {
        partition(s, level, *low - 1);
        s->photons += before;
        s->n -= before;
        *k -= before;
    }
    if (count[bin] < s->n) {
        partition(s, level, *high);
        s->n = count[bin];
    }
}

/* murk_order_select() for records whose coordinates are in [min, max]. */
static void select_within(murk_photon *photons, size_t n, size_t k, int axis,
                          float min, float max)
{
    selection s = {photons, n, axis};
    uint64_t low = coordinate_number(min), high = coordinate_number(max);
    while (s.n > SMALL && low < high) {
        narrow(&s, 0, &k, &low, &high);
    }
    /* Records with the same coordinate. */
    for (int level = 1; s.n > SMALL && level <= WORDS; ++level) {
        find_range(&s, level, &low, &high);
        while (s.n > SMALL && low < high) {
            narrow(&s, level, &k, &low, &high);
        }
    }
    if (s.n <= SMALL) {
        sort_small(s.photons, s.n, axis);
    }
}

/* Computes the bounding box of the positions: min and max by axis. */
static void bound(const murk_photon *photons, size_t n, float min[4],
                  float max[4])
{
#if defined(__SSE2__)
    /* The fourth lane is the next member of the record, read as a number: it
     * meets no other lane, and is not used. */
    __m128 low = _mm_set1_ps(FLT_MAX), high = _mm_set1_ps(-FLT_MAX);
    for (size_t i = 0; i < n; ++i) {
        const __m128 x = _mm_loadu_ps(photons[i].position_m);
        low = _mm_min_ps(x, low);
        high = _mm_max_ps(x, high);
    }
    _mm_storeu_ps(min, low);
    _mm_storeu_ps(max, high);
#else
    for (int a = 0; a < 3; ++a) {
        min[a] = FLT_MAX;
        max[a] = -FLT_MAX;
    }
    for (size_t i = 0; i < n; ++i) {
        for (int a = 0; a < 3; ++a) {
            const float x = photons[i].position_m[a];
            min[a] = x < min[a] ? x : min[a];
            max[a] = x > max[a] ? x : max[a];
        }
    }
#endif
}

void murk_order_select(murk_photon *photons, size_t n, size_t k, int axis)
{
    float min[4], max[4];
    bound(photons, n, min, max);
    select_within(photons, n, k, axis, min[axis], max[axis]);
}

/* Splits the node of `span` leaves that starts at record `first`, if the node
 * has more than the first half of its leaves. */
static void split(const ordering *o, size_t first, size_t span)
{
    const size_t half = span / 2 * MURK_LEAF;
    const size_t n = first < o->n ? o->n - first : 0;
    if (n > half) {
        murk_photon *photons = o->photons + first;
        const size_t whole = n < 2 * half ? n : 2 * half;
        float min[4], max[4];
        bound(photons, whole, min, max);
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            if (max[a] - min[a] > max[axis] - min[axis]) {
                axis = a;
            }
        }
        select_within(photons, whole, half, axis, min[axis], max[axis]);
    }
}

static void order_subtree(const ordering *o, size_t first, size_t span)
{
    if (first >= o->n) {
        return;
    }
    if (span == 1) {
        const size_t n = o->n - first < MURK_LEAF ? o->n - first : MURK_LEAF;
        sort_leaf(o->photons + first, n);
        return;
    }
    split(o, first, span);
    order_subtree(o, first, span / 2);
    order_subtree(o, first + span / 2 * MURK_LEAF, span / 2);
}

/* The number of the k-th node that is dealt to this rank. */
static size_t node_of(const ordering *o, uint64_t k)
{
    return (size_t)k * o->here.count + o->here.number;
}

static void split_job(void *context, uint64_t k)
{
    const ordering *o = context;
    split(o, node_of(o, k) * o->span * MURK_LEAF, o->span);
}

static void subtree_job(void *context, uint64_t k)
{
    const ordering *o = context;
    order_subtree(o, node_of(o, k) * o->span * MURK_LEAF, o->span);
}

/* Runs the job for the nodes that are dealt to this rank, and waits for the
 * other ranks. */
static murk_status run_nodes(ordering *o, unsigned threads, size_t nodes,
                             murk_job job, murk_status status, murk_error *err)
{
    const size_t count = o->here.count;
    if (!status) {
        murk_pool_run(threads, nodes / count + (o->here.number < nodes % count),
                      job, o);
        status = murk_interrupt_check(err);
    }
    return o->is_shared ? murk_ranks_agree(status, err) : status;
}

static murk_status order(ordering *o, unsigned threads, murk_status status,
                         murk_error *err)
{
    const size_t leaves = (o->n + MURK_LEAF - 1) / MURK_LEAF;
    const bool is_divided =
        leaves > LEAVES_SERIAL && (threads > 1 || o->here.count > 1);
    o->span = 1;
    while (o->span < leaves) {
        o->span *= 2;
    }
    /* The ranks of another machine may have no records, and wait as often. */
    for (size_t nodes = 1; nodes < SUBTREES; nodes *= 2) {
        status = run_nodes(o, threads, is_divided ? nodes : 0, split_job,
                           status, err);
        o->span /= is_divided ? 2 : 1;
    }
    return run_nodes(o, threads, is_divided ? SUBTREES : 1, subtree_job, status,
                     err);
}

int murk_order(murk_photon *photons, size_t n, unsigned threads)
{
    murk_error err = {0};
    ordering o = {.photons = photons, .n = n, .here = {.count = 1}};
    return !order(&o, threads, MURK_OK, &err);
}

murk_status murk_order_shared(murk_photon *photons, size_t n, unsigned threads,
                              murk_status status, murk_error *err)
{
    ordering o = {.photons = photons,
                  .n = n,
                  .here = murk_ranks_on_machine(),
                  .is_shared = true};
    return order(&o, threads, status, err);
}
