/* The gain of one row over one cover: the increase of the cover's value if the
 * row is added. */
#ifndef MURK_PLACEMENT_GAIN_H
#define MURK_PLACEMENT_GAIN_H

#include "placement/cover.h"

/* The gain: the sum over photons of weight * max(0, clarity in the row - lowest
 * layer of the cover). With detection probabilities: the value of the cover
 * after the doses of the row are added, minus the value before. */
uint64_t murk_row_gain(const murk_layout *layout, const murk_row *row,
                       const murk_cover *cover);

/* For covers with doses, and many times faster than murk_row_gain(): a number
 * from which an upper bound follows. The gain is at most this number plus
 * MURK_GAIN_BOUND_SLACK times the sum of the weights of the photons in the row
 * (murk_row_weight()). placement/gain.c derives the 4. */
#define MURK_GAIN_BOUND_SLACK 4
uint64_t murk_row_gain_bound(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover);

/* The sum of the weights of the photons in the row. */
uint64_t murk_row_weight(const murk_layout *layout, const murk_row *row);

/* Adds 1 to count[slot] for each slot whose clarity in the row exceeds
 * best[slot]. */
void murk_row_count_above(const murk_layout *layout, const murk_row *row,
                          const uint16_t *best, uint16_t *count);

/* True if no clarity of the row exceeds the lowest layer of the cover: the gain
 * is 0. For covers without doses. */
bool murk_row_is_covered(const murk_layout *layout, const murk_row *row,
                         const murk_cover *cover);

#endif
