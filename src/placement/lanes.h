/* Gains of every candidate over up to MURK_COVER_LANES covers at once: each
 * entry of a row is read once for all covers, which lie side by side in memory.
 *
 * The gains are those of murk_evaluator_gains(), several times faster for each
 * cover. For rows of clarities without doses; for 0/1 rows evaluating each
 * cover alone is as fast. */
#ifndef MURK_PLACEMENT_LANES_H
#define MURK_PLACEMENT_LANES_H

#include "placement/evaluator.h"

/* With fewer covers than this, evaluating each cover alone is as fast: a row of
 * clarities over one cover takes a fifth of the time of the row over all lanes.
 */
#define MURK_LANES_MIN 5

typedef struct murk_lanes {
    const murk_evaluator *evaluator;
    uint16_t *best; /* [slots][MURK_COVER_LANES] lowest layer of each cover */
    uint64_t *gain; /* [candidates][MURK_COVER_LANES] of the last call */
    size_t covers;  /* of the present call */
    const murk_cover *const *cover; /* [covers] */
} murk_lanes;

/* True if all covers side by side, with a cover for each lane elsewhere, are
 * small beside the rows, and the rows are of a kind for which lanes pay. */
bool murk_lanes_pay(const murk_evaluator *evaluator);

/* Fails with MURK_NO_MEMORY. */
murk_status murk_lanes_init(murk_lanes *out, const murk_evaluator *evaluator,
                            murk_error *err);
void murk_lanes_release(murk_lanes *lanes);

/* lanes->gain[candidate * MURK_COVER_LANES + k] = the gain of the candidate
 * over cover[k], for all candidates and k < n; n is at most MURK_COVER_LANES.
 */
void murk_lanes_gains(murk_lanes *lanes, const murk_cover *const *cover,
                      size_t n);

#endif
