/* Orders records by recursive selection at the place where each node is split
 * (Floyd and Rivest 1975), with heap sort as the fallback that bounds the worst
 * case. With several threads and enough leaves, the upper levels are split one
 * after the other, the nodes of a level in parallel with one thread for each
 * node; the subtrees below are then ordered in parallel. Otherwise one thread
 * orders the whole tree. */
#include "photonmap/order.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "photonmap/range_test.h"

#include <float.h>
#include <math.h>
#include <string.h>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

/* Ranges of up to this size are sorted by insertion, which is faster for them.
 */
#define SMALL 24

/* Selection in a range of n records changes to sorting when another partition
 * would bring the number of examined records above PATIENCE * n; random ranges
 * need 3 n to 4 n. */
#define PATIENCE 16

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
    size_t span; /* leaves in a node of this step, a power of 2 */
} ordering;

/* Compares all bytes, in the order of memcmp(); any fixed order would do. Of
 * the records of a wall many have the same coordinate, so the words are
 * compared here, without a call. */
static int bytes_less(const murk_photon *a, const murk_photon *b)
{
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    uint64_t x[sizeof *a / 8], y[sizeof *b / 8];
    memcpy(x, a, sizeof x);
    memcpy(y, b, sizeof y);
    for (size_t i = 0; i < sizeof x / sizeof *x; ++i) {
        if (x[i] != y[i]) {
            return __builtin_bswap64(x[i]) < __builtin_bswap64(y[i]);
        }
    }
    return 0;
#else
    return memcmp(a, b, sizeof *a) < 0;
#endif
}

static int is_less(const murk_photon *a, const murk_photon *b, int axis)
{
    const float x = a->position_m[axis], y = b->position_m[axis];
    return x < y || (x == y && bytes_less(a, b));
}

static void swap(murk_photon *a, murk_photon *b)
{
    const murk_photon old = *a;
    *a = *b;
    *b = old;
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

static void sift_down(murk_photon *heap, size_t n, size_t i, int axis)
{
    const murk_photon moved = heap[i];
    for (size_t next; (next = 2 * i + 1) < n; i = next) {
        next += next + 1 < n && is_less(&heap[next], &heap[next + 1], axis);
        if (!is_less(&moved, &heap[next], axis)) {
            break;
        }
        heap[i] = heap[next];
    }
    heap[i] = moved;
}

void murk_order_sort(murk_photon *photons, size_t n, int axis)
{
    for (size_t i = n / 2; i-- > 0;) {
        sift_down(photons, n, i, axis);
    }
    for (size_t last = n; last-- > 1;) {
        swap(&photons[0], &photons[last]);
        sift_down(photons, last, 0, axis);
    }
}

/* Moves an evenly spaced sample to the front and selects a pivot from it at
 * photons[rank]. The pivot lies slightly beyond k on the side with more
 * records, so that k most likely falls into the smaller part (Floyd & Rivest,
 * Commun. ACM 18 (1975) 165, doi:10.1145/360680.360691). Returns rank. */
static size_t place_pivot(murk_photon *photons, size_t n, size_t k, int axis)
{
    const double root = cbrt((double)n);
    const size_t sample = (size_t)(0.5 * root * root);
    const size_t step = n / sample;
    for (size_t i = 1; i < sample; ++i) {
        swap(&photons[i], &photons[i * step]);
    }
    const double beyond = sqrt((double)sample); /* 2 sigma of a median */
    double rank = (double)k / (double)n * (double)sample;
    rank += k < n / 2 ? beyond : -beyond;
    rank = fmin(fmax(rank, 1), (double)sample - 1);
    murk_order_select(photons, sample, (size_t)rank, axis);
    return (size_t)rank;
}

/* Moves the records before the pivot (with is_closed: also those equal to it)
 * to the front and returns their number. Every record is swapped, necessary or
 * not, because this is cheaper than a branch that the processor cannot
 * predict. */
static size_t partition(murk_photon *photons, size_t n,
                        const murk_photon *pivot, int axis, int is_closed)
{
    const float x = pivot->position_m[axis];
    size_t front = 0;
    for (size_t i = 0; i < n; ++i) {
        const murk_photon moved = photons[i];
        const float y = moved.position_m[axis];
        int is_before = y < x;
        if (y == x) {
            is_before = is_closed ? !bytes_less(pivot, &moved)
                                  : bytes_less(&moved, pivot);
        }
        photons[i] = photons[front];
        photons[front] = moved;
        front += (size_t)is_before;
    }
    return front;
}

void murk_order_select(murk_photon *photons, size_t n, size_t k, int axis)
{
    /* Keep the part that contains k until it is small. */
    size_t left = PATIENCE * n;
    while (n > SMALL) {
        if (left < n) {
            murk_order_sort(photons, n, axis);
            return;
        }
        left -= n;
        const murk_photon pivot = photons[place_pivot(photons, n, k, axis)];
        const size_t front = partition(photons, n, &pivot, axis, 0);
        if (k < front) {
            n = front;
            continue;
        }
        photons += front;
        n -= front;
        k -= front;
        if (front == 0) { /* the pivot is the smallest record: remove all
                           * records equal to it */
            const size_t same = partition(photons, n, &pivot, axis, 1);
            if (k < same) {
                return;
            }
            photons += same;
            n -= same;
            k -= same;
        }
    }
    sort_small(photons, n, axis);
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

static int widest_axis(const murk_photon *photons, size_t n)
{
    float min[4], max[4];
    bound(photons, n, min, max);
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
        if (max[a] - min[a] > max[axis] - min[axis]) {
            axis = a;
        }
    }
    return axis;
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
        murk_order_select(photons, whole, half, widest_axis(photons, whole));
    }
}

static void order_subtree(const ordering *o, size_t first, size_t span)
{
    if (first >= o->n) {
        return;
    }
    if (span == 1) {
        const size_t n = o->n - first < MURK_LEAF ? o->n - first : MURK_LEAF;
        sort_small(o->photons + first, n, 0);
        return;
    }
    split(o, first, span);
    order_subtree(o, first, span / 2);
    order_subtree(o, first + span / 2 * MURK_LEAF, span / 2);
}

static void split_job(void *context, uint64_t node)
{
    const ordering *o = context;
    split(o, (size_t)node * o->span * MURK_LEAF, o->span);
}

static void subtree_job(void *context, uint64_t node)
{
    const ordering *o = context;
    order_subtree(o, (size_t)node * o->span * MURK_LEAF, o->span);
}

int murk_order(murk_photon *photons, size_t n, unsigned threads)
{
    const size_t leaves = (n + MURK_LEAF - 1) / MURK_LEAF;
    ordering o = {.photons = photons, .n = n, .span = 1};
    while (o.span < leaves) {
        o.span *= 2;
    }
    size_t nodes = 1;
    if (threads > 1 && leaves > LEAVES_SERIAL) {
        for (; nodes < SUBTREES; nodes *= 2, o.span /= 2) {
            murk_pool_run(threads, nodes, split_job, &o);
        }
    }
    murk_pool_run(threads, nodes, subtree_job, &o);
    return !murk_interrupted();
}
