#include "placement/row.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static bool is_all_clear(const murk_look *look)
{
    if (!look->clarity) {
        return true;
    }
    for (size_t k = 0; k < look->seen; ++k) {
        if (look->clarity[k] != MURK_CLEAR) {
            return false;
        }
    }
    return true;
}

/* The wide loops may read this far behind packed clarities. */
#define PACKED_PADDING 64

/* Bits cost slots / 8 bytes, a clear list 4 a photon seen: even at 1/32 seen.
 * Packed costs slots / 8 and 2 a photon, a list 6: even at 1/32, too. Dense
 * costs 2 a slot, hardly more than packed where most is seen, and is quicker.
 */
static murk_row_kind kind_for(const murk_layout *layout, const murk_look *look)
{
    const bool is_sparse = look->seen <= layout->slots / 32;
    if (is_all_clear(look)) {
        return is_sparse ? MURK_ROW_CLEAR_LIST : MURK_ROW_BITS;
    }
    return is_sparse                        ? MURK_ROW_LIST
           : look->seen > layout->slots / 2 ? MURK_ROW_DENSE
                                            : MURK_ROW_PACKED;
}

static size_t bytes_for(murk_row_kind kind, const murk_layout *layout,
                        size_t seen)
{
    const size_t bits = layout->words * sizeof(uint64_t);
    switch (kind) {
    case MURK_ROW_BITS:
        return bits;
    case MURK_ROW_PACKED:
        return bits + seen * sizeof(uint16_t) + PACKED_PADDING;
    case MURK_ROW_DENSE:
        return layout->slots * sizeof(uint16_t);
    case MURK_ROW_LIST:
        return seen * (sizeof(uint32_t) + sizeof(uint16_t));
    case MURK_ROW_CLEAR_LIST:
        break;
    }
    return seen * sizeof(uint32_t);
}

murk_row murk_row_borrow(const murk_look *look)
{
    return (murk_row){.kind =
                          look->clarity ? MURK_ROW_LIST : MURK_ROW_CLEAR_LIST,
                      .seen = look->seen,
                      .clarity = look->clarity,
                      .slot = look->photon};
}

size_t murk_row_bytes(const murk_layout *layout, const murk_look *look)
{
    return bytes_for(kind_for(layout, look), layout, look->seen);
}

static void fill_bits(uint64_t *bits, const murk_layout *layout,
                      const murk_look *look)
{
    for (size_t k = 0; k < look->seen; ++k) {
        const size_t at = murk_layout_slot(layout, look->photon[k]);
        bits[at / 64] |= UINT64_C(1) << (at % 64);
    }
}

/* Clarities in the order of their slots. first[words] is scratch. */
static void fill_packed(uint16_t *clarity, const uint64_t *bits,
                        uint32_t *first, const murk_layout *layout,
                        const murk_look *look)
{
    uint32_t before = 0;
    for (size_t k = 0; k < layout->words; ++k) {
        first[k] = before;
        before += (uint32_t)__builtin_popcountll(bits[k]);
    }
    for (size_t k = 0; k < look->seen; ++k) {
        const size_t at = murk_layout_slot(layout, look->photon[k]);
        const uint64_t below = bits[at / 64] & ((UINT64_C(1) << (at % 64)) - 1);
        clarity[first[at / 64] + (size_t)__builtin_popcountll(below)] =
            look->clarity[k];
    }
}

bool murk_row_store(murk_row *out, const murk_layout *layout,
                    const murk_look *look)
{
    const murk_row_kind kind = kind_for(layout, look);
    const size_t bytes = bytes_for(kind, layout, look->seen);
    void *memory = murk_aligned_zeros(bytes);
    uint32_t *first = NULL;
    if (memory && kind == MURK_ROW_PACKED) {
        first = malloc(layout->words * sizeof *first);
    }
    if (!memory || (kind == MURK_ROW_PACKED && !first)) {
        free(memory);
        return false;
    }
    murk_row row = {.kind = kind,
                    .seen = look->seen,
                    .memory = memory,
                    .memory_bytes = bytes};
    uint64_t *bits = memory;
    uint16_t *dense = memory;
    uint32_t *slot = memory;
    for (size_t k = 0; k < look->seen; ++k) {
        assert(look->photon[k] < layout->photons);
    }
    switch (kind) {
    case MURK_ROW_BITS:
        fill_bits(bits, layout, look);
        row.bits = bits;
        break;
    case MURK_ROW_PACKED:
        dense = (uint16_t *)(bits + layout->words);
        fill_bits(bits, layout, look);
        fill_packed(dense, bits, first, layout, look);
        row.bits = bits;
        row.clarity = dense;
        break;
    case MURK_ROW_DENSE:
        for (size_t k = 0; k < look->seen; ++k) {
            dense[murk_layout_slot(layout, look->photon[k])] = look->clarity[k];
        }
        row.clarity = dense;
        break;
    case MURK_ROW_LIST:
        dense = (uint16_t *)(slot + look->seen);
        memcpy(dense, look->clarity, look->seen * sizeof *dense);
        row.clarity = dense;
        /* fall through */
    case MURK_ROW_CLEAR_LIST:
        for (size_t k = 0; k < look->seen; ++k) {
            slot[k] = (uint32_t)murk_layout_slot(layout, look->photon[k]);
        }
        row.slot = slot;
        break;
    }
    free(first);
    *out = row;
    return true;
}

bool murk_cover_init(murk_cover *out, const murk_layout *layout, bool all_clear)
{
    *out = (murk_cover){0};
    if (all_clear) {
        out->full = murk_aligned_zeros(layout->words * sizeof *out->full);
    } else {
        out->best = murk_aligned_zeros(layout->slots * sizeof *out->best);
    }
    return out->full || out->best;
}

void murk_cover_release(murk_cover *cover)
{
    free(cover->full);
    free(cover->best);
    *cover = (murk_cover){0};
}

void murk_cover_clear(murk_cover *cover, const murk_layout *layout)
{
    if (cover->full) {
        memset(cover->full, 0, layout->words * sizeof *cover->full);
    } else {
        memset(cover->best, 0, layout->slots * sizeof *cover->best);
    }
}

static bool has_bit(const uint64_t *bits, size_t i)
{
    return (bits[i / 64] >> (i % 64)) & 1;
}

static void add_to_full(uint64_t *full, const murk_layout *layout,
                        const murk_row *row)
{
    if (row->kind == MURK_ROW_BITS) {
        for (size_t k = 0; k < layout->words; ++k) {
            full[k] |= row->bits[k];
        }
        return;
    }
    assert(row->kind == MURK_ROW_CLEAR_LIST);
    for (size_t k = 0; k < row->seen; ++k) {
        full[row->slot[k] / 64] |= UINT64_C(1) << (row->slot[k] % 64);
    }
}

static void add_to_best(uint16_t *best, const murk_layout *layout,
                        const murk_row *row)
{
    switch (row->kind) {
    case MURK_ROW_BITS:
        for (size_t k = 0; k < layout->words; ++k) {
            for (uint64_t left = row->bits[k]; left; left &= left - 1) {
                best[64 * k + (size_t)__builtin_ctzll(left)] = MURK_CLEAR;
            }
        }
        break;
    case MURK_ROW_PACKED: {
        const uint16_t *p = row->clarity;
        for (size_t k = 0; k < layout->words; ++k) {
            for (uint64_t left = row->bits[k]; left; left &= left - 1, ++p) {
                uint16_t *at = &best[64 * k + (size_t)__builtin_ctzll(left)];
                *at = *p > *at ? *p : *at;
            }
        }
        break;
    }
    case MURK_ROW_DENSE:
        for (size_t i = 0; i < layout->slots; ++i) {
            best[i] = row->clarity[i] > best[i] ? row->clarity[i] : best[i];
        }
        break;
    case MURK_ROW_LIST:
        for (size_t k = 0; k < row->seen; ++k) {
            uint16_t *at = &best[row->slot[k]];
            *at = row->clarity[k] > *at ? row->clarity[k] : *at;
        }
        break;
    case MURK_ROW_CLEAR_LIST:
        for (size_t k = 0; k < row->seen; ++k) {
            best[row->slot[k]] = MURK_CLEAR;
        }
        break;
    }
}

void murk_cover_add(murk_cover *cover, const murk_layout *layout,
                    const murk_row *row)
{
    if (cover->full) {
        add_to_full(cover->full, layout, row);
    } else {
        add_to_best(cover->best, layout, row);
    }
}

uint64_t murk_cover_value(const murk_cover *cover, const murk_layout *layout)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < layout->slots; ++i) {
        const uint64_t best = cover->best               ? cover->best[i]
                              : has_bit(cover->full, i) ? MURK_CLEAR
                                                        : 0;
        sum += best * layout->weight[i];
    }
    return sum;
}

void murk_cover_join(murk_cover *cover, const murk_layout *layout,
                     const murk_cover *other)
{
    if (cover->full) {
        for (size_t k = 0; k < layout->words; ++k) {
            cover->full[k] |= other->full[k];
        }
        return;
    }
    for (size_t i = 0; i < layout->slots; ++i) {
        if (other->best[i] > cover->best[i]) {
            cover->best[i] = other->best[i];
        }
    }
}

/* Weight of the row's new photons in words of mixed weights. */
static uint64_t weigh_new(const uint64_t *row, const uint64_t *full,
                          const uint32_t *weight, size_t words)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < words; ++k) {
        for (uint64_t left = row[k] & ~full[k]; left; left &= left - 1) {
            sum += weight[64 * k + (size_t)__builtin_ctzll(left)];
        }
    }
    return sum;
}

static uint64_t gain_of_bits(const murk_layout *layout, const uint64_t *bits,
                             const murk_cover *cover)
{
    const murk_kernels *kernels = layout->kernels;
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_segment *at = &layout->segment[s];
        const uint64_t *row = bits + at->first_word;
        const uint32_t *weight = layout->weight + 64 * at->first_word;
        if (cover->full) {
            const uint64_t *full = cover->full + at->first_word;
            sum += MURK_CLEAR *
                   (at->is_mixed ? weigh_new(row, full, weight, at->words)
                                 : at->weight * kernels->count_new(row, full,
                                                                   at->words));
        } else {
            const uint16_t *best = cover->best + 64 * at->first_word;
            sum +=
                at->is_mixed
                    ? kernels->weigh_missing(row, best, weight, at->words)
                    : at->weight * kernels->sum_missing(row, best, at->words);
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
        const murk_segment *at = &layout->segment[s];
        const size_t first = 64 * at->first_word;
        sum +=
            at->is_mixed
                ? kernels->weigh_above(clarity + first, best + first,
                                       layout->weight + first, 64 * at->words)
                : at->weight * kernels->sum_above(clarity + first, best + first,
                                                  64 * at->words);
    }
    return sum;
}

static uint64_t gain_of_packed(const murk_layout *layout, const murk_row *row,
                               const uint16_t *best)
{
    const murk_kernels *kernels = layout->kernels;
    const uint16_t *clarity = row->clarity;
    uint64_t sum = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_segment *at = &layout->segment[s];
        const uint64_t *bits = row->bits + at->first_word;
        const size_t first = 64 * at->first_word;
        size_t used = 0;
        sum +=
            at->is_mixed
                ? kernels->weigh_packed(bits, clarity, best + first,
                                        layout->weight + first, at->words,
                                        &used)
                : at->weight * kernels->sum_packed(bits, clarity, best + first,
                                                   at->words, &used);
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

uint64_t murk_row_gain(const murk_layout *layout, const murk_row *row,
                       const murk_cover *cover)
{
    switch (row->kind) {
    case MURK_ROW_BITS:
        return gain_of_bits(layout, row->bits, cover);
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

void murk_row_count_above(const murk_layout *layout, const murk_row *row,
                          const uint16_t *best, uint16_t *count)
{
    switch (row->kind) {
    case MURK_ROW_BITS:
        for (size_t k = 0; k < layout->words; ++k) {
            for (uint64_t left = row->bits[k]; left; left &= left - 1) {
                const size_t i = 64 * k + (size_t)__builtin_ctzll(left);
                count[i] = (uint16_t)(count[i] + (best[i] < MURK_CLEAR));
            }
        }
        break;
    case MURK_ROW_PACKED: {
        const uint16_t *p = row->clarity;
        for (size_t k = 0; k < layout->words; ++k) {
            for (uint64_t left = row->bits[k]; left; left &= left - 1, ++p) {
                const size_t i = 64 * k + (size_t)__builtin_ctzll(left);
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

bool murk_row_within(const murk_layout *layout, const murk_row *row,
                     const murk_cover *cover)
{
    switch (row->kind) {
    case MURK_ROW_BITS:
        for (size_t k = 0; k < layout->words; ++k) {
            if (cover->full) {
                if (row->bits[k] & ~cover->full[k]) {
                    return false;
                }
                continue;
            }
            for (uint64_t left = row->bits[k]; left; left &= left - 1) {
                if (cover->best[64 * k + (size_t)__builtin_ctzll(left)] <
                    MURK_CLEAR) {
                    return false;
                }
            }
        }
        return true;
    case MURK_ROW_PACKED: {
        const uint16_t *p = row->clarity;
        for (size_t k = 0; k < layout->words; ++k) {
            for (uint64_t left = row->bits[k]; left; left &= left - 1, ++p) {
                if (*p > cover->best[64 * k + (size_t)__builtin_ctzll(left)]) {
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
