/* The one question of searches: which candidates add most to what stands, and
 * which tie? The answer is exact and complete. */
#ifndef MURK_PLACEMENT_SCAN_H
#define MURK_PLACEMENT_SCAN_H

#include "placement/search.h"

/* Adds a candidate to what stands and returns what it brought. */
uint64_t murk_scan_stand(murk_search *s, uint32_t candidate);

/* All of the plan but its entry `but` (n: all). Returns their value. */
uint64_t murk_scan_stand_others(murk_search *s, const uint32_t *plan, size_t n,
                                size_t but);

/* Whether the candidate may join what stands. Where the clearest view alone
 * counts, one that stands adds nothing and need not be told apart. */
static inline bool murk_scan_is_open(const murk_search *s, uint32_t candidate)
{
    return s->evaluator->book
               ? murk_partial_plan_admits(&s->partial, candidate, s->is_move)
               : !s->has_many_views || !s->is_partial[candidate];
}

/* By how much the candidate may add more later, by rounding. */
static inline uint64_t murk_scan_slack(const murk_search *s, uint32_t candidate)
{
    return s->evaluator->slack ? s->evaluator->slack[candidate] : 0;
}

/* Weighs the n candidates gathered in the chunk, into s->gain and
 * s->chunk_gain; returns the best of these and `best`. */
uint64_t murk_scan_weigh(murk_search *s, size_t n, uint64_t best);

/* Fills tie with all candidates that add most to what stands (the plan less
 * its entry `but`, worth `value`) and returns how much. The ranking is of the
 * evaluator's candidates, with bounds on what each may add. */
uint64_t murk_scan_candidates(murk_search *s, const murk_ranked *ranking,
                              const uint32_t *plan, size_t n, size_t but,
                              uint64_t value);

/* After a scan of a growing cover: puts s->ranking in the order of what was
 * weighed. */
void murk_scan_sharpen(murk_search *s);

#endif
