/* Doses: detection probabilities in a form that adds up.
 *
 * Sensors that detect a photon independently with probabilities p_j detect it
 * together with probability 1 - prod (1 - p_j) = 1 - exp(-sum d_j), where d_j =
 * -ln(1 - p_j) is called the dose. Doses are stored as whole numbers, in units
 * of 1 / MURK_DOSE_ONE, so a sum does not depend on the order.
 * murk_dose_worth() turns a dose into a clarity. The worth never falls as the
 * dose grows, and the dose of one clarity is worth exactly that clarity. The
 * worth lies less than MURK_WORTH_ERROR below MURK_CLEAR (1 - exp(-dose)) and,
 * for a dose that counts as certainty, less than .008 above. */
#ifndef MURK_PLACEMENT_DOSE_H
#define MURK_PLACEMENT_DOSE_H

#include "placement/problem.h"

/* The dose 1.0, and the dose that stands for certainty. 65535 exp(-16) < .008
 * clarity units, so a dose of 16 taken for certainty changes a worth by less
 * than that. Sums of doses stop at MURK_DOSE_FULL. */
#define MURK_DOSE_ONE  (UINT32_C(1) << 20)
#define MURK_DOSE_FULL (16 * MURK_DOSE_ONE)

/* Error of murk_dose_worth() in clarity units: less than 1 by rounding down,
 * less than .008 by linear interpolation between nodes, 65535 / 1024^2 / 8. */
#define MURK_WORTH_ERROR 1.01

/* The most by which rounding lets a gain grow when other sensors are added;
 * without rounding a gain never grows. A gain is the difference of two worths
 * (murk_dose_worth()). Each worth is less than MURK_WORTH_ERROR too low or, if
 * a dose counts as certainty, less than .008 too high. The difference of two
 * gains is therefore wrong by less than 3, and as a whole number by at most 2.
 */
#define MURK_WORTH_SLACK 2

#define MURK_DOSE_STEP 1024 /* dose between two nodes */
/* Nodes of the table from dose 0 to MURK_DOSE_FULL. */
#define MURK_DOSE_NODES (MURK_DOSE_FULL / MURK_DOSE_STEP + 1)

typedef struct murk_doses {
    uint32_t of[MURK_CLEAR + 1];    /* the smallest dose with this worth */
    uint32_t below[MURK_CLEAR + 1]; /* -ln(1 - clarity / MURK_CLEAR), rounded
                                       down; MURK_DOSE_FULL for the last */
    uint32_t node[MURK_DOSE_NODES]; /* worth in units of 2^-16 */
} murk_doses;

void murk_doses_fill(murk_doses *out);

/* The worth of a dose of at most MURK_DOSE_FULL, 0..MURK_CLEAR. */
static inline uint16_t murk_dose_worth(const murk_doses *doses, uint32_t dose)
{
    if (dose == MURK_DOSE_FULL) {
        return MURK_CLEAR;
    }
    const uint32_t *node = &doses->node[dose / MURK_DOSE_STEP];
    const uint32_t rise = (node[1] - node[0]) * (dose % MURK_DOSE_STEP);
    return (uint16_t)((node[0] + rise / MURK_DOSE_STEP) >> 16);
}

/* The sum of two doses of at most MURK_DOSE_FULL each, cut at
 * MURK_DOSE_FULL. */
static inline uint32_t murk_dose_add(uint32_t a, uint32_t b)
{
    return a + b < MURK_DOSE_FULL ? a + b : MURK_DOSE_FULL;
}

#endif
