/* Searches for plans: greedy, SPOQ and certified relocation, all made of scans
 * (placement/scan.h). The sources stand in placement/place.h. */
#ifndef MURK_PLACEMENT_SEARCH_H
#define MURK_PLACEMENT_SEARCH_H

#include "placement/scan.h"

/* All functions but murk_search_begin() and murk_search_draw() return the value
 * of plan[n], which has distinct candidates. If the run is interrupted these
 * functions return early, and the plan has no meaning.
 *
 * Under constraints the fixed sensors come first in a plan and never move,
 * every plan tried is feasible, and s->size is the number of sensors: greedy
 * may stop before n, and with a budget a plan has as many sensors as the budget
 * pays, n at most. */

/* With constraints: begins a plan of n sensors (with a budget: of at most the
 * set's max_sensors). Puts the fixed sensors in front, unless plan[given]
 * begins with them already. Returns the number of sensors in the plan; without
 * constraints `given`. */
size_t murk_search_begin(murk_gain_scan *s, uint32_t *plan, size_t given,
                         size_t n);

/* Extends a plan of `given` sensors to n sensors, or until the value reaches
 * `enough`, no candidate can be added, or, with a budget, the minimum counts
 * are met and no candidate has a gain. Each step adds the candidate with the
 * largest gain, the lowest index on ties. value_after[k] receives the value of
 * the first k + 1 sensors, for k + 1 >= given; NULL is allowed. Lowers the
 * upper bounds s->greedy_bound, if they are recorded, at each step. */
uint64_t murk_search_greedy(murk_gain_scan *s, uint32_t *plan, size_t given,
                            size_t n, uint64_t enough, uint64_t *value_after);

/* The random start number `restart`, of n sensors or of as many as the
 * constraints allow. Returns the number of sensors. */
size_t murk_search_draw(murk_gain_scan *s, uint32_t *plan, size_t n,
                        uint32_t seed, uint64_t restart);

/* The published SPOQ algorithm from start number `restart`. Two sensors never
 * share a candidate. In the published problem, in which only the largest entry
 * counts, a second sensor at a candidate adds nothing, so this rule matters
 * only if no candidate has a gain. */
uint64_t murk_search_spoq(murk_gain_scan *s, uint32_t *plan, size_t n,
                          uint32_t seed, uint64_t restart);

/* Certified relocation: moves single sensors while that increases the value; a
 * sensor stays on ties. With a budget, sensors that the budget pays are added
 * in between. At the end no single move increases the value, unless the limit
 * s->rows_max ended the search (s->is_cut). */
uint64_t murk_search_relocate(murk_gain_scan *s, uint32_t *plan, size_t n);

/* With a budget: extends plan[given] by the affordable candidate with the
 * largest gain per cost, until no candidate has a gain; then, class by class,
 * by the cheapest candidates that the minimum counts still need. */
uint64_t murk_search_budget_greedy(murk_gain_scan *s, uint32_t *plan,
                                   size_t given);

#endif
