/* Dominance: B is dominated by A when A sees every photon at least as clearly.
 * Whatever stands, A then adds no less than B, so the value of the best plan
 * is found among the undominated, and a search must look at B only where A
 * itself ties for the best. */
#ifndef MURK_PLACEMENT_PRESOLVE_H
#define MURK_PLACEMENT_PRESOLVE_H

#include "placement/constraints.h"
#include "placement/matrix.h"

/* order[candidates]: by falling value alone. Fills
 * dominator[candidates] with the first undominated candidate in that order
 * that dominates, or the candidate itself. Of equals, the first is kept. With
 * rules (NULL: none) a candidate that they may still need is not dominated:
 * murk_constraint_set_may_drop(). */
murk_status murk_presolve(uint32_t *dominator, const murk_matrix *matrix,
                          const murk_constraint_set *set, const uint32_t *order,
                          unsigned threads, murk_error *err);

/* The same where it takes more than one: marks whom at least `needed` of those
 * kept before it dominate. In a plan with such a one a dominator that does not
 * stand may take its place; with `needed` the plan's greatest count there
 * always is one, and where the `needed` clearest views count, it adds nothing
 * where they all stand. */
murk_status murk_presolve_many(bool *is_dropped, const murk_matrix *matrix,
                               const murk_constraint_set *set,
                               const uint32_t *order, size_t needed,
                               murk_error *err);

#endif
