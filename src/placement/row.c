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
