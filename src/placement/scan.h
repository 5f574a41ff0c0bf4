/* The one question of searches: which candidates add most to what stands, and
 * which tie? The answer is exact and complete. */
#ifndef MURK_PLACEMENT_SCAN_H
#define MURK_PLACEMENT_SCAN_H

#include "placement/relaxation.h"

/* Candidates weighed between two looks at the best so far. Fixed, so that who
 * is weighed does not depend on the threads. */
#define MURK_SCAN_CHUNK 128

/* One worker's desk; carries nothing from one plan to the next. */
typedef struct murk_gain_scan {
    const murk_evaluator *evaluator;
    unsigned worker;     /* who looks when threads is 1 */
    unsigned threads;    /* spread over each scan */
    murk_cover cover;    /* of what stands */
    bool has_many_views; /* more than the clearest of a photon count */
    bool *is_partial;    /* [candidates] */
    uint64_t *max;       /* [candidates] of this scan, gain is not more; NULL
                             where weighing is as quick */
    uint64_t *gain;      /* [candidates] of this scan, or NOT_WEIGHED */
    uint32_t *tie;       /* [ties] the candidates that add most, rising */
    size_t ties;
    uint32_t *shuffle;    /* [candidates] */
    murk_ranked *ranking; /* [candidates] greedy's own */
    uint64_t *chunk_gain;
    uint32_t *chunk;
    uint64_t evaluations, queries; /* counted since last set to 0 */
    uint64_t rows, rows_max;       /* weighed or joined likewise; SPOQ and
                                       relocation end beyond rows_most, */
    bool is_cut;                   /* which is said here */
    size_t size; /* sensors of the plan last made; under rules it may differ
                    from what was asked for */
    /* What greedy's scans say of every count, without rules: reach[k] no plan
     * of k + 1 exceeds. NULL: not kept. */
    uint64_t *greedy_bound; /* [reach_count], borrowed */
    size_t greedy_bound_count;
    /* With rules. */
    murk_partial_plan partial;
    bool is_move;        /* who joins must make a plan of what stands */
    murk_priced *priced; /* [candidates] */
    const uint32_t
        *fallback; /* [spare_size] a plan for starts that end short */
    size_t fallback_size;
} murk_gain_scan;

/* Rows that a search may take (MURK_SEARCH_WORK): any number where looks are
 * made again and again. */
uint64_t murk_gain_scan_rows_max(const murk_evaluator *evaluator);

murk_status murk_gain_scan_init(murk_gain_scan *out,
                                const murk_evaluator *evaluator,
                                unsigned worker, unsigned threads,
                                murk_error *err);
void murk_gain_scan_release(murk_gain_scan *search);

/* Adds a candidate to what stands and returns what it brought. */
uint64_t murk_gain_scan_add(murk_gain_scan *s, uint32_t candidate);

/* All of the plan but its entry `but` (n: all). Returns their value. */
uint64_t murk_gain_scan_set_all_but(murk_gain_scan *s, const uint32_t *plan,
                                    size_t n, size_t but);

/* Whether the candidate may join what stands. Where the clearest view alone
 * counts, one that stands adds nothing and need not be told apart. */
static inline bool murk_gain_scan_can_add(const murk_gain_scan *s,
                                          uint32_t candidate)
{
    return s->evaluator->set
               ? murk_partial_plan_can_add(&s->partial, candidate, s->is_move)
               : !s->has_many_views || !s->is_partial[candidate];
}

/* By how much the candidate may add more later, by rounding. */
static inline uint64_t murk_gain_scan_slack(const murk_gain_scan *s,
                                            uint32_t candidate)
{
    return s->evaluator->slack ? s->evaluator->slack[candidate] : 0;
}

/* Weighs the n candidates gathered in the chunk, into s->gain and
 * s->chunk_gain; returns the best of these and `best`. */
uint64_t murk_gain_scan_evaluate(murk_gain_scan *s, size_t n, uint64_t best);

/* Fills tie with all candidates that add most to what stands (the plan less
 * its entry `but`, worth `value`) and returns how much. The ranking is of the
 * evaluator's candidates, with bounds on what each may add. */
uint64_t murk_gain_scan_find_best(murk_gain_scan *s, const murk_ranked *ranking,
                                  const uint32_t *plan, size_t n, size_t but,
                                  uint64_t value);

/* After a scan of a growing cover: puts s->ranking in the order of what was
 * weighed. */
void murk_gain_scan_update_bounds(murk_gain_scan *s);

#endif
