/* Chances as doses, which simply add up.
 *
 * Sensors that each see a photon with chance p_j, independently, see it with
 * chance 1 - prod (1 - p_j) = 1 - exp(-sum d_j), d_j = -ln(1 - p_j). Doses are
 * whole numbers, so a sum does not depend on its order. What a dose is worth is
 * a clarity, in whole units: it never falls as doses grow, lies less than
 * MURK_WORTH_ERROR below MURK_CLEAR (1 - exp(-dose)) and not above it, and one
 * clarity's own dose is worth exactly that clarity. */
#ifndef MURK_PLACEMENT_DOSE_H
#define MURK_PLACEMENT_DOSE_H

#include "placement/problem.h"

/* A dose of 1, and the one that is certainty: 65535 exp(-16) < .008, so taking
 * it for that moves a worth by less. Sums stay there. */
#define MURK_DOSE_ONE  (UINT32_C(1) << 20)
#define MURK_DOSE_FULL (16 * MURK_DOSE_ONE)

/* The chord between nodes: 65535 / 1024^2 / 8 < .008; rounding down: 1. */
#define MURK_WORTH_ERROR 1.01

/* Gains may grow as others join, by rounding alone: two worths, each off by
 * less than MURK_WORTH_ERROR one way and less than .008 the other, so a
 * difference of differences is off by less than 3 and whole. */
#define MURK_WORTH_SLACK 2

#define MURK_DOSE_STEP  1024 /* between nodes */
#define MURK_DOSE_NODES (MURK_DOSE_FULL / MURK_DOSE_STEP + 1)

typedef struct murk_doses {
    uint32_t of[MURK_CLEAR + 1];    /* the least worth that clarity */
    uint32_t below[MURK_CLEAR + 1]; /* -ln(1 - clarity / MURK_CLEAR) rounded
                                       down; MURK_DOSE_FULL for the last */
    uint32_t node[MURK_DOSE_NODES]; /* worth, in 2^-16 */
} murk_doses;

void murk_doses_fill(murk_doses *out);

/* For dose up to MURK_DOSE_FULL. */
static inline uint16_t murk_dose_worth(const murk_doses *doses, uint32_t dose)
{
    if (dose == MURK_DOSE_FULL) {
        return MURK_CLEAR;
    }
    const uint32_t *node = &doses->node[dose / MURK_DOSE_STEP];
    const uint32_t rise = (node[1] - node[0]) * (dose % MURK_DOSE_STEP);
    return (uint16_t)((node[0] + rise / MURK_DOSE_STEP) >> 16);
}

/* Both up to MURK_DOSE_FULL. */
static inline uint32_t murk_dose_add(uint32_t a, uint32_t b)
{
    return a + b < MURK_DOSE_FULL ? a + b : MURK_DOSE_FULL;
}

#endif
