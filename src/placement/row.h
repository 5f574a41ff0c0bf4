/* A row of the coverage matrix in storage form: the entries of one candidate,
 * by slots of the layout (placement/layout.h), in one of five formats. */
#ifndef MURK_PLACEMENT_ROW_H
#define MURK_PLACEMENT_ROW_H

#include "placement/layout.h"

typedef enum murk_row_kind {
    MURK_ROW_BITS,      /* one bit a slot: the entry is MURK_CLEAR or 0 */
    MURK_ROW_PACKED,    /* one bit a slot, and the clarities of the set bits */
    MURK_ROW_DENSE,     /* one clarity a slot, 0 included */
    MURK_ROW_LIST,      /* slots with an entry, and their clarities */
    MURK_ROW_CLEAR_LIST /* slots with an entry, all MURK_CLEAR */
} murk_row_kind;

typedef struct murk_row {
    murk_row_kind kind;
    bool is_in_file; /* the block lies in a file (placement/row_space.h) */
    size_t seen;
    size_t words;         /* of bits; BITS and PACKED only */
    const uint64_t *bits; /* [words] */
    const uint32_t *at; /* [words], increasing: word k of bits is word at[k] of
                           the layout; NULL: word k of bits is word k of the
                           layout */
    const uint32_t
        *segment_start; /* [segments + 1], with `at` only: index in bits[] of
                           the first stored word of each segment of the layout;
                           the last element is `words` */
    const uint16_t *clarity; /* DENSE: [slots]; PACKED, LIST: [seen] */
    const uint32_t *slot;    /* [seen], distinct; LIST and CLEAR_LIST only */
    void *memory;            /* the block that has all arrays; for free() unless
                                is_in_file; NULL if borrowed */
    size_t memory_bytes;
} murk_row;

/* A row that borrows the arrays of `entries`. The layout must keep each photon
 * i in slot i. */
murk_row murk_row_borrow(const murk_sparse_row *entries);

/* Stores the entries in the format that needs least memory as a rule, with
 * exceptions that are faster to evaluate: of MURK_ROW_BITS all words are stored
 * if more than a third of them have a set bit, of MURK_ROW_PACKED only words
 * with a set bit, and a row with entries in more than half of the slots is
 * MURK_ROW_DENSE unless all its clarities are MURK_CLEAR. False when out of
 * memory. The caller frees out->memory. */
bool murk_row_store(murk_row *out, const murk_layout *layout,
                    const murk_sparse_row *entries);

/* How a row of an earlier layout becomes one of a layout of
 * murk_layout_patch(), by slots of the latter; and scratch memory. */
typedef struct murk_row_patching {
    uint64_t *clear, *set; /* [words] slots whose entry ends, and, of slots that
                            * had none or whose entry ends, those that get one
                            */
    uint16_t *come;        /* [slots] the clarity of slots of `set` */
    uint64_t *bits;        /* [words] scratch */
    uint32_t *slot;        /* [slots] scratch */
    uint16_t *clarity;     /* [slots] scratch */
} murk_row_patching;

/* As murk_row_store(), but for the row `before` with a patch. */
bool murk_row_store_patched(murk_row *out, const murk_layout *layout,
                            const murk_row *before,
                            const murk_layout *layout_before,
                            const murk_row_patching *patching);

/* True if all clarities are MURK_CLEAR. */
bool murk_row_is_clear(const murk_sparse_row *entries);
/* The most bytes that a row takes, whatever its entries. */
static inline size_t murk_row_bytes_max(const murk_layout *layout)
{
    return sizeof(murk_row) + 64 + layout->slots * sizeof(uint16_t);
}

/* The number of bytes that murk_row_store() would allocate. */
size_t murk_row_bytes(const murk_layout *layout,
                      const murk_sparse_row *entries);

/* The word of the layout that holds word k of bits. */
static inline size_t murk_row_word(const murk_row *row, size_t k)
{
    return row->at ? row->at[k] : k;
}

/* Iterator over the entries of a row. */
typedef struct murk_row_walk {
    const murk_row *row;
    size_t at;     /* BITS and PACKED: index of the word; DENSE: of the slot;
                      else of the entry */
    size_t end;    /* DENSE: number of slots; lists: number of entries; else not
                      used */
    uint64_t left; /* bits of the word that are still to come */
    const uint16_t *clarity; /* PACKED: clarity of the next entry */
} murk_row_walk;

static inline murk_row_walk murk_row_begin(const murk_layout *layout,
                                           const murk_row *row)
{
    const bool has_bits =
        row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_PACKED;
    return (murk_row_walk){
        .row = row,
        .end = row->kind == MURK_ROW_DENSE ? layout->slots : row->seen,
        .left = has_bits && row->words > 0 ? row->bits[0] : 0,
        .clarity = row->clarity};
}

/* Gives the next slot and its clarity; false at the end. A DENSE row also gives
 * slots without an entry, with clarity 0. */
static inline bool murk_row_next(murk_row_walk *walk, size_t *slot,
                                 uint16_t *clarity)
{
    /* BITS and PACKED: the lowest bit that remains in the word, or the lowest
     * bit of the next word that has any. */
    const murk_row *row = walk->row;
    if (row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_PACKED) {
        while (walk->left == 0) {
            if (walk->at + 1 >= row->words) {
                return false;
            }
            walk->left = row->bits[++walk->at];
        }
        *slot = 64 * murk_row_word(row, walk->at) +
                (size_t)__builtin_ctzll(walk->left);
        walk->left &= walk->left - 1;
        *clarity = row->kind == MURK_ROW_PACKED ? *walk->clarity++ : MURK_CLEAR;
        return true;
    }
    /* Other formats: the next entry. */
    if (walk->at >= walk->end) {
        return false;
    }
    *slot = row->kind == MURK_ROW_DENSE ? walk->at : row->slot[walk->at];
    *clarity =
        row->kind == MURK_ROW_CLEAR_LIST ? MURK_CLEAR : row->clarity[walk->at];
    ++walk->at;
    return true;
}

#endif
