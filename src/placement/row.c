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

/* Words of bits are kept apart where at most one in so many has any: else the
 * loops over neighbours are quicker. */
#define WORDS_PER_WORD_APART 3

/* How a look is stored. */
typedef struct shape {
    murk_row_kind kind;
    bool is_apart; /* of the words of bits only those that have any */
    size_t words, bytes;
} shape;

static size_t bytes_of_bits(const shape *s, const murk_layout *layout)
{
    const size_t marks = s->is_apart ? s->words + layout->segments + 1 : 0;
    return s->words * sizeof(uint64_t) + marks * sizeof(uint32_t);
}

/* Of words that lie apart a photon shares its 8 bytes, and 4 that say where,
 * with its neighbours; a list takes 4. Clarities are 2 more. Dense costs 2 a
 * slot, hardly more than packed where most is seen, and is quicker. */
static shape shape_of(const murk_layout *layout, const murk_look *look,
                      size_t words_used)
{
    const size_t seen = look->seen;
    const bool is_clear = is_all_clear(look);
    shape s = {.kind = is_clear ? MURK_ROW_BITS : MURK_ROW_PACKED,
               .words = layout->words};
    s.is_apart = words_used <= layout->words / WORDS_PER_WORD_APART;
    if (s.is_apart) {
        s.words = words_used;
    }
    s.bytes = bytes_of_bits(&s, layout);
    const size_t clarities = is_clear ? 0 : seen * sizeof(uint16_t);
    const size_t list = seen * sizeof(uint32_t);
    if (list <= s.bytes) {
        return (shape){.kind = is_clear ? MURK_ROW_CLEAR_LIST : MURK_ROW_LIST,
                       .bytes = list + clarities};
    }
    if (!is_clear && seen > layout->slots / 2) {
        return (shape){.kind = MURK_ROW_DENSE,
                       .bytes = layout->slots * sizeof(uint16_t)};
    }
    s.bytes += is_clear ? 0 : clarities + PACKED_PADDING;
    return s;
}

murk_row murk_row_borrow(const murk_look *look)
{
    return (murk_row){.kind =
                          look->clarity ? MURK_ROW_LIST : MURK_ROW_CLEAR_LIST,
                      .seen = look->seen,
                      .clarity = look->clarity,
                      .slot = look->photon};
}

/* A bit for each slot that is seen; [layout->words], for free(). */
static uint64_t *spread(const murk_layout *layout, const murk_look *look,
                        size_t *words_used)
{
    uint64_t *bits = calloc(layout->words + 1, sizeof *bits);
    *words_used = 0;
    for (size_t k = 0; bits && k < look->seen; ++k) {
        assert(look->photon[k] < layout->photons);
        const size_t at = murk_layout_slot(layout, look->photon[k]);
        *words_used += bits[at / 64] == 0;
        bits[at / 64] |= UINT64_C(1) << (at % 64);
    }
    return bits;
}

size_t murk_row_bytes(const murk_layout *layout, const murk_look *look)
{
    size_t words_used;
    free(spread(layout, look, &words_used));
    return shape_of(layout, look, words_used).bytes;
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

static void store_bits(murk_row *row, const shape *s, const murk_layout *layout,
                       const uint64_t *bits)
{
    uint64_t *kept = row->memory;
    row->words = s->words;
    row->bits = kept;
    if (!s->is_apart) {
        memcpy(kept, bits, s->words * sizeof *kept);
        return;
    }
    uint32_t *at = (uint32_t *)(kept + s->words), *cut = at + s->words;
    row->at = at;
    row->cut = cut;
    size_t n = 0;
    for (size_t i = 0; i < layout->segments; ++i) {
        const murk_weight_run *segment = &layout->segment[i];
        cut[i] = (uint32_t)n;
        for (size_t k = segment->first_word;
             k < segment->first_word + segment->words; ++k) {
            if (bits[k]) {
                kept[n] = bits[k];
                at[n++] = (uint32_t)k;
            }
        }
    }
    cut[layout->segments] = (uint32_t)n;
}

/* Behind the bits. False when out of memory. */
static bool store_packed(murk_row *row, const shape *s,
                         const murk_layout *layout, const uint64_t *bits,
                         const murk_look *look)
{
    uint32_t *first = malloc((layout->words + 1) * sizeof *first);
    if (!first) {
        return false;
    }
    uint16_t *clarity =
        (uint16_t *)((char *)row->memory + bytes_of_bits(s, layout));
    fill_packed(clarity, bits, first, layout, look);
    row->clarity = clarity;
    free(first);
    return true;
}

static void store_dense(murk_row *row, const murk_layout *layout,
                        const murk_look *look)
{
    uint16_t *dense = row->memory;
    for (size_t k = 0; k < look->seen; ++k) {
        dense[murk_layout_slot(layout, look->photon[k])] = look->clarity[k];
    }
    row->clarity = dense;
}

static void store_list(murk_row *row, const murk_layout *layout,
                       const murk_look *look)
{
    uint32_t *slot = row->memory;
    for (size_t k = 0; k < look->seen; ++k) {
        slot[k] = (uint32_t)murk_layout_slot(layout, look->photon[k]);
    }
    row->slot = slot;
    if (row->kind == MURK_ROW_LIST) {
        uint16_t *clarity = (uint16_t *)(slot + look->seen);
        memcpy(clarity, look->clarity, look->seen * sizeof *clarity);
        row->clarity = clarity;
    }
}

bool murk_row_store(murk_row *out, const murk_layout *layout,
                    const murk_look *look)
{
    size_t words_used;
    uint64_t *bits = spread(layout, look, &words_used);
    if (!bits) {
        return false;
    }
    const shape s = shape_of(layout, look, words_used);
    murk_row row = {.kind = s.kind,
                    .seen = look->seen,
                    .memory = murk_aligned_zeros(s.bytes),
                    .memory_bytes = s.bytes};
    bool is_stored = row.memory;
    if (is_stored && s.words > 0) {
        store_bits(&row, &s, layout, bits);
        is_stored = s.kind == MURK_ROW_BITS ||
                    store_packed(&row, &s, layout, bits, look);
    } else if (is_stored && s.kind == MURK_ROW_DENSE) {
        store_dense(&row, layout, look);
    } else if (is_stored) {
        store_list(&row, layout, look);
    }
    free(bits);
    if (!is_stored) {
        free(row.memory);
        return false;
    }
    *out = row;
    return true;
}
