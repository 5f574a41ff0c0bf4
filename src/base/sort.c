/* Sorts 64-bit numbers in place: radix sort by bytes, the most significant byte
 * first, in which each bucket is filled by following the cycles of the
 * permutation (American flag sort; McIlroy, Bostic, McIlroy, Comput. Syst. 6
 * (1993) 5). qsort() of the C library takes as much memory again as the numbers
 * and several times as long. */
#include "base/sort.h"

#define BUCKETS 256 /* values of a byte */

/* Up to so many numbers are sorted by insertion, which is faster than counting
 * 256 buckets (a choice). */
#define SMALL 48

static void sort_small(uint64_t *key, size_t n)
{
    for (size_t i = 1; i < n; ++i) {
        const uint64_t moved = key[i];
        size_t j = i;
        for (; j > 0 && moved < key[j - 1]; --j) {
            key[j] = key[j - 1];
        }
        key[j] = moved;
    }
}

/* Sorts numbers that agree in all bits above the byte at `shift`. */
static void sort_by_byte(uint64_t *key, size_t n, unsigned shift)
{
    if (n <= SMALL) {
        sort_small(key, n);
        return;
    }
    /* next[b] is the place of the next number of bucket b, end[b] the end of
     * the bucket. */
    size_t next[BUCKETS], end[BUCKETS] = {0}, before = 0;
    for (size_t i = 0; i < n; ++i) {
        ++end[key[i] >> shift & (BUCKETS - 1)];
    }
    for (size_t b = 0; b < BUCKETS; ++b) {
        next[b] = before;
        before = end[b] += before;
    }
    /* Move each number to the bucket that it belongs to, and go on with the
     * number that was there, until one belongs to bucket b. */
    for (size_t b = 0; b < BUCKETS; ++b) {
        while (next[b] < end[b]) {
            uint64_t moved = key[next[b]];
            for (size_t to; (to = moved >> shift & (BUCKETS - 1)) != b;) {
                const uint64_t there = key[next[to]];
                key[next[to]++] = moved;
                moved = there;
            }
            key[next[b]++] = moved;
        }
    }
    /* Sort each bucket by the next byte. */
    for (size_t b = 0; shift > 0 && b < BUCKETS; ++b) {
        const size_t first = b > 0 ? end[b - 1] : 0;
        sort_by_byte(key + first, end[b] - first, shift - 8);
    }
}

void murk_sort_uint64(uint64_t *key, size_t n)
{
    sort_by_byte(key, n, 56);
}
