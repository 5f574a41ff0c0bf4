/* Gains of a row over a cover, by the format of the row and of the cover, and
 * the comparisons of a row with a cover. A segment whose photons have one
 * weight takes the weight times the sum of a kernel (placement/kernels.h); a
 * segment of mixed weights takes the weighted sum. */
#include "placement/gain.h"

#include "placement/kernel_loops.h"

#include <assert.h>

static bool has_bit(const uint64_t *bits, size_t i)
{
    return (bits[i / 64] >> (i % 64)) & 1;
}

/* The stored words of a row in one segment. `at` counts from word `from` of the
 * cover and the weights. */
typedef struct row_segment {
    const uint64_t *bits;
    const uint32_t *at;
    size_t words;
    size_t from; /* first word */
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

/* Weight of the photons in the row and not in the cover, for words of mixed
 * weights. */
static uint64_t weighted_new(const row_segment *p, const uint64_t *full,
                             const uint32_t *weight)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < p->words; ++k) {
        const size_t at = p->at ? p->at[k] : k;
        for (uint64_t left = p->bits[k] & ~full[at]; left; left &= left - 1) {
            sum += weight[64 * at + (size_t)__builtin_ctzll(left)];
        }
    }
    return sum;
}

static uint64_t gain_of_bits(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover)
{
    const murk_kernels *kernels = layout->kernels;
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *segment = &layout->segment[s];
        const row_segment p = segment_of(row, layout, s);
        const uint32_t *weight = layout->weight + 64 * p.from;
        /* A 0/1 cover needs bit counts, a cover of clarities sums of what is
         * missing to MURK_CLEAR. */
        if (!segment->is_mixed && segment->weight == 0) {
            continue;
        }
        if (cover->full) {
            const uint64_t *full = cover->full + p.from;
            sum += MURK_CLEAR *
                   (segment->is_mixed
                        ? weighted_new(&p, full, weight)
                        : segment->weight *
                              kernels->count_new(p.bits, p.at, full, p.words));
        } else {
            const uint16_t *best = cover->best + 64 * p.from;
            sum += segment->is_mixed
                       ? kernels->weighted_missing(p.bits, p.at, best, weight,
                                                   p.words)
                       : segment->weight *
                             kernels->sum_missing(p.bits, p.at, best, p.words);
        }
    }
    return sum;
}

static uint64_t gain_of_dense(const murk_layout *layout,
                              const uint16_t *clarity, const uint16_t *best)
{
    const murk_kernels *kernels = layout->kernels;
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *at = &layout->segment[s];
        const size_t first = 64 * at->first_word;
        if (!at->is_mixed && at->weight == 0) {
            continue;
        }
        sum +=
            at->is_mixed
                ? kernels->weighted_above(clarity + first, best + first,
                                          layout->weight + first,
                                          64 * at->words)
                : at->weight * kernels->sum_above(clarity + first, best + first,
                                                  64 * at->words);
    }
    return sum;
}

static uint64_t gain_of_packed(const murk_layout *layout, const murk_row *row,
                               const uint16_t *lowest)
{
    const murk_kernels *kernels = layout->kernels;
    const uint16_t *clarity = row->clarity;
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *segment = &layout->segment[s];
        const row_segment p = segment_of(row, layout, s);
        const uint16_t *best = lowest + 64 * p.from;
        size_t used = 0;
        sum +=
            segment->is_mixed
                ? kernels->weighted_packed(p.bits, p.at, clarity, best,
                                           layout->weight + 64 * p.from,
                                           p.words, &used)
                : segment->weight * kernels->sum_packed(p.bits, p.at, clarity,
                                                        best, p.words, &used);
        clarity += used;
    }
    return sum;
}

static uint64_t gain_of_list(const murk_layout *layout, const murk_row *row,
                             const uint16_t *best)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = row->slot[k];
        const uint16_t p = row->clarity[k];
        sum += p > best[i] ? (uint64_t)(p - best[i]) * layout->weight[i] : 0;
    }
    return sum;
}

static uint64_t gain_of_clear_list(const murk_layout *layout,
                                   const murk_row *row, const murk_cover *cover)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = row->slot[k];
        const uint64_t missing =
            cover->full ? (has_bit(cover->full, i) ? 0 : MURK_CLEAR)
                        : MURK_CLEAR - (uint64_t)cover->best[i];
        sum += missing * layout->weight[i];
    }
    return sum;
}

/* For detection probabilities: the worth of the sum of the doses, less the
 * worth before. */
static uint64_t gain_of_independent(const murk_layout *layout,
                                    const murk_row *row,
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
    if (cover->dose) {
        return gain_of_independent(layout, row, cover);
    }
    switch (row->kind) {
    case MURK_ROW_BITS:
        return gain_of_bits(layout, row, cover);
    case MURK_ROW_PACKED:
        return gain_of_packed(layout, row, cover->best);
    case MURK_ROW_DENSE:
        return gain_of_dense(layout, row->clarity, cover->best);
    case MURK_ROW_LIST:
        return gain_of_list(layout, row, cover->best);
    case MURK_ROW_CLEAR_LIST:
        break;
    }
    return gain_of_clear_list(layout, row, cover);
}

static uint64_t independent_dense(const murk_layout *layout,
                                  const uint16_t *row, const uint16_t *best)
{
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *at = &layout->segment[s];
        const size_t first = 64 * at->first_word, n = 64 * at->words;
        if (!at->is_mixed) {
            sum += at->weight * layout->kernels->sum_independent(
                                    row + first, best + first, n);
            continue;
        }
        for (size_t i = first; i < first + n; ++i) {
            sum +=
                murk_loop_independent_gain(row[i], best[i]) * layout->weight[i];
        }
    }
    return sum;
}

static uint64_t independent_packed(const murk_layout *layout,
                                   const murk_row *row, const uint16_t *lowest)
{
    const uint16_t *clarity = row->clarity;
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const row_segment p = segment_of(row, layout, s);
        const uint16_t *best = lowest + 64 * p.from;
        const uint32_t *weight = layout->weight + 64 * p.from;
        if (!layout->segment[s].is_mixed) {
            size_t used = 0;
            sum += layout->segment[s].weight *
                   layout->kernels->sum_independent_packed(
                       p.bits, p.at, clarity, best, p.words, &used);
            clarity += used;
            continue;
        }
        /* Mixed weights: entry by entry. */
        for (size_t k = 0; k < p.words; ++k) {
            const size_t first = 64 * murk_word_at(p.at, k);
            for (uint64_t left = p.bits[k]; left; left &= left - 1) {
                const size_t i = first + (size_t)__builtin_ctzll(left);
                sum +=
                    murk_loop_independent_gain(*clarity++, best[i]) * weight[i];
            }
        }
    }
    return sum;
}

/* Let the cover have the dose Y with worth `best`, and let h = 65535 (1 -
 * exp(-Y)), which exceeds best by less than 1.01. An entry of clarity p adds at
 * most (65535 - h)(p + .07) / 65535 to h, so the worth grows by at most p
 * (65535 - best) / 65535 + 1.1. That is less than 2 above the same product
 * divided by 65536 and rounded down, which the kernels compute.
 * MURK_GAIN_BOUND_SLACK is twice that. */
uint64_t murk_row_gain_bound(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover)
{
    assert(cover->dose);
    uint64_t sum = 0;
    switch (row->kind) {
    case MURK_ROW_BITS:
        return gain_of_bits(layout, row, cover);
    case MURK_ROW_PACKED:
        return independent_packed(layout, row, cover->best);
    case MURK_ROW_DENSE:
        return independent_dense(layout, row->clarity, cover->best);
    case MURK_ROW_LIST:
        for (size_t k = 0; k < row->seen; ++k) {
            const uint32_t i = row->slot[k];
            sum += murk_loop_independent_gain(row->clarity[k], cover->best[i]) *
                   layout->weight[i];
        }
        return sum;
    case MURK_ROW_CLEAR_LIST:
        break;
    }
    return gain_of_clear_list(layout, row, cover);
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
    switch (row->kind) {
    /* A set bit stands for MURK_CLEAR. */
    case MURK_ROW_BITS:
        for (size_t k = 0; k < row->words; ++k) {
            const size_t first = 64 * murk_row_word(row, k);
            for (uint64_t left = row->bits[k]; left; left &= left - 1) {
                const size_t i = first + (size_t)__builtin_ctzll(left);
                count[i] = (uint16_t)(count[i] + (best[i] < MURK_CLEAR));
            }
        }
        break;
    case MURK_ROW_PACKED: {
        const uint16_t *p = row->clarity;
        for (size_t k = 0; k < row->words; ++k) {
            const size_t first = 64 * murk_row_word(row, k);
            for (uint64_t left = row->bits[k]; left; left &= left - 1, ++p) {
                const size_t i = first + (size_t)__builtin_ctzll(left);
                count[i] = (uint16_t)(count[i] + (*p > best[i]));
            }
        }
        break;
    }
    case MURK_ROW_DENSE:
        for (size_t i = 0; i < layout->slots; ++i) {
            count[i] = (uint16_t)(count[i] + (row->clarity[i] > best[i]));
        }
        break;
    case MURK_ROW_LIST:
    case MURK_ROW_CLEAR_LIST:
        for (size_t k = 0; k < row->seen; ++k) {
            const uint32_t i = row->slot[k];
            const uint16_t p = row->clarity ? row->clarity[k] : MURK_CLEAR;
            count[i] = (uint16_t)(count[i] + (p > best[i]));
        }
        break;
    }
}

bool murk_row_is_covered(const murk_layout *layout, const murk_row *row,
                         const murk_cover *cover)
{
    switch (row->kind) {
    /* Each format returns at the first entry that exceeds the cover. */
    case MURK_ROW_BITS:
        for (size_t k = 0; k < row->words; ++k) {
            const size_t at = murk_row_word(row, k);
            if (cover->full) {
                if (row->bits[k] & ~cover->full[at]) {
                    return false;
                }
                continue;
            }
            for (uint64_t left = row->bits[k]; left; left &= left - 1) {
                if (cover->best[64 * at + (size_t)__builtin_ctzll(left)] <
                    MURK_CLEAR) {
                    return false;
                }
            }
        }
        return true;
    case MURK_ROW_PACKED: {
        const uint16_t *p = row->clarity;
        for (size_t k = 0; k < row->words; ++k) {
            const uint16_t *lowest = cover->best + 64 * murk_row_word(row, k);
            for (uint64_t left = row->bits[k]; left; left &= left - 1, ++p) {
                if (*p > lowest[__builtin_ctzll(left)]) {
                    return false;
                }
            }
        }
        return true;
    }
    case MURK_ROW_DENSE:
        for (size_t i = 0; i < layout->slots; ++i) {
            if (row->clarity[i] > cover->best[i]) {
                return false;
            }
        }
        return true;
    case MURK_ROW_LIST:
    case MURK_ROW_CLEAR_LIST:
        break;
    }
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = row->slot[k];
        const uint16_t p = row->clarity ? row->clarity[k] : MURK_CLEAR;
        if (cover->full ? !has_bit(cover->full, i) : p > cover->best[i]) {
            return false;
        }
    }
    return true;
}
