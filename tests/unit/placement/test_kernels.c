/* The wide loops agree with the plain ones in every bit, at lengths around
 * their strides, at the largest terms, and beyond a lane's capacity. */
#include "placement/kernels.h"

#include "base/rng.h"
#include "check.h"
#include "placement/problem.h"

#include <stdlib.h>

typedef struct arrays {
    uint64_t *row, *full;
    uint16_t *dense, *packed, *best;
    uint32_t *weight;
} arrays;

static uint32_t word_at(uint64_t i, uint32_t slot)
{
    uint32_t word[4];
    murk_random_words(1, MURK_TEST, i, 0, slot, word);
    return word[0];
}

/* Weights add up to less than 2^47 (placement/problem.h). */
static uint32_t largest_weight(size_t photons)
{
    const uint64_t share = (((uint64_t)1 << 47) - 1) / (photons + 1);
    return share < UINT32_MAX ? (uint32_t)share : UINT32_MAX;
}

static arrays arrays_create(size_t words, bool is_extreme)
{
    /* Aligned arrays, with some spare words at the end. */
    const size_t n = 64 * words;
    arrays a = {aligned_alloc(64, (words / 8 + 1) * 64),
                aligned_alloc(64, (words / 8 + 1) * 64),
                aligned_alloc(64, 2 * n + 64),
                aligned_alloc(64, 2 * n + 128),
                aligned_alloc(64, 2 * n + 64),
                aligned_alloc(64, 4 * n + 64)};
    /* Bits: random with every third word of the row empty, or all bits set
     * against none. */
    for (size_t k = 0; k < words; ++k) {
        a.row[k] = (uint64_t)word_at(k, 0) << 32 | word_at(k, 1);
        a.full[k] = (uint64_t)word_at(k, 2) << 32 | word_at(k, 3);
        if (is_extreme) {
            a.row[k] = UINT64_MAX;
            a.full[k] = 0;
        } else if (k % 3 == 1) {
            a.row[k] = 0;
        }
    }
    /* Clarities and weights: random, or the largest that may occur, over an
     * empty cover. */
    memset(a.packed, 0, 2 * n + 128);
    for (size_t i = 0; i < n; ++i) {
        a.dense[i] = is_extreme ? MURK_CLEAR : (uint16_t)word_at(i, 4);
        a.packed[i] = is_extreme ? MURK_CLEAR : (uint16_t)word_at(i, 5);
        a.best[i] = is_extreme ? 0 : (uint16_t)word_at(i, 6);
        a.weight[i] = is_extreme ? largest_weight(n) : word_at(i, 7);
    }
    return a;
}

static void arrays_release(arrays *a)
{
    free(a->row);
    free(a->full);
    free(a->dense);
    free(a->packed);
    free(a->best);
    free(a->weight);
}

/* Of words side by side, or that lie apart in twice as many. */
static void check_bits(const murk_kernels *f, const arrays *a,
                       const uint32_t *at, size_t words)
{
    const murk_kernels *p = murk_kernels_number(0);
    for (int has_weights = 0; has_weights < 2; ++has_weights) {
        const uint32_t *weight = has_weights ? a->weight : NULL;
        CHECK(p->count_new(a->row, at, a->full, weight, words) ==
              f->count_new(a->row, at, a->full, weight, words));
        for (int form = 0; form < 3; ++form) {
            const uint16_t *clarity = form > 0 ? a->packed : NULL;
            size_t used[2] = {0};
            CHECK(p->packed(a->row, at, clarity, a->best, weight, words,
                            form > 1, &used[0]) ==
                  f->packed(a->row, at, clarity, a->best, weight, words,
                            form > 1, &used[1]));
            CHECK(used[0] == used[1]);
        }
    }
}

/* Sums over all lanes at once. The covers of the lanes are made of best[]:
 * lane l of a slot has the clarity of the slot l places farther on. */
static void check_lanes(const murk_kernels *f, const arrays *a,
                        const uint32_t *at, size_t words, size_t slots)
{
    const murk_kernels *p = murk_kernels_number(0);
    uint16_t *best = aligned_alloc(64, 2 * slots * MURK_COVER_LANES + 64);
    for (size_t i = 0; i < slots * MURK_COVER_LANES; ++i) {
        best[i] =
            a->best[(i / MURK_COVER_LANES + i % MURK_COVER_LANES) % slots];
    }
    for (int form = 0; form < 4; ++form) {
        const uint16_t *clarity = form / 2 ? a->packed : NULL;
        const uint32_t *weight = form % 2 ? a->weight : NULL;
        uint64_t sum[2][MURK_COVER_LANES];
        size_t used[2] = {0};
        p->lanes(a->row, at, clarity, best, weight, words, &used[0], sum[0]);
        f->lanes(a->row, at, clarity, best, weight, words, &used[1], sum[1]);
        CHECK(memcmp(sum[0], sum[1], sizeof sum[0]) == 0);
        CHECK(used[0] == used[1]);
        /* Lane 0 has the cover of the other loops. */
        size_t alone = 0;
        CHECK(sum[0][0] == p->packed(a->row, at, clarity, a->best, weight,
                                     words, false, &alone));
        CHECK(used[0] == alone);
    }
    free(best);
}

static void check_same(const murk_kernels *f, size_t words, bool is_extreme)
{
    const murk_kernels *p = murk_kernels_number(0);
    arrays a = arrays_create(words, is_extreme);
    const size_t n = 64 * words;
    for (int form = 0; form < 4; ++form) {
        const uint32_t *weight = form % 2 ? a.weight : NULL;
        CHECK(p->dense(a.dense, a.best, weight, n, form > 1) ==
              f->dense(a.dense, a.best, weight, n, form > 1));
    }
    check_bits(f, &a, NULL, words);
    if (words > 0 && words < 5000) {
        check_lanes(f, &a, NULL, words, n);
    }
    uint32_t *at = malloc((words / 2 + 1) * sizeof *at);
    for (size_t k = 0; k < words / 2; ++k) {
        at[k] = (uint32_t)(2 * k + word_at(k, 8) % 2);
    }
    check_bits(f, &a, at, words / 2);
    if (words > 0 && words < 5000) {
        check_lanes(f, &a, at, words / 2, n);
    }
    free(at);
    arrays_release(&a);
}

/* The plain loops against sums known beforehand. */
static void test_plain_sums(void)
{
    const murk_kernels *p = murk_kernels_number(0);
    arrays a = arrays_create(2, true);
    const uint64_t all = (uint64_t)128 * MURK_CLEAR;
    size_t used = 0;
    a.full[0] = 7;
    CHECK(p->count_new(a.row, NULL, a.full, NULL, 2) == 125);
    CHECK(p->count_new(a.row, NULL, a.full, a.weight, 2) ==
          (uint64_t)125 * UINT32_MAX);
    CHECK(p->packed(a.row, NULL, NULL, a.best, NULL, 2, false, &used) == all);
    CHECK(p->dense(a.dense, a.best, NULL, 128, false) == all);
    CHECK(p->dense(a.dense, a.best, a.weight, 128, false) == all * UINT32_MAX);
    CHECK(p->dense(a.dense, a.best, NULL, 128, true) == all - 128);
    a.best[3] = MURK_CLEAR - 1;
    a.row[1] = 1;
    CHECK(p->packed(a.row, NULL, NULL, a.best, NULL, 2, false, &used) ==
          (uint64_t)64 * MURK_CLEAR + 1);
    CHECK(p->packed(a.row, NULL, a.packed, a.best, NULL, 2, false, &used) ==
          (uint64_t)64 * MURK_CLEAR + 1);
    CHECK(used == 65);
    /* the one photon of the second word is the cover's first */
    const uint32_t first = 0;
    a.best[0] = MURK_CLEAR - 5;
    CHECK(p->packed(a.row + 1, &first, NULL, a.best, NULL, 1, false, &used) ==
          5);
    CHECK(p->packed(a.row + 1, &first, NULL, a.best, a.weight, 1, false,
                    &used) == (uint64_t)5 * UINT32_MAX);
    CHECK(p->count_new(a.row + 1, &first, a.full, NULL, 1) == 0);
    arrays_release(&a);
}

int main(void)
{
    test_plain_sums();
    for (size_t set = 1; murk_kernels_number(set); ++set) {
        const murk_kernels *f = murk_kernels_number(set);
        for (size_t words = 0; words < 20; ++words) {
            check_same(f, words, false);
            check_same(f, words, true);
        }
        /* lanes of 32 bits must be emptied in time */
        check_same(f, 40000, true);
        check_same(f, 3001, false);
        check_same(f, 3001, true);
    }
    return check_done();
}
