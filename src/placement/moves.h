/* Searches under a rule on moves (placement/constraints.h). The objective is
 * the value of a plan less the cost of its moves, or 0 if the cost is larger.
 */
#ifndef MURK_PLACEMENT_MOVES_H
#define MURK_PLACEMENT_MOVES_H

#include "placement/scan.h"

/* Makes the partial plan equal to plan[n] and returns its objective. If the
 * plan is not complete, it counts as completed by sensors of the start plan
 * that add nothing. */
uint64_t murk_moves_objective(murk_gain_scan *s, const uint32_t *plan,
                              size_t n);

/* Finds the best place for sensor `mover` of plan[n] by the objective. On ties
 * the sensor stays, or else goes to a place of the start plan, or else to the
 * lowest index. Returns the objective with the sensor there. */
uint64_t murk_moves_find_place(murk_gain_scan *s, const uint32_t *plan,
                               size_t n, size_t mover, uint32_t *place);

/* Relocates the sensors of plan[n] that are not fixed. Each step makes the move
 * of one sensor that increases the objective most. If no move increases it, a
 * newcomer goes back to the best free place of the start plan, and the best
 * move of another sensor follows, if both together increase the objective: a
 * rule that allows few moves would otherwise hold the search at the first ones
 * that it made. Ends when neither helps, or beyond s->rows_max as
 * murk_search_relocate(). Returns the objective. */
uint64_t murk_moves_relocate(murk_gain_scan *s, uint32_t *plan, size_t n);

#endif
