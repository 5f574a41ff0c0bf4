/* Fills the tables that turn clarities into doses and doses into clarities. The
 * worth of a dose is linear between nodes of -expm1(-dose); the dose of a
 * clarity is the smallest dose with that worth, found by a walk along both
 * tables. All values are whole numbers; the nodes and `below` are rounded down.
 */
#include "placement/dose.h"

#include <math.h>

/* Margin subtracted before rounding down, in units of the result: far above the
 * error of expm1() and log1p() (below 1e-5 units), far below one unit. */
#define ROUNDING_MARGIN 0x1p-10

static uint32_t floor_of(double value)
{
    return value > ROUNDING_MARGIN ? (uint32_t)floor(value - ROUNDING_MARGIN)
                                   : 0;
}

/* The first step of the table is the steepest: 65535 * 64 units, times 1023. */
_Static_assert((uint64_t)MURK_CLEAR * 65536 * MURK_DOSE_STEP / MURK_DOSE_ONE *
                       (MURK_DOSE_STEP - 1) <
                   UINT32_MAX,
               "the rise between nodes fits 32 bits");

void murk_doses_fill(murk_doses *out)
{
    /* Worth at the nodes. */
    for (uint32_t k = 0; k < MURK_DOSE_NODES; ++k) {
        const double dose = (double)k * MURK_DOSE_STEP / MURK_DOSE_ONE;
        out->node[k] = floor_of(-expm1(-dose) * MURK_CLEAR * 65536);
    }
    /* Doses of all clarities. The worth rises by at most 1/16 unit per unit of
     * dose, so every clarity is the worth of some dose. */
    uint32_t dose = 0;
    for (uint32_t p = 0; p < MURK_CLEAR; ++p) {
        out->below[p] =
            floor_of(-log1p(-(double)p / MURK_CLEAR) * MURK_DOSE_ONE);
        dose = out->below[p] > dose ? out->below[p] : dose;
        while (murk_dose_worth(out, dose) < p) {
            ++dose;
        }
        out->of[p] = dose;
    }
    out->of[MURK_CLEAR] = out->below[MURK_CLEAR] = MURK_DOSE_FULL;
}
