/* Placement for the worst scenario: maximises the smallest worth of the blocks
 * (placement/blocks.h), for the coverage itself or for the regret.
 *
 * MURK_PLACE_GREEDY tries greedy on the mean of the blocks, then greedy towards
 * a level in all blocks, and finds the highest level that greedy reaches by
 * bisection (with a target: only greedy towards the target; with a budget and
 * no target also greedy by gain per cost). MURK_PLACE_BEST adds greedy on each
 * block, and random starts; relocates each plan; and ends with branch and
 * bound. MURK_PLACE_EXACT is greedy and branch and bound. MURK_PLACE_SPOQ is
 * one random start, relocated. With a start plan MURK_PLACE_BEST relocates that
 * plan, which stays on ties, and greedy's plans, and makes neither greedy on
 * each block nor random starts nor branch and bound; MURK_PLACE_SPOQ relocates
 * the start plan alone, and MURK_PLACE_EXACT adds it to greedy. No fraction of
 * the optimum is guaranteed; the bound always holds. Value, upper and ceiling
 * of the result, and a target, are worths in units of 1 / MURK_SHARE_ONE;
 * `whole` is MURK_SHARE_ONE. The matrix must not be NULL.
 *
 * Source: Krause, McMahan, Guestrin, Gupta, J. Mach. Learn. Res. 9 (2008)
 * 2761. */
#ifndef MURK_PLACEMENT_WORST_H
#define MURK_PLACEMENT_WORST_H

#include "placement/blocks.h"
#include "placement/settings.h"

murk_status murk_place_worst(murk_place_result *result,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_blocks *blocks,
                             const murk_place_desc *desc, murk_error *err);

#endif
