/* Finding plans: greedy, SPOQ and certified relocation, each built on one
 * question, "which candidates add most to what stands, and which tie?"
 *
 * The answer is exact and complete, though most candidates need no weighing:
 * one adds at most what it is worth alone, but for what rounding may add to
 * that where chances are independent; and where the clearest view alone counts,
 * a dominated one adds at most what its dominator does. */
#ifndef MURK_PLACEMENT_SEARCH_H
#define MURK_PLACEMENT_SEARCH_H

#include "placement/relaxed.h"

/* Candidates weighed between two looks at the best so far. Fixed, so that who
 * is weighed does not depend on the threads. */
#define MURK_SEARCH_CHUNK 128

/* One worker's desk; carries nothing from one plan to the next. */
typedef struct murk_search {
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
    uint64_t evaluations, looks; /* counted since last set to 0 */
    uint64_t rows, rows_max;     /* weighed or joined likewise; SPOQ and
                                     relocation end beyond rows_most, */
    bool is_cut;                 /* which is said here */
    size_t size; /* sensors of the plan last made; under rules it may differ
                    from what was asked for */
    /* What greedy's scans say of every count, without rules: reach[k] no plan
     * of k + 1 exceeds. NULL: not kept. */
    uint64_t *reach; /* [reach_count], borrowed */
    size_t reach_count;
    /* With rules. */
    murk_partial_plan partial;
    bool is_move;          /* who joins must make a plan of what stands */
    murk_priced *priced;   /* [candidates] */
    const uint32_t *spare; /* [spare_size] a plan for starts that end short */
    size_t spare_size;
} murk_search;

/* Rows that a search may take (MURK_SEARCH_WORK): any number where looks are
 * made again and again. */
uint64_t murk_search_rows_max(const murk_evaluator *evaluator);

murk_status murk_search_init(murk_search *out, const murk_evaluator *evaluator,
                             unsigned worker, unsigned threads,
                             murk_error *err);
void murk_search_release(murk_search *search);

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
uint64_t murk_search_greedy(murk_search *s, uint32_t *plan, size_t given,
                            size_t n, uint64_t enough, uint64_t *value_after);

/* The random start number `restart` of n sensors; under rules as many as there
 * may be. Returns how many. */
size_t murk_search_draw(murk_search *s, uint32_t *plan, size_t n, uint32_t seed,
                        uint64_t restart);

/* The paper's algorithm from its start number `restart`. Two sensors never
 * share a candidate: one that another holds adds nothing, so this matters only
 * where nothing is left to gain. */
uint64_t murk_search_spoq(murk_search *s, uint32_t *plan, size_t n,
                          uint32_t seed, uint64_t restart);

/* Moves single sensors while that gains; each stays on ties. At the end no
 * single move helps. */
uint64_t murk_search_relocate(murk_search *s, uint32_t *plan, size_t n);

/* With a budget: extends plan[given] by the candidate that adds most per cost
 * of those that can still be paid, until none adds anything. */
uint64_t murk_search_spend(murk_search *s, uint32_t *plan, size_t given);

/* The value of plan[n]. */
uint64_t murk_search_value(murk_search *s, const uint32_t *plan, size_t n);

#endif
