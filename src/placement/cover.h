/* Covers: how well each photon is seen by a set of candidates.
 *
 * A layered cover holds the clearest views of each photon, its lowest layer
 * the last of those that count: what a further row adds to the cover's worth
 * is what it has above that layer, whatever their number (a weighted rank,
 * summed over photons). */
#ifndef MURK_PLACEMENT_COVER_H
#define MURK_PLACEMENT_COVER_H

#include "placement/row.h"

typedef struct murk_cover {
    size_t layers;  /* views of a photon that count, >= 1 */
    uint64_t *full; /* [layers][words] a bit where seen clearly (all rows must
                       be BITS or CLEAR_LIST), the lowest layer first; or */
    uint16_t *best; /* [layers][slots] clarities, the lowest first; with doses
                       one layer: what they are worth */
    uint32_t *dose; /* [slots] where chances are independent, else NULL */
} murk_cover;

/* Empty, of the layout's objective; as bits where all_clear. False when out of
 * memory. */
bool murk_cover_init(murk_cover *out, const murk_layout *layout,
                     bool is_binary);
/* The same, but of the clearest view alone, whatever the objective. */
bool murk_cover_init_single(murk_cover *out, const murk_layout *layout,
                            bool is_binary);
void murk_cover_release(murk_cover *cover);
void murk_cover_clear(murk_cover *cover, const murk_layout *layout);
/* Both of one form. */
void murk_cover_copy(murk_cover *to, const murk_layout *layout,
                     const murk_cover *from);
void murk_cover_add(murk_cover *cover, const murk_layout *layout,
                    const murk_row *row);
/* Adds what other holds, of other candidates; both of one form. */
void murk_cover_join(murk_cover *cover, const murk_layout *layout,
                     const murk_cover *other);

/* What the cover is worth: sum weight * its layers. */
uint64_t murk_cover_value(const murk_cover *cover, const murk_layout *layout);

#endif
