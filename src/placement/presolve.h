/* Dominance: candidate A dominates candidate B if A sees every photon at least
 * as clearly. The gain of A over any partial plan without A is then at least
 * that of B. If only the largest entry of a photon counts, B adds nothing to a
 * plan with A. Some best plan then consists of undominated candidates, unless
 * these are fewer than the sensors of a plan, and a search needs to evaluate B
 * only if A has the largest gain. */
#ifndef MURK_PLACEMENT_PRESOLVE_H
#define MURK_PLACEMENT_PRESOLVE_H

#include "placement/constraints.h"
#include "placement/matrix.h"

/* order[candidates]: by falling value of each candidate alone. dominator[j]
 * receives the first undominated candidate in that order that dominates
 * candidate j, or j itself if there is none. Of equal candidates the first one
 * is kept. With constraints (set NULL: none) a candidate that a feasible plan
 * may still need counts as undominated (murk_constraint_set_may_drop). With
 * more than MURK_PRESOLVE_CANDIDATES_MAX candidates nothing is compared, and
 * every candidate is the dominator of itself. Both functions are collective
 * with a distributed matrix. Fails with MURK_NO_MEMORY, or with the failure of
 * another rank. */
murk_status murk_presolve(uint32_t *dominator, const murk_matrix *matrix,
                          const murk_constraint_set *set, const uint32_t *order,
                          unsigned threads, murk_error *err);

/* The same if one dominator is not enough: is_dropped, all false at first,
 * marks each candidate that is dominated by at least `needed` kept candidates
 * earlier in the order. Nothing is dropped with more than
 * MURK_PRESOLVE_CANDIDATES_MAX candidates, or if `needed` is not below their
 * number. A dominator outside the plan can take
 * the place of a dropped candidate. If `needed` is the size of the plan, there
 * always is such a dominator; if it is the number of entries that count, a
 * dropped candidate adds nothing once all dominators are in the plan. */
murk_status murk_presolve_many(bool *is_dropped, const murk_matrix *matrix,
                               const murk_constraint_set *set,
                               const uint32_t *order, size_t needed,
                               murk_error *err);

#endif
