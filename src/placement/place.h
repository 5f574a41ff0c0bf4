/* Chooses the candidates of a plan, and bounds the value of any plan: SPOQ,
 * greedy, certified relocation, Lagrangian bound, branch and bound.
 *
 * MURK_PLACE_SPOQ is the published algorithm to the letter: a random start,
 * then sweeps over the sensors in fresh random order. A sweep moves each sensor
 * to the candidate that adds most to the other sensors, ties at random. The
 * algorithm ends with a sweep that brings no gain. MURK_PLACE_BEST takes the
 * plans of greedy and of SPOQ starts and relocates their sensors: a sensor
 * stays on ties, and sweeps go on until no sensor moves. So no single
 * relocation improves the plan, and the value is at least n / (2n - 1) of the
 * optimum. In a known environment branch and bound follows, limited by `nodes`.
 * MURK_PLACE_GREEDY is greedy alone, MURK_PLACE_EXACT is greedy followed by
 * branch and bound. Every method computes a bound.
 *
 * With a start plan (desc->start_plan, the plan of an earlier step, say)
 * MURK_PLACE_BEST relocates that plan in place of the SPOQ starts, whatever
 * `restarts` says, and makes no branch and bound: the search costs a few sweeps
 * and is never worse than greedy. Of plans of equal value the one from the
 * start plan is taken. MURK_PLACE_EXACT relocates the start plan as a further
 * incumbent; MURK_PLACE_SPOQ begins at the start plan in place of a random one;
 * MURK_PLACE_GREEDY ignores it. For each count the start plan is cut or
 * completed: candidates that break a constraint are left out, in the order of
 * the list, those beyond the count too, and greedy adds what is missing.
 *
 * A plan that reaches the ceiling (the value of all candidates together) is
 * optimal and ends the work on that count. A limit, search_work, holds for the
 * work of the searches, in evaluations. The SPOQ starts have a limit of their
 * own, of the same size. Once half of the limit is spent, points of a curve
 * without constraints take greedy's plan and the bound from greedy's scans (not
 * with MURK_PLACE_SPOQ). Once the limit is spent, sweeps and relocation stop,
 * and is_work_cut says so.
 *
 * A request to finish (base/interrupt.h) ends sweeps, relocation, starts, bound
 * and branch and bound where they are, and so does the deadline of searches.
 * Counts that are still to come take greedy's plan, or the plan of one sensor
 * fewer with one more, so the result is a plan of the wanted count, and
 * is_interrupted or is_late says that another run may give another plan. A scan
 * that has begun is completed. The start plan is tried all the same, so the
 * plan is never worse than the start plan.
 *
 * With a target, counts are tried upwards from the smallest feasible one. If
 * the plan of a count misses the target and the bound does not exclude it,
 * branch and bound (if the method has it) runs before the next count is tried.
 *
 * Constraints (placement/constraints.h) hold in every method: each move leads
 * to a feasible plan, and the certificate of relocation (no single move
 * improves the plan) holds for feasible moves. With a budget greedy takes the
 * candidate with the largest gain per cost; its plan competes with that of
 * plain greedy, and sensors are added while the budget pays for them. If the
 * constraints stop greedy before the count is reached, any feasible plan is the
 * start.
 *
 * Source: the SPOQ paper of 2013 (Sensor Placement Optimization via Queries);
 * Nemhauser, Wolsey, Fisher, Math. Program. 14 (1978) 265,
 * doi:10.1007/BF01588971; Cornuejols, Fisher, Nemhauser, Manage. Sci. 23 (1977)
 * 789, doi:10.1287/mnsc.23.8.789 (greedy and Lagrangian bound for facility
 * location). */
#ifndef MURK_PLACEMENT_PLACE_H
#define MURK_PLACEMENT_PLACE_H

#include "placement/settings.h"

/* Under a rule on moves, the searches, which begin at the start plan, and the
 * bound are by the value less the cost of the moves. MURK_PLACE_BEST relocates
 * the start plan and greedy's plan by placement/moves.h; the start plan wins
 * ties. MURK_PLACE_SPOQ makes sweeps over the start plan, in which a sensor
 * stays on ties. The bound of placement/bound.h is evaluated at the cover of
 * the start plan S first: it is then, for at most k moves and without costs,
 * the value of S and the k largest gains over S.
 *
 * Known environment: uses the rows of the matrix, and weights and threads of
 * the problem. Unknown environment (matrix NULL): asks the problem for each row
 * that is not cached (desc->row_memory), so without cached rows memory is
 * O(photons). The result is the same for any row_memory. Each decision of a
 * search, and so the plan before branch and bound, is the same in both
 * environments unless search_work ends a search: presolve, which needs the
 * matrix, changes no plan. Fails with MURK_BAD_VALUE (settings, constraints, a
 * target that cannot be reached), MURK_RUN_FAILED (no plan found),
 * MURK_NO_MEMORY or MURK_INTERRUPTED; *result is then unchanged. After success
 * call murk_place_release(). */
murk_status murk_place_sensors(murk_place_result *result,
                               const murk_problem *problem,
                               const murk_matrix *matrix,
                               const murk_place_desc *desc, murk_error *err);

#endif
