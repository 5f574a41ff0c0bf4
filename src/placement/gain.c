/* Gains of a row over a cover, by the format of the row and of the cover, and
 * the comparisons of a row with a cover. For a segment whose photons have one
 * weight, the gain is that weight times an unweighted sum of a kernel
 * (placement/kernels.h); for a segment of mixed weights, the kernel computes
 * the weighted sum. Lists are summed entry by entry. */
#include "placement/gain.h"

#include "placement/kernel_loops.h"

#include <assert.h>

static bool has_bit(const uint64_t *bits, size_t i)
{
    return (bits[i / 64] >> (i % 64)) & 1;
}

/* The stored words of a row in one segment. Word k belongs to word from + at[k]
 * (at NULL: from + k) of the cover and the weights. */
typedef struct row_segment {
    const uint64_t *bits;
    const uint32_t *at;
    size_t words;
    size_t from; /* first word of the segment; 0 with `at` */
} row_segment;

static row_segment segment_of(const murk_row *row, const murk_layout *layout,
                              size_t segment)
{
    if (row->at) {
        const size_t first = row->segment_start[segment];
        return (row_segment){row->bits + first, row->at + first,
                             row->segment_start[segment + 1] - first, 0};
    }
    const murk_weight_run *s = &layout->segment[segment];
    return (row_segment){row->bits + s->first_word, NULL, s->words,
                         s->first_word};
}

/* BITS and PACKED. */
static uint64_t gain_of_bits(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover, bool is_independent)
{
    const uint16_t *clarity = row->clarity;
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *segment = &layout->segment[s];
        const row_segment p = segment_of(row, layout, s);
        const uint32_t *weight =
            segment->is_mixed ? layout->weight + 64 * p.from : NULL;
        const uint64_t factor = weight ? 1 : segment->weight;
        /* A segment of weight 0 is skipped, except in a PACKED row, whose
         * clarities must be counted to find those of the next segment. */
        if (factor == 0 && !clarity) {
            continue;
        }
        if (cover->full) {
            sum += MURK_CLEAR * factor *
                   layout->kernels->count_new(
                       p.bits, p.at, cover->full + p.from, weight, p.words);
            continue;
        }
        size_t used = 0;
        sum += factor * layout->kernels->packed(
                            p.bits, p.at, clarity, cover->best + 64 * p.from,
                            weight, p.words, is_independent, &used);
        clarity = clarity ? clarity + used : NULL;
    }
    return sum;
}

static uint64_t gain_of_dense(const murk_layout *layout,
                              const uint16_t *clarity, const uint16_t *best,
                              bool is_independent)
{
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *at = &layout->segment[s];
        const size_t first = 64 * at->first_word;
        const uint32_t *weight = at->is_mixed ? layout->weight + first : NULL;
        const uint64_t factor = weight ? 1 : at->weight;
        if (factor > 0) {
            sum += factor *
                   layout->kernels->dense(clarity + first, best + first, weight,
                                          64 * at->words, is_independent);
        }
    }
    return sum;
}

/* LIST and CLEAR_LIST. */
static uint64_t gain_of_list(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover, bool is_independent)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = row->slot[k];
        const uint16_t best = !cover->full              ? cover->best[i]
                              : has_bit(cover->full, i) ? MURK_CLEAR
                                                        : 0;
        sum += murk_gain_term(row->clarity ? row->clarity[k] : MURK_CLEAR, best,
                              is_independent) *
               layout->weight[i];
    }
    return sum;
}

/* The gain over a cover of bits or clarities. With is_independent, the terms
 * are those of independent detection (murk_gain_term()). A row without
 * clarities has only entries of MURK_CLEAR, for which detection is certain; the
 * ordinary term MURK_CLEAR - best is then exact. */
static uint64_t gain_by_kind(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover, bool is_independent)
{
    is_independent = is_independent && row->clarity;
    switch (row->kind) {
    case MURK_ROW_BITS:
    case MURK_ROW_PACKED:
        return gain_of_bits(layout, row, cover, is_independent);
    case MURK_ROW_DENSE:
        return gain_of_dense(layout, row->clarity, cover->best, is_independent);
    case MURK_ROW_LIST:
    case MURK_ROW_CLEAR_LIST:
        break;
    }
    return gain_of_list(layout, row, cover, is_independent);
}

/* For detection probabilities: the worth of the sum of the doses, less the
 * worth before. */
static uint64_t gain_of_doses(const murk_layout *layout, const murk_row *row,
                              const murk_cover *cover)
{
    const murk_doses *doses = layout->doses;
    uint64_t sum = 0;
    size_t i;
    uint16_t p;
    for (murk_row_walk walk = murk_row_begin(layout, row);
         murk_row_next(&walk, &i, &p);) {
        const uint32_t with = murk_dose_add(cover->dose[i], doses->of[p]);
        sum += (uint64_t)(murk_dose_worth(doses, with) - cover->best[i]) *
               layout->weight[i];
    }
    return sum;
}

uint64_t murk_row_gain(const murk_layout *layout, const murk_row *row,
                       const murk_cover *cover)
{
    return cover->dose ? gain_of_doses(layout, row, cover)
                       : gain_by_kind(layout, row, cover, false);
}

/* Let the cover have the dose Y with worth `best`, and let h = 65535 (1 -
 * exp(-Y)), which exceeds best by less than 1.01. An entry of clarity p has a
 * dose whose worth without rounding is less than p + .08 (one unit of dose is
 * worth 1/16 at most, and linear interpolation is off by .008). So the entry
 * adds at most (65535 - h) (p + .08) / 65535 to h, and the worth grows by at
 * most p (65535 - best) / 65535 + 1.1. The kernels compute p (65535 - best) /
 * 65536, rounded down, which is less than 2 below p (65535 - best) / 65535. So
 * the worth grows by less than 3.1 more than the kernels compute.
 * MURK_GAIN_BOUND_SLACK is the next multiple of MURK_WORTH_SLACK. */
uint64_t murk_row_gain_bound(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover)
{
    assert(cover->dose);
    return gain_by_kind(layout, row, cover, true);
}

uint64_t murk_row_weight(const murk_layout *layout, const murk_row *row)
{
    uint64_t sum = 0;
    size_t i;
    uint16_t p;
    for (murk_row_walk walk = murk_row_begin(layout, row);
         murk_row_next(&walk, &i, &p);) {
        sum += p > 0 ? layout->weight[i] : 0;
    }
    return sum;
}

void murk_row_count_above(const murk_layout *layout, const murk_row *row,
                          const uint16_t *best, uint16_t *count)
{
    /* The Lagrangian bound calls this function at each evaluation, so rows of
     * bits do without the iterator, which is slower. */
    if (row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_PACKED) {
        const uint16_t *clarity = row->clarity;
        for (size_t k = 0; k < row->words; ++k) {
            const size_t first = 64 * murk_row_word(row, k);
            for (uint64_t left = row->bits[k]; left; left &= left - 1) {
                const size_t j = first + (size_t)__builtin_ctzll(left);
                const uint16_t given = clarity ? *clarity++ : MURK_CLEAR;
                count[j] = (uint16_t)(count[j] + (given > best[j]));
            }
        }
        return;
    }
    size_t i;
    uint16_t p;
    for (murk_row_walk walk = murk_row_begin(layout, row);
         murk_row_next(&walk, &i, &p);) {
        count[i] = (uint16_t)(count[i] + (p > best[i]));
    }
}

bool murk_row_is_covered(const murk_layout *layout, const murk_row *row,
                         const murk_cover *cover)
{
    if (row->kind == MURK_ROW_BITS && cover->full) {
        for (size_t k = 0; k < row->words; ++k) {
            if (row->bits[k] & ~cover->full[murk_row_word(row, k)]) {
                return false;
            }
        }
        return true;
    }
    size_t i;
    uint16_t p;
    for (murk_row_walk walk = murk_row_begin(layout, row);
         murk_row_next(&walk, &i, &p);) {
        if (cover->full ? !has_bit(cover->full, i) : p > cover->best[i]) {
            return false;
        }
    }
    return true;
}
