/* What one row has that a cover lacks. */
#ifndef MURK_PLACEMENT_GAIN_H
#define MURK_PLACEMENT_GAIN_H

#include "placement/cover.h"

/* What the row would add to the cover's worth: sum weight * max(0, clarity -
 * lowest layer), or of doses what they are worth together, less best. */
uint64_t murk_row_gain(const murk_layout *layout, const murk_row *row,
                       const murk_cover *cover);

/* Not less than murk_row_gain, less MURK_GAIN_BOUND_SLACK a photon that the row
 * sees; for covers with doses, where it is many times quicker. */
#define MURK_GAIN_BOUND_SLACK 4
uint64_t murk_row_gain_bound(const murk_layout *layout, const murk_row *row,
                             const murk_cover *cover);

/* The weight of all that the row sees. */
uint64_t murk_row_weight(const murk_layout *layout, const murk_row *row);

/* Adds 1 to count[slot] where the row is clearer than best. */
void murk_row_count_above(const murk_layout *layout, const murk_row *row,
                          const uint16_t *best, uint16_t *count);

/* Whether every photon has a clarity of at most the lowest layer in the row;
 * for covers without doses. */
bool murk_row_is_covered(const murk_layout *layout, const murk_row *row,
                         const murk_cover *cover);

#endif
