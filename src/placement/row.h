/* One candidate's view as stored. */
#ifndef MURK_PLACEMENT_ROW_H
#define MURK_PLACEMENT_ROW_H

#include "placement/layout.h"

typedef enum murk_row_kind {
    MURK_ROW_BITS,      /* a bit a slot: seen clearly or not at all */
    MURK_ROW_PACKED,    /* a bit a slot, and the clarities of those seen */
    MURK_ROW_DENSE,     /* a clarity a slot */
    MURK_ROW_LIST,      /* seen slots with their clarities */
    MURK_ROW_CLEAR_LIST /* seen slots, all clearly */
} murk_row_kind;

typedef struct murk_row {
    murk_row_kind kind;
    size_t seen;
    size_t words;         /* BITS, PACKED: of bits */
    const uint64_t *bits; /* [words] */
    const uint32_t *at;   /* [words] rising: where each lies; NULL: word k
                             is the layout's word k */
    const uint32_t *segment_start; /* [segments + 1] with `at`: the first word
                            of each segment, and `words` */
    const uint16_t *clarity;       /* DENSE: [slots]; PACKED, LIST: [seen] */
    const uint32_t *slot;          /* [seen], distinct */
    void *memory;                  /* what free() takes; NULL where borrowed */
    size_t memory_bytes;
} murk_row;

/* A row that borrows the look; the layout keeps photons in place. */
murk_row murk_row_borrow(const murk_sparse_row *entries);

/* The smallest row that holds the look; false when out of memory. The caller
 * frees row->memory. */
bool murk_row_store(murk_row *out, const murk_layout *layout,
                    const murk_sparse_row *entries);
/* The bytes that murk_row_store() would take. */
size_t murk_row_bytes(const murk_layout *layout,
                      const murk_sparse_row *entries);

/* Where the k-th word of bits lies. */
static inline size_t murk_row_word(const murk_row *row, size_t k)
{
    return row->at ? row->at[k] : k;
}

/* A walk over what a row sees, slot by slot. */
typedef struct murk_row_walk {
    const murk_row *row;
    size_t at;               /* word of BITS and PACKED, else entry */
    size_t end;              /* of the others */
    uint64_t left;           /* bits of the word not yet met */
    const uint16_t *clarity; /* PACKED: the next one's */
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

/* The next slot with its clarity; false at the end. Of a DENSE row those not
 * seen come, too, with clarity 0. */
static inline bool murk_row_next(murk_row_walk *walk, size_t *slot,
                                 uint16_t *clarity)
{
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
