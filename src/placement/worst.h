/* Sensors for the worst of several conditions: the plan whose least covered
 * block is covered best.
 *
 * `greedy` climbs towards the highest level that greedy reaches in all blocks,
 * found by halving; `best` takes that, greedy on each block and on their mean,
 * and random starts, relocates each, and ends with branch and bound; `exact`
 * is greedy and branch and bound alone; `spoq` one random start, relocated. No
 * share of the optimum is guaranteed; the bound always holds. A result's value,
 * upper and ceiling are shares of MURK_SHARE_ONE, which is its whole, and so is
 * a target. Known environments only.
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
