/* One candidate's view as stored, and covers: how well each photon is seen by
 * a set of candidates. */
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
    const uint64_t *bits;    /* [words]: BITS, PACKED */
    const uint16_t *clarity; /* DENSE: [slots]; PACKED, LIST: [seen] */
    const uint32_t *slot;    /* [seen], distinct */
    void *memory;            /* what free() takes; NULL where borrowed */
    size_t memory_bytes;
} murk_row;

/* A row that borrows the look; the layout keeps photons in place. */
murk_row murk_row_borrow(const murk_look *look);

/* The smallest row that holds the look; false when out of memory. The caller
 * frees row->memory. */
bool murk_row_store(murk_row *out, const murk_layout *layout,
                    const murk_look *look);
/* The bytes that murk_row_store() would take. */
size_t murk_row_bytes(const murk_layout *layout, const murk_look *look);

/* Either bits (full: seen clearly; all rows must be BITS or CLEAR_LIST) or the
 * best clarity of each slot. */
typedef struct murk_cover {
    uint64_t *full; /* [words], or NULL */
    uint16_t *best; /* [slots], or NULL */
} murk_cover;

bool murk_cover_init(murk_cover *out, const murk_layout *layout,
                     bool all_clear);
void murk_cover_release(murk_cover *cover);
void murk_cover_clear(murk_cover *cover, const murk_layout *layout);
void murk_cover_add(murk_cover *cover, const murk_layout *layout,
                    const murk_row *row);

/* What the cover is worth: sum weight * best. */
uint64_t murk_cover_value(const murk_cover *cover, const murk_layout *layout);
/* Raises cover to other, photon by photon; both of one form. */
void murk_cover_join(murk_cover *cover, const murk_layout *layout,
                     const murk_cover *other);

/* What the row would add to the cover: sum weight * max(0, clarity - best). */
uint64_t murk_row_gain(const murk_layout *layout, const murk_row *row,
                       const murk_cover *cover);

/* Adds 1 to count[slot] where the row is clearer than best. */
void murk_row_count_above(const murk_layout *layout, const murk_row *row,
                          const uint16_t *best, uint16_t *count);

/* Whether every photon has a clarity of at most `best` in the row. */
bool murk_row_within(const murk_layout *layout, const murk_row *row,
                     const murk_cover *cover);

#endif
