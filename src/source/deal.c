/* Deals photons by a golden-ratio (Weyl) sequence in 64-bit integers, and
 * counts the photons of a prefix with floor sums instead of a loop over
 * photons. */
#include "source/deal.h"

#include <assert.h>

/* 2^64 divided by the golden ratio, rounded to an odd number. */
#define GOLDEN UINT64_C(0x9e3779b97f4a7c15)

__extension__ typedef unsigned __int128 wide;

void murk_deal_limits(const double *weight, size_t n, uint64_t *limit)
{
    double all = 0, sum = 0;
    for (size_t i = 0; i < n; ++i) {
        all += weight[i];
    }
    for (size_t i = 0; i + 1 < n; ++i) {
        sum += weight[i];
        const double share = sum / all;
        limit[i] = share < 1 ? (uint64_t)(share * 0x1p64) : UINT64_MAX;
    }
}

size_t murk_deal_one(const uint64_t *limit, size_t n, uint64_t photon)
{
    if (photon < n) {
        return (size_t)photon;
    }
    const uint64_t place = (photon - n) * GOLDEN;
    size_t low = 0, high = n - 1; /* the channel is in [low, high] */
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (place < limit[middle]) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

/* The sum over k < n of floor((a k + b) / m), modulo 2^128, by Euclid's
 * algorithm on a and m (Graham, Knuth and Patashnik, Concrete Mathematics,
 * 3.5). Range: a n + b stays below 2^127 for a < m, b <= m, m <= 2^64 and n <
 * 2^62. */
static wide floor_sum(wide n, wide m, wide a, wide b)
{
    wide sum = 0;
    /* Reduce a and b modulo m, then exchange the roles of a and m. */
    while (n > 0) {
        if (a >= m) {
            /* One of n and n - 1 is even: halve that one, so that the division
             * is exact. */
            sum += (n % 2 ? n * ((n - 1) / 2) : (n / 2) * (n - 1)) * (a / m);
            a %= m;
        }
        sum += n * (b / m);
        b %= m;
        const wide top = a * n + b;
        if (top < m) {
            break;
        }
        n = top / m;
        b = top % m;
        const wide swap = m;
        m = a;
        a = swap;
    }
    return sum;
}

/* Counts k < n with (k GOLDEN mod 2^64) < limit: these are the k for which
 * floor((x + 2^64) / 2^64) and floor((x + 2^64 - limit) / 2^64) differ, with x
 * = k GOLDEN. */
static uint64_t count_below(uint64_t n, uint64_t limit)
{
    const wide m = (wide)1 << 64;
    return (uint64_t)(floor_sum(n, m, GOLDEN, m) -
                      floor_sum(n, m, GOLDEN, m - limit));
}

void murk_deal_count(const uint64_t *limit, size_t n, uint64_t photons,
                     uint64_t *count)
{
    assert(photons < (UINT64_C(1) << 62));
    const uint64_t singles = photons < n ? photons : n;
    const uint64_t rest = photons - singles;
    uint64_t below = 0;
    for (size_t i = 0; i < n; ++i) {
        const uint64_t next = i + 1 < n ? count_below(rest, limit[i]) : rest;
        count[i] = next - below + (i < singles ? 1 : 0);
        below = next;
    }
}
