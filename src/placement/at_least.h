/* The fewest sensors so that a share of the photons, by weight, is seen by at
 * least k of them each: the strict question beside a target with redundancy k,
 * which asks for the mean of min(k, views) / k.
 *
 * A photon counts as seen wherever a look has it, however dim: that is what
 * seen_by_at_least counts, too.
 *
 * With W the weight of all, S that of photons seen by k or more and V the sum
 * of weight times min(k, views),
 *
 *     k S <= V <= S + (k - 1) W.
 *
 * V is submodular, S is not. So a bound on V bounds S: where no plan of n
 * sensors has V of k times the target, none of n meets the target. And a plan
 * with V of the target plus (k - 1) W meets it. In between, for each count in
 * turn, plans that are good for V are moved, one sensor at a time, to where S
 * is more (then V), and branch and bound over V shows every plan whose V is
 * enough to a judge that weighs S. (The linear relaxations of both questions
 * are the same, so the bound on V loses nothing against that of S.) */
#ifndef MURK_PLACEMENT_AT_LEAST_H
#define MURK_PLACEMENT_AT_LEAST_H

#include "placement/settings.h"

/* `problem` as the strict question sees it: views are clear or none, and
 * at_least, 1..MURK_REDUNDANCY_MAX, of a photon count. Borrows `of`. */
typedef struct murk_at_least {
    murk_problem problem;
    const murk_problem *of;
} murk_at_least;
void murk_at_least_init(murk_at_least *out, const murk_problem *of,
                        unsigned at_least);

/* The plan; `matrix` is that of `problem`, which murk_at_least_init() made.
 * desc->target is the least weight of photons seen by at least
 * problem->redundancy sensors, times MURK_CLEAR, > 0; not with a budget.
 * All values and bounds of the result are such weights times MURK_CLEAR, and
 * `whole` is all weight times MURK_CLEAR. The curve begins at the first count
 * tried. No method has a guarantee; `fewest` holds always. */
murk_status murk_place_at_least(murk_place_result *result,
                                const murk_problem *problem,
                                const murk_matrix *matrix,
                                const murk_place_desc *desc, murk_error *err);

#endif
