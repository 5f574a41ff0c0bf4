/* Finding plans: greedy, SPOQ and certified relocation, each built on one
 * question, "which candidates add most to what stands, and which tie?"
 *
 * The answer is exact and complete, though most candidates need no weighing:
 * one adds at most what it is worth alone, but for what rounding may add to
 * that where chances are independent; and where the clearest view alone counts,
 * a dominated one adds at most what its dominator does. */
#ifndef MURK_PLACEMENT_SEARCH_H
#define MURK_PLACEMENT_SEARCH_H

#include "placement/scan.h"

/* All return the value of plan[n], distinct candidates. When interrupted they
 * return early and the plan means nothing.
 *
 * Under rules the fixed sensors come first in a plan and never move, all that
 * is tried keeps the rules, and s->size says how many sensors the plan has:
 * greedy may come to a dead end before n, and with a budget a plan has as many
 * as pay, n at most. */

/* Extends the first `given` of plan to n, or until it is worth `enough`, each
 * the one that adds most, the lowest number on ties. value_after[k] (NULL is
 * fine) is the value of the first k + 1, for k >= given. Lowers s->reach on the
 * way, by what it learns anyhow. */
uint64_t murk_search_greedy(murk_gain_scan *s, uint32_t *plan, size_t given,
                            size_t n, uint64_t enough, uint64_t *value_after);

/* The random start number `restart` of n sensors; under rules as many as there
 * may be. Returns how many. */
size_t murk_search_draw(murk_gain_scan *s, uint32_t *plan, size_t n,
                        uint32_t seed, uint64_t restart);

/* The paper's algorithm from its start number `restart`. Two sensors never
 * share a candidate: one that another holds adds nothing, so this matters only
 * where nothing is left to gain. */
uint64_t murk_search_spoq(murk_gain_scan *s, uint32_t *plan, size_t n,
                          uint32_t seed, uint64_t restart);

/* Moves single sensors while that gains; each stays on ties. At the end no
 * single move helps. */
uint64_t murk_search_relocate(murk_gain_scan *s, uint32_t *plan, size_t n);

/* With a budget: extends plan[given] by the candidate that adds most per cost
 * of those that can still be paid, until none adds anything. */
uint64_t murk_search_budget_greedy(murk_gain_scan *s, uint32_t *plan,
                                   size_t given);

/* The value of plan[n]. */
uint64_t murk_search_value(murk_gain_scan *s, const uint32_t *plan, size_t n);

#endif
