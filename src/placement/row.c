/* Stores the row of one candidate in one of five formats: bits, bits with
 * clarities, clarities for every slot, or lists of slots with or without
 * clarities. A row of bits may leave out the words without a set bit; such a
 * row is called sparse here, and `at` gives the place of each stored word. The
 * caller must use the row with the layout that it was stored for. */
#include "placement/row.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

bool murk_row_is_clear(const murk_sparse_row *entries)
{
    if (!entries->clarity) {
        return true;
    }
    for (size_t k = 0; k < entries->seen; ++k) {
        if (entries->clarity[k] != MURK_CLEAR) {
            return false;
        }
    }
    return true;
}

/* Bytes behind packed clarities that the wide loops may read: one vector
 * register of AVX-512. */
#define PACKED_PADDING 64

/* A row of bits without clarities is sparse if at most one word in three has a
 * set bit. With more set words the loops over neighbouring words are faster
 * than loops over `at`. A row with clarities is sparse if any word has no set
 * bit, because a word with clarities takes many times as long. */
#define WORDS_PER_SPARSE_WORD 3

/* The format of a row, and the sizes that follow from it. */
typedef struct row_format {
    murk_row_kind kind;
    bool is_sparse; /* only words with a set bit are stored */
    size_t words, bytes;
} row_format;

static size_t bytes_of_bits(const row_format *s, const murk_layout *layout)
{
    const size_t marks = s->is_sparse ? s->words + layout->segments + 1 : 0;
    return s->words * sizeof(uint64_t) + marks * sizeof(uint32_t);
}

/* Chooses the format, as a rule the one with the fewest bytes. A sparse word
 * takes 8 bytes and 4 for the place, shared by all set bits of the word; a list
 * takes 4 bytes an entry. Clarities add 2 bytes an entry. DENSE takes 2 bytes a
 * slot; if more than half of the slots have entries, that is less than twice
 * the size of PACKED, and faster. */
static row_format format_of(const murk_layout *layout, size_t seen,
                            bool is_clear, size_t words_used)
{
    /* Bits first, sparse where that pays. */
    row_format s = {.kind = is_clear ? MURK_ROW_BITS : MURK_ROW_PACKED,
                    .words = layout->words};
    s.is_sparse = is_clear ? words_used <= layout->words / WORDS_PER_SPARSE_WORD
                           : words_used < layout->words;
    if (s.is_sparse) {
        s.words = words_used;
    }
    s.bytes = bytes_of_bits(&s, layout);
    /* Lists if they take no more than bits; else DENSE for rows that are more
     * than half full and not all clear. */
    const size_t clarities = is_clear ? 0 : seen * sizeof(uint16_t);
    const size_t list = seen * sizeof(uint32_t);
    if (list <= s.bytes) {
        return (row_format){.kind =
                                is_clear ? MURK_ROW_CLEAR_LIST : MURK_ROW_LIST,
                            .bytes = list + clarities};
    }
    if (!is_clear && seen > layout->slots / 2) {
        return (row_format){.kind = MURK_ROW_DENSE,
                            .bytes = layout->slots * sizeof(uint16_t)};
    }
    s.bytes += is_clear ? 0 : clarities + PACKED_PADDING;
    return s;
}

murk_row murk_row_borrow(const murk_sparse_row *entries)
{
    return (murk_row){.kind = entries->clarity ? MURK_ROW_LIST
                                               : MURK_ROW_CLEAR_LIST,
                      .seen = entries->seen,
                      .clarity = entries->clarity,
                      .slot = entries->photon};
}

/* Sets a bit for each slot with an entry. Returns [layout->words], for free().
 * *words_used is the number of words with a set bit. */
static uint64_t *set_bits(const murk_layout *layout,
                          const murk_sparse_row *entries, size_t *words_used)
{
    uint64_t *bits = calloc(layout->words + 1, sizeof *bits);
    *words_used = 0;
    for (size_t k = 0; bits && k < entries->seen; ++k) {
        assert(entries->photon[k] < layout->photons);
        const size_t at = murk_layout_slot(layout, entries->photon[k]);
        *words_used += bits[at / 64] == 0;
        bits[at / 64] |= UINT64_C(1) << (at % 64);
    }
    return bits;
}

size_t murk_row_bytes(const murk_layout *layout, const murk_sparse_row *entries)
{
    size_t words_used;
    free(set_bits(layout, entries, &words_used));
    return format_of(layout, entries->seen, murk_row_is_clear(entries),
                     words_used)
        .bytes;
}

/* Writes the clarities in the order of the slots. dense[slots] is scratch. */
static void fill_packed(uint16_t *clarity, const uint64_t *bits,
                        uint16_t *dense, const murk_layout *layout,
                        const murk_sparse_row *entries)
{
    for (size_t k = 0; k < entries->seen; ++k) {
        dense[murk_layout_slot(layout, entries->photon[k])] =
            entries->clarity[k];
    }
    for (size_t k = 0; k < layout->words; ++k) {
        const uint16_t *word = dense + 64 * k;
        for (uint64_t left = bits[k]; left; left &= left - 1) {
            *clarity++ = word[__builtin_ctzll(left)];
        }
    }
}

static void store_bits(murk_row *row, const row_format *s,
                       const murk_layout *layout, const uint64_t *bits)
{
    uint64_t *words = row->memory;
    row->words = s->words;
    row->bits = words;
    if (!s->is_sparse) {
        memcpy(words, bits, s->words * sizeof *words);
        return;
    }
    /* Sparse: the memory holds the words with a set bit, then the place of each
     * of these words in the layout, then the index of the first stored word of
     * each segment. */
    uint32_t *at = (uint32_t *)(words + s->words),
             *segment_start = at + s->words;
    row->at = at;
    row->segment_start = segment_start;
    size_t n = 0;
    for (size_t i = 0; i < layout->segments; ++i) {
        const murk_weight_run *segment = &layout->segment[i];
        segment_start[i] = (uint32_t)n;
        for (size_t k = segment->first_word;
             k < segment->first_word + segment->words; ++k) {
            if (bits[k]) {
                words[n] = bits[k];
                at[n++] = (uint32_t)k;
            }
        }
    }
    segment_start[layout->segments] = (uint32_t)n;
}

/* The packed clarities lie behind the bits. False when out of memory. */
static bool store_packed(murk_row *row, const row_format *s,
                         const murk_layout *layout, const uint64_t *bits,
                         const murk_sparse_row *entries)
{
    uint16_t *dense = malloc(layout->slots * sizeof *dense + 1);
    if (!dense) {
        return false;
    }
    uint16_t *clarity =
        (uint16_t *)((char *)row->memory + bytes_of_bits(s, layout));
    fill_packed(clarity, bits, dense, layout, entries);
    row->clarity = clarity;
    free(dense);
    return true;
}

static void store_dense(murk_row *row, const murk_layout *layout,
                        const murk_sparse_row *entries)
{
    uint16_t *dense = row->memory;
    for (size_t k = 0; k < entries->seen; ++k) {
        dense[murk_layout_slot(layout, entries->photon[k])] =
            entries->clarity[k];
    }
    row->clarity = dense;
}

static void store_list(murk_row *row, const murk_layout *layout,
                       const murk_sparse_row *entries)
{
    uint32_t *slot = row->memory;
    for (size_t k = 0; k < entries->seen; ++k) {
        slot[k] = (uint32_t)murk_layout_slot(layout, entries->photon[k]);
    }
    row->slot = slot;
    if (row->kind == MURK_ROW_LIST) {
        uint16_t *clarity = (uint16_t *)(slot + entries->seen);
        memcpy(clarity, entries->clarity, entries->seen * sizeof *clarity);
        row->clarity = clarity;
    }
}

bool murk_row_store(murk_row *out, const murk_layout *layout,
                    const murk_sparse_row *entries)
{
    /* One bit a slot: the choice of the format needs the number of words with a
     * set bit, and BITS and PACKED store these bits. */
    size_t words_used;
    uint64_t *bits = set_bits(layout, entries, &words_used);
    if (!bits) {
        return false;
    }
    const row_format s = format_of(layout, entries->seen,
                                   murk_row_is_clear(entries), words_used);
    murk_row row = {.kind = s.kind,
                    .seen = entries->seen,
                    .memory = murk_aligned_zeros(s.bytes),
                    .memory_bytes = s.bytes};
    bool is_stored = row.memory;
    /* Fill the one block of memory in the chosen format. */
    if (is_stored && s.words > 0) {
        store_bits(&row, &s, layout, bits);
        is_stored = s.kind == MURK_ROW_BITS ||
                    store_packed(&row, &s, layout, bits, entries);
    } else if (is_stored && s.kind == MURK_ROW_DENSE) {
        store_dense(&row, layout, entries);
    } else if (is_stored) {
        store_list(&row, layout, entries);
    }
    free(bits);
    if (!is_stored) {
        free(row.memory);
        return false;
    }
    *out = row;
    return true;
}

/* ---- patches ---- */

/* A word of the row before, and the same word after the patch. */
typedef struct patched_word {
    uint64_t before, now;
    bool is_same; /* with the same clarities */
} patched_word;

/* Word w; *k is the number of the next stored word of the row before. */
static patched_word patch_word(const murk_row *before,
                               const murk_row_patching *p, size_t w, size_t *k)
{
    const bool is_stored = *k < before->words && murk_row_word(before, *k) == w;
    const uint64_t old = is_stored ? before->bits[(*k)++] : 0;
    return (patched_word){old, (old & ~p->clear[w]) | p->set[w],
                          !((old & p->clear[w]) | p->set[w])};
}

/* The clarities of the patched row, which may be those of the row before. */
static void patch_clarities(uint16_t *to, const murk_layout *layout,
                            const murk_row *before, const murk_row_patching *p)
{
    const uint16_t *from = before->clarity;
    size_t k = 0;
    for (size_t w = 0; w < layout->words; ++w) {
        const patched_word word = patch_word(before, p, w, &k);
        if (word.is_same) {
            const size_t n = (size_t)__builtin_popcountll(word.before);
            memcpy(to, from, n * sizeof *to);
            to += n;
            from += n;
            continue;
        }
        for (uint64_t left = word.before | word.now; left; left &= left - 1) {
            const size_t bit = (size_t)__builtin_ctzll(left);
            const uint16_t old = word.before >> bit & 1 ? *from++ : 0;
            if (word.now >> bit & 1) {
                *to++ = p->set[w] >> bit & 1 ? p->come[64 * w + bit] : old;
            }
        }
    }
}

/* True if the row is PACKED before and after the patch, and stored; words that
 * no entry changes are then copied as they are. */
static bool store_patched_packed(murk_row *out, const murk_layout *layout,
                                 const murk_row *before,
                                 const murk_row_patching *p)
{
    size_t k = 0, words_used = 0, seen = 0;
    if (before->kind != MURK_ROW_PACKED) {
        return false;
    }
    for (size_t w = 0; w < layout->words; ++w) {
        p->bits[w] = patch_word(before, p, w, &k).now;
        if (p->bits[w]) {
            ++words_used;
            seen += (size_t)__builtin_popcountll(p->bits[w]);
        }
    }
    const row_format s = format_of(layout, seen, false, words_used);
    murk_row row = {.kind = s.kind,
                    .seen = seen,
                    .memory = s.kind == MURK_ROW_PACKED
                                  ? murk_aligned_zeros(s.bytes)
                                  : NULL,
                    .memory_bytes = s.bytes};
    if (!row.memory) {
        return false;
    }
    /* The bits, then the clarities behind them. */
    store_bits(&row, &s, layout, p->bits);
    uint16_t *clarity =
        (uint16_t *)((char *)row.memory + bytes_of_bits(&s, layout));
    patch_clarities(clarity, layout, before, p);
    row.clarity = clarity;
    if (murk_row_is_clear(&(murk_sparse_row){seen, NULL, clarity})) {
        free(row.memory); /* another format */
        return false;
    }
    *out = row;
    return true;
}

bool murk_row_store_patched(murk_row *out, const murk_layout *layout,
                            const murk_row *before,
                            const murk_layout *layout_before,
                            const murk_row_patching *p)
{
    if (store_patched_packed(out, layout, before, p)) {
        return true;
    }
    /* List the entries that stay, then those that come, and store them as if
     * photons had the numbers of their slots. */
    size_t n = 0, slot;
    uint16_t clarity;
    for (murk_row_walk walk = murk_row_begin(layout_before, before);
         murk_row_next(&walk, &slot, &clarity);) {
        if (clarity > 0 && !(p->clear[slot / 64] >> (slot % 64) & 1)) {
            p->slot[n] = (uint32_t)slot;
            p->clarity[n++] = clarity;
        }
    }
    for (size_t w = 0; w < layout->words; ++w) {
        for (uint64_t left = p->set[w]; left; left &= left - 1) {
            slot = 64 * w + (size_t)__builtin_ctzll(left);
            p->slot[n] = (uint32_t)slot;
            p->clarity[n++] = p->come[slot];
        }
    }
    murk_layout by_slot = *layout;
    by_slot.photons = layout->slots;
    by_slot.slot = NULL;
    return murk_row_store(out, &by_slot,
                          &(murk_sparse_row){n, p->slot, p->clarity});
}
