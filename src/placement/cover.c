/* Covers of photons by sets of candidates: as bits if the matrix is 0/1, else
 * as clarities; for detection probabilities also as doses. Layers keep the k
 * largest entries of each photon: a new entry goes to the highest layer that
 * has a smaller one, and the displaced entry moves on to the layer below. */
#include "placement/cover.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static bool init(murk_cover *out, const murk_layout *layout, bool is_binary,
                 size_t layers, bool has_doses)
{
    *out = (murk_cover){.layers = layers};
    if (is_binary) {
        out->full =
            murk_aligned_zeros(layers * layout->words * sizeof *out->full);
        return out->full;
    }
    out->best = murk_aligned_zeros(layers * layout->slots * sizeof *out->best);
    if (has_doses) {
        out->dose = murk_aligned_zeros(layout->slots * sizeof *out->dose);
    }
    if (!out->best || (has_doses && !out->dose)) {
        murk_cover_release(out);
        return false;
    }
    return true;
}

bool murk_cover_init(murk_cover *out, const murk_layout *layout, bool is_binary)
{
    return init(out, layout, is_binary, layout->layers, layout->doses);
}

bool murk_cover_init_single(murk_cover *out, const murk_layout *layout,
                            bool is_binary)
{
    return init(out, layout, is_binary, 1, false);
}

void murk_cover_release(murk_cover *cover)
{
    free(cover->full);
    free(cover->best);
    free(cover->dose);
    *cover = (murk_cover){0};
}

void murk_cover_clear(murk_cover *cover, const murk_layout *layout)
{
    const size_t layers = cover->layers;
    if (cover->full) {
        memset(cover->full, 0, layers * layout->words * sizeof *cover->full);
        return;
    }
    memset(cover->best, 0, layers * layout->slots * sizeof *cover->best);
    if (cover->dose) {
        memset(cover->dose, 0, layout->slots * sizeof *cover->dose);
    }
}

void murk_cover_copy(murk_cover *to, const murk_layout *layout,
                     const murk_cover *from)
{
    const size_t layers = to->layers;
    assert(layers == from->layers && !to->full == !from->full &&
           !to->dose == !from->dose);
    if (to->full) {
        memcpy(to->full, from->full, layers * layout->words * sizeof *to->full);
        return;
    }
    memcpy(to->best, from->best, layers * layout->slots * sizeof *to->best);
    if (to->dose) {
        memcpy(to->dose, from->dose, layout->slots * sizeof *to->dose);
    }
}

/* Inserts bits into the layers of a word, from the highest layer down: a layer
 * passes on the bits that it already has. */
static void insert_bits(const murk_cover *cover, const murk_layout *layout,
                        size_t word, uint64_t bits)
{
    for (size_t k = cover->layers; k-- > 0 && bits;) {
        uint64_t *at = &cover->full[k * layout->words + word];
        const uint64_t both = *at & bits;
        *at |= bits;
        bits = both;
    }
}

/* Inserts a clarity into the layers of a slot, from the highest layer down: the
 * smaller value is passed on. */
static void insert_clarity(const murk_cover *cover, const murk_layout *layout,
                           size_t slot, uint16_t clarity)
{
    for (size_t k = cover->layers; k-- > 0;) {
        uint16_t *at = &cover->best[k * layout->slots + slot];
        if (clarity > *at) {
            const uint16_t below = *at;
            *at = clarity;
            clarity = below;
        }
    }
}

static void add_dose(const murk_cover *cover, const murk_layout *layout,
                     size_t slot, uint32_t dose)
{
    cover->dose[slot] = murk_dose_add(cover->dose[slot], dose);
    cover->best[slot] = murk_dose_worth(layout->doses, cover->dose[slot]);
}

/* Adds a row of bits, with or without clarities, to a cover of one layer. */
static void add_packed(uint16_t *best, const murk_row *row)
{
    const uint16_t *p = row->clarity;
    for (size_t k = 0; k < row->words; ++k) {
        uint16_t *of_word = best + 64 * murk_row_word(row, k);
        for (uint64_t left = row->bits[k]; left; left &= left - 1) {
            const size_t i = (size_t)__builtin_ctzll(left);
            const uint16_t clarity = p ? *p++ : MURK_CLEAR;
            of_word[i] = clarity > of_word[i] ? clarity : of_word[i];
        }
    }
}

/* A row of bits is added to a cover of bits word by word. To a single layer
 * without doses, a dense row is added slot by slot without branches, and a row
 * of bits without the iterator. In all other cases the row is added entry by
 * entry. */
void murk_cover_add(murk_cover *cover, const murk_layout *layout,
                    const murk_row *row)
{
    if (row->kind == MURK_ROW_BITS && cover->full) {
        for (size_t k = 0; k < row->words; ++k) {
            insert_bits(cover, layout, murk_row_word(row, k), row->bits[k]);
        }
        return;
    }
    if (row->kind == MURK_ROW_DENSE && cover->layers == 1 && !cover->dose) {
        uint16_t *best = cover->best;
        for (size_t i = 0; i < layout->slots; ++i) {
            best[i] = row->clarity[i] > best[i] ? row->clarity[i] : best[i];
        }
        return;
    }
    const bool has_bits =
        row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_PACKED;
    if (has_bits && !cover->full && cover->layers == 1 && !cover->dose) {
        add_packed(cover->best, row);
        return;
    }
    /* Entry by entry. */
    size_t slot;
    uint16_t clarity;
    for (murk_row_walk walk = murk_row_begin(layout, row);
         murk_row_next(&walk, &slot, &clarity);) {
        if (cover->dose) {
            add_dose(cover, layout, slot, layout->doses->of[clarity]);
        } else if (cover->full) {
            insert_bits(cover, layout, slot / 64, UINT64_C(1) << (slot % 64));
        } else {
            insert_clarity(cover, layout, slot, clarity);
        }
    }
}

void murk_cover_join(murk_cover *cover, const murk_layout *layout,
                     const murk_cover *other)
{
    for (size_t i = 0; cover->dose && i < layout->slots; ++i) {
        add_dose(cover, layout, i, other->dose[i]);
    }
    for (size_t k = 0; !cover->dose && k < other->layers; ++k) {
        for (size_t i = 0; cover->full && i < layout->words; ++i) {
            insert_bits(cover, layout, i, other->full[k * layout->words + i]);
        }
        for (size_t i = 0; cover->best && i < layout->slots; ++i) {
            insert_clarity(cover, layout, i,
                           other->best[k * layout->slots + i]);
        }
    }
}

typedef struct cover_arrays {
    size_t full, best, dose; /* bytes; full and best are multiples of 8 */
} cover_arrays;

static size_t in_words(size_t bytes)
{
    return (bytes + 7) / 8 * 8;
}

static cover_arrays arrays_of(const murk_cover *cover,
                              const murk_layout *layout)
{
    const size_t layers = cover->layers;
    return (cover_arrays){
        cover->full ? layers * layout->words * sizeof *cover->full : 0,
        cover->best ? in_words(layers * layout->slots * sizeof *cover->best)
                    : 0,
        cover->dose ? in_words(layout->slots * sizeof *cover->dose) : 0};
}

size_t murk_cover_bytes(const murk_cover *cover, const murk_layout *layout)
{
    const cover_arrays size = arrays_of(cover, layout);
    return size.full + size.best + size.dose;
}

void murk_cover_pack(const murk_cover *cover, const murk_layout *layout,
                     char *block)
{
    const cover_arrays size = arrays_of(cover, layout);
    const size_t layers = cover->layers;
    memset(block, 0, size.full + size.best + size.dose);
    if (cover->full) {
        memcpy(block, cover->full, size.full);
    }
    if (cover->best) {
        memcpy(block + size.full, cover->best,
               layers * layout->slots * sizeof *cover->best);
    }
    if (cover->dose) {
        memcpy(block + size.full + size.best, cover->dose,
               layout->slots * sizeof *cover->dose);
    }
}

murk_cover murk_cover_unpack(const murk_cover *like, const murk_layout *layout,
                             char *block)
{
    const cover_arrays size = arrays_of(like, layout);
    void *full = block, *best = block + size.full,
         *dose = block + size.full + size.best;
    return (murk_cover){.layers = like->layers,
                        .full = like->full ? full : NULL,
                        .best = like->best ? best : NULL,
                        .dose = like->dose ? dose : NULL};
}

static uint64_t weigh_bits(uint64_t bits, const uint32_t *weight)
{
    uint64_t sum = 0;
    for (; bits; bits &= bits - 1) {
        sum += weight[__builtin_ctzll(bits)];
    }
    return sum;
}

uint64_t murk_cover_value(const murk_cover *cover, const murk_layout *layout)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < cover->layers; ++k) {
        for (size_t i = 0; cover->full && i < layout->words; ++i) {
            sum += weigh_bits(cover->full[k * layout->words + i],
                              layout->weight + 64 * i) *
                   MURK_CLEAR;
        }
        for (size_t i = 0; cover->best && i < layout->slots; ++i) {
            sum += (uint64_t)cover->best[k * layout->slots + i] *
                   layout->weight[i];
        }
    }
    return sum;
}
