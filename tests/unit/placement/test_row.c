/* However a look is stored, it says the same: walked over, weighed against a
 * cover of bits or clarities, added to one, compared with one. The twin keeps
 * a clarity for each photon. */
#include "placement/gain.h"

#include "base/rng.h"
#include "check.h"

#include <stdlib.h>

#define PHOTONS 3000

typedef struct sample {
    uint32_t weight[PHOTONS], photon[PHOTONS];
    uint16_t clarity[PHOTONS], packed[PHOTONS]; /* of all; of those seen */
    uint16_t best[PHOTONS];
    murk_problem problem;
    murk_sparse_row entries;
} sample;

static uint32_t word_at(uint64_t i, uint32_t event, uint32_t slot)
{
    uint32_t word[4];
    murk_random_words(1, MURK_TEST, i, event, slot, word);
    return word[0];
}

/* Photons from `first` on, `share` of `n`; clear or of many clarities. */
static sample *sample_create(uint32_t number, size_t first, size_t n,
                             double share, bool is_clear, uint32_t weights)
{
    sample *s = calloc(1, sizeof *s);
    size_t seen = 0;
    for (size_t i = 0; i < PHOTONS; ++i) {
        s->weight[i] = 1 + word_at(i, number, 0) % weights;
        s->best[i] = (uint16_t)(word_at(i, number, 1) % 3 * 32767);
        if (i >= first && i < first + n &&
            word_at(i, number, 2) < share * 0x1p32) {
            s->clarity[i] = is_clear
                                ? MURK_CLEAR
                                : (uint16_t)(1 + word_at(i, number, 3) % 65535);
            s->photon[seen] = (uint32_t)i;
            s->packed[seen++] = s->clarity[i];
        }
    }
    s->problem = (murk_problem){.photons = PHOTONS, .weight = s->weight};
    s->entries =
        (murk_sparse_row){seen, s->photon, is_clear ? NULL : s->packed};
    return s;
}

static void check_walk(const sample *s, const murk_layout *l,
                       const murk_row *row)
{
    uint16_t at[2 * PHOTONS] = {0};
    size_t slot;
    uint16_t clarity;
    for (murk_row_walk walk = murk_row_begin(l, row);
         murk_row_next(&walk, &slot, &clarity);) {
        at[slot] = clarity;
    }
    size_t mismatches = 0;
    for (uint32_t i = 0; i < PHOTONS; ++i) {
        mismatches += at[murk_layout_slot(l, i)] != s->clarity[i];
    }
    CHECK(mismatches == 0);
}

static void check_cover(const sample *s, const murk_layout *l,
                        const murk_row *row, bool as_bits)
{
    /* Fill a cover with the sample, and compute the gain and the joined
     * value photon by photon. */
    murk_cover cover = {0};
    CHECK(murk_cover_init(&cover, l, as_bits));
    uint64_t gain = 0, value = 0;
    bool is_within = true;
    for (uint32_t i = 0; i < PHOTONS; ++i) {
        const size_t slot = murk_layout_slot(l, i);
        uint16_t best = s->best[i];
        if (as_bits) {
            best = best == 0 ? 0 : MURK_CLEAR;
            cover.full[slot / 64] |= (uint64_t)(best > 0) << (slot % 64);
        } else {
            cover.best[slot] = best;
        }
        const uint16_t joined = s->clarity[i] > best ? s->clarity[i] : best;
        gain += (uint64_t)(joined - best) * s->weight[i];
        value += (uint64_t)joined * s->weight[i];
        is_within = is_within && s->clarity[i] <= best;
    }
    /* Gain, and whether the cover contains the row. */
    CHECK(murk_row_gain(l, row, &cover) == gain);
    CHECK(murk_row_is_covered(l, row, &cover) == is_within);
    /* With clarities, the row counts photons that it sees more clearly than
     * the cover. */
    if (!as_bits) {
        uint16_t count[2 * PHOTONS] = {0};
        murk_row_count_above(l, row, cover.best, count);
        size_t mismatches = 0;
        for (uint32_t i = 0; i < PHOTONS; ++i) {
            mismatches +=
                count[murk_layout_slot(l, i)] != (s->clarity[i] > s->best[i]);
        }
        CHECK(mismatches == 0);
    }
    /* The cover with the row has the joined value and contains the row. */
    murk_cover_add(&cover, l, row);
    CHECK(murk_cover_value(&cover, l) == value);
    CHECK(murk_row_is_covered(l, row, &cover));
    murk_cover_release(&cover);
}

static void check_sample(uint32_t number, size_t first, size_t n, double share,
                         bool is_clear, uint32_t weights, murk_row_kind kind,
                         bool is_sparse)
{
    sample *s = sample_create(number, first, n, share, is_clear, weights);
    for (int regroup = 0; regroup < 2; ++regroup) {
        murk_layout l = {0};
        murk_row row = {0};
        CHECK(murk_layout_init(&l, &s->problem, regroup, NULL) == MURK_OK);
        CHECK(murk_row_store(&row, &l, &s->entries));
        CHECK(row.kind == kind);
        CHECK((row.at != NULL) == is_sparse);
        CHECK(row.memory_bytes == murk_row_bytes(&l, &s->entries));
        check_walk(s, &l, &row);
        check_cover(s, &l, &row, false);
        if (is_clear) {
            check_cover(s, &l, &row, true);
        }
        free(row.memory);
        murk_layout_release(&l);
    }
    free(s);
}

int main(void)
{
    uint32_t number = 0;
    for (uint32_t weights = 1; weights <= 1000; weights *= 10) {
        if (weights == 100) {
            continue; /* too many to put side by side, as 1000 */
        }
        check_sample(++number, 0, PHOTONS, 0.5, true, weights, MURK_ROW_BITS,
                     false);
        check_sample(++number, 1000, 300, 0.8, true, weights, MURK_ROW_BITS,
                     true);
        check_sample(++number, 0, PHOTONS, 0.01, true, weights,
                     MURK_ROW_CLEAR_LIST, false);
        check_sample(++number, 0, PHOTONS, 0.9, false, weights, MURK_ROW_DENSE,
                     false);
        check_sample(++number, 0, PHOTONS, 0.3, false, weights, MURK_ROW_PACKED,
                     false);
        check_sample(++number, 1000, 300, 0.8, false, weights, MURK_ROW_PACKED,
                     true);
        check_sample(++number, 0, PHOTONS, 0.01, false, weights, MURK_ROW_LIST,
                     false);
        check_sample(++number, 0, 0, 1, true, weights, MURK_ROW_CLEAR_LIST,
                     false);
    }
    return check_done();
}
