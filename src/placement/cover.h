/* A cover: the coverage of each photon by a set of candidates.
 *
 * A cover with k layers holds the k largest entries of each photon; the lowest
 * layer has the smallest of them. For any k, the gain of a further row is the
 * sum over the photons of weight times the amount by which the row's entry
 * exceeds the lowest layer. With detection probabilities a cover holds the sum
 * of the doses (placement/dose.h) of each photon instead. */
#ifndef MURK_PLACEMENT_COVER_H
#define MURK_PLACEMENT_COVER_H

#include "placement/row.h"

typedef struct murk_cover {
    size_t layers;  /* entries of a photon that count, >= 1 */
    uint64_t *full; /* [layers][words], lowest layer first: a bit for each slot
                       with MURK_CLEAR; all rows must be BITS or CLEAR_LIST;
                       NULL if `best` is in use */
    uint16_t *best; /* [layers][slots], lowest layer first: clarities; with
                       doses one layer, the worth of the dose; NULL if `full` is
                       in use */
    uint32_t *dose; /* [slots] for detection probabilities, else NULL */
} murk_cover;

/* An empty cover with the layers, and the doses if any, of the layout; of bits
 * with is_binary. False when out of memory. */
bool murk_cover_init(murk_cover *out, const murk_layout *layout,
                     bool is_binary);
/* The same with one layer and without doses, whatever layers and doses the
 * layout has. */
bool murk_cover_init_single(murk_cover *out, const murk_layout *layout,
                            bool is_binary);
void murk_cover_release(murk_cover *cover);
void murk_cover_clear(murk_cover *cover, const murk_layout *layout);
/* Both covers must have the same form. */
void murk_cover_copy(murk_cover *to, const murk_layout *layout,
                     const murk_cover *from);
void murk_cover_add(murk_cover *cover, const murk_layout *layout,
                    const murk_row *row);
/* Adds the rows that make up another cover; no candidate may be in both. Both
 * covers must have the same number of layers and the same arrays. */
void murk_cover_join(murk_cover *cover, const murk_layout *layout,
                     const murk_cover *other);

/* The arrays of a cover in one block of murk_cover_bytes(), a multiple of 8. A
 * cover of the form of `like` borrows the arrays of such a block, which must be
 * aligned to 8 bytes. */
size_t murk_cover_bytes(const murk_cover *cover, const murk_layout *layout);
void murk_cover_pack(const murk_cover *cover, const murk_layout *layout,
                     char *block);
murk_cover murk_cover_unpack(const murk_cover *like, const murk_layout *layout,
                             char *block);

/* The value of the cover: the sum over the slots of weight times the sum of the
 * layers. */
uint64_t murk_cover_value(const murk_cover *cover, const murk_layout *layout);

#endif
