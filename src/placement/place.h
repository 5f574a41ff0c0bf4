/* Which candidates: SPOQ, greedy, the best of many, and a bound on how far
 * from the best any plan can be.
 *
 * `spoq` is the paper's algorithm to the letter: random start; sweeps over the
 * sensors in fresh random order, each moved to the candidate that adds most to
 * the others, ties at random; until a sweep brings no gain. `best` takes
 * greedy and SPOQ starts, then certified relocation: a sensor stays on ties,
 * and sweeps go on until one moves nothing, so no single relocation helps and
 * the plan is worth at least n / (2n - 1) of the optimum; then, where the
 * environment is known, branch and bound within `nodes`. `exact` is greedy and
 * branch and bound alone.
 *
 * A plan that sees all that all candidates see is the best, and no further work
 * goes into its count. In a known environment the work of searching is limited
 * to MURK_SEARCH_WORK, and starts to as much again: from where half of it is
 * spent, points of the curve are greedy's, with the bound that greedy's scans
 * give; where all of it is, relocation ends as it stands (is_work_cut).
 *
 * With a target, counts are tried from 1 up; where a count's plan falls short
 * though its bound does not, branch and bound has its say before the next.
 *
 * Under rules (placement/constraints.h) every method keeps to them: a move is
 * one that leaves a plan, and the certificate speaks of those; with a budget
 * greedy goes by gain per cost, against the best single sensor, and sensors
 * are also added where they can be paid. A count that the rules bring to a dead
 * end is met by any plan that a search finds, improved.
 *
 * Source: SPOQ, shared paper of 2013; Nemhauser, Wolsey, Fisher, Math.
 * Program. 14 (1978) 265, doi:10.1007/BF01588971; Cornuejols, Fisher,
 * Nemhauser, Manage. Sci. 23 (1977) 789, doi:10.1287/mnsc.23.8.789 (greedy
 * and Lagrangian bound for facility location). */
#ifndef MURK_PLACEMENT_PLACE_H
#define MURK_PLACEMENT_PLACE_H

#include "placement/settings.h"

/* Known environment: from the matrix. `problem` gives weights and threads. */
murk_status murk_place_known(murk_place_result *result,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_place_desc *desc, murk_error *err);

/* Unknown environment: looks again at each evaluation, O(photons) memory. The
 * same plan as known, decision for decision (presolve, which needs the matrix,
 * must not change it). */
murk_status murk_place_unknown(murk_place_result *result,
                               const murk_problem *problem,
                               const murk_place_desc *desc, murk_error *err);

#endif
