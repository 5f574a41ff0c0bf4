/* The strict target: the fewest sensors such that a share of the photons, by
 * weight, is seen by at least k sensors each. (A target with redundancy k asks
 * for the mean of min(k, sensors) / k instead.)
 *
 * A photon counts as seen by a sensor if the sensor has an entry for the
 * photon, however small; `seen_by_at_least` of the results counts in the same
 * way.
 *
 * Let W be the weight of all photons, S the weight of photons seen by k or more
 * sensors, and V the sum of weight times min(k, sensors). Then
 *
 *     k S <= V <= S + (k - 1) W.
 *
 * V is submodular and S is not. A bound on V bounds S: if no plan of n sensors
 * has V of k times the target, no plan of n sensors meets the target. And a
 * plan with V of the target plus (k - 1) W meets the target. In between, for
 * each count in turn, MURK_PLACE_BEST improves plans that are good for V by
 * relocation for S (then V), and methods with branch and bound run it over V
 * and hand every plan with enough V to a callback that computes S. The linear
 * relaxations of both questions are equal, so the bound on V loses nothing
 * against a bound on S by linear relaxation. */
#ifndef MURK_PLACEMENT_AT_LEAST_H
#define MURK_PLACEMENT_AT_LEAST_H

#include "placement/settings.h"

/* The problem `of` with 0/1 entries and redundancy at_least,
 * 1..MURK_REDUNDANCY_MAX. Borrows `of`. problem.context points to *out, so *out
 * must not move. */
typedef struct murk_at_least {
    murk_problem problem;
    const murk_problem *of;
} murk_at_least;
void murk_at_least_init(murk_at_least *out, const murk_problem *of,
                        unsigned at_least);

/* Finds the plan. `matrix` is that of the problem made by murk_at_least_init().
 * desc->target is the smallest weight of photons seen by at least
 * problem->redundancy sensors, times MURK_CLEAR, > 0; a budget is not allowed.
 * All values and bounds of the result are such weights times MURK_CLEAR, and
 * `whole` is the weight of all photons times MURK_CLEAR. The curve begins at
 * the first count that is tried, which is at least k. Fails with MURK_BAD_VALUE
 * if the target cannot be reached, with MURK_RUN_FAILED if no plan that reaches
 * the target was found, or as murk_place_sensors() does. No method has a
 * guarantee; `fewest` always holds. */
murk_status murk_place_at_least(murk_place_result *result,
                                const murk_problem *problem,
                                const murk_matrix *matrix,
                                const murk_place_desc *desc, murk_error *err);

#endif
