/* The scan: finds all candidates with the largest gain over a partial plan.
 * Greedy, SPOQ and relocation by the value (placement/search.h) consist of
 * scans.
 *
 * The answer is exact and complete, though most candidates need no evaluation:
 * a gain is at most the value of the candidate alone (plus the rounding slack
 * of detection probabilities), and if only the largest entry counts, the gain
 * of a dominated candidate is at most the dominator's. */
#ifndef MURK_PLACEMENT_SCAN_H
#define MURK_PLACEMENT_SCAN_H

#include "base/arena.h"
#include "placement/relaxation.h"

/* Candidates evaluated between two comparisons with the best gain so far. A
 * constant, so the set of evaluated candidates does not depend on the number of
 * threads. */
#define MURK_SCAN_CHUNK 128

/* The workspace of one worker. No state is kept from one plan to the next,
 * except the counters, is_cut and greedy_bound. */
typedef struct murk_gain_scan {
    const murk_evaluator *evaluator;
    unsigned worker;      /* worker index if threads is 1 */
    unsigned threads;     /* each scan uses so many threads */
    murk_cover cover;     /* of the partial plan */
    bool has_many_layers; /* more than the largest entry of a photon counts */
    bool *is_partial;     /* [candidates] member of the partial plan */
    uint64_t *max; /* [candidates] upper bounds on the gains of this scan; NULL:
                      gains are as fast to compute */
    uint64_t *gain; /* [candidates] of this scan; UINT64_MAX: not evaluated */
    const uint64_t *known; /* borrowed: known[j * known_step] is the gain of
                              candidate j in this scan, computed before; NULL:
                              gains are computed when needed */
    size_t known_step;
    uint64_t *ahead;      /* [candidates] with a distributed matrix: gains that
                             were computed ahead in this scan; NULL: none are */
    uint32_t *ahead_list; /* [candidates] scratch */
    uint64_t *ahead_gain; /* [candidates] scratch */
    size_t ahead_end;     /* so many of the ranking have such gains */
    uint32_t *tie; /* [ties] the candidates with the largest gain, increasing */
    size_t ties;
    uint32_t *shuffle;    /* [candidates] */
    murk_ranked *ranking; /* [candidates] greedy's order */
    uint64_t *chunk_gain;
    uint32_t *chunk;
    uint64_t value; /* of the partial plan */
    /* The needs of this scan (murk_row_need), if rows are asked of the problem
     * in parts. */
    uint64_t
        *entry_max; /* [slots] for the cover; NULL: rows are asked for whole */
    bool is_entry_max_old; /* the cover has changed since */
    bool is_moving;    /* a sensor is moved: only the largest gain matters */
    uint64_t gain_min; /* is_moving: a gain that some candidate has */
    uint64_t evaluations, queries; /* counters; the caller resets them */
    uint64_t rows, rows_max; /* rows evaluated or added; SPOQ and relocation end
                                beyond rows_max */
    bool is_cut;             /* a search ended by rows_max */
    size_t size; /* sensors of the last plan; under constraints possibly not the
                    wanted count */
    /* Upper bounds for every count from greedy's scans, without constraints: no
     * plan of k + 1 sensors exceeds greedy_bound[k]. NULL: not recorded. */
    uint64_t *greedy_bound; /* [greedy_bound_count], borrowed */
    size_t greedy_bound_count;
    /* With constraints only. */
    murk_partial_plan partial;
    bool is_move;        /* the added candidate must leave no minimum count
                            open */
    murk_priced *priced; /* [candidates] */
    uint32_t *fallback;  /* [fallback_size] borrowed: a plan for random starts
                            that the constraints stop early */
    size_t fallback_size;
    murk_arena arena;
} murk_gain_scan;

/* A lexicographic objective value: `first` decides, `second` breaks ties. */
typedef struct murk_objective_value {
    uint64_t first, second;
} murk_objective_value;

static inline bool murk_objective_is_greater(murk_objective_value a,
                                             murk_objective_value b)
{
    return a.first != b.first ? a.first > b.first : a.second > b.second;
}

/* The number of rows that fit the limit on work, evaluator->search_work
 * (MURK_SEARCH_WORK if that is 0). */
uint64_t murk_gain_scan_rows_max(const murk_evaluator *evaluator);

murk_status murk_gain_scan_init(murk_gain_scan *out,
                                const murk_evaluator *evaluator,
                                unsigned worker, unsigned threads,
                                murk_error *err);
void murk_gain_scan_release(murk_gain_scan *search);

/* Adds a candidate to the partial plan and returns the gain. */
uint64_t murk_gain_scan_add(murk_gain_scan *s, uint32_t candidate);

/* Makes the partial plan equal to plan[n] without the entry `but` (n: all
 * entries). Returns the value. */
uint64_t murk_gain_scan_set_all_but(murk_gain_scan *s, const uint32_t *plan,
                                    size_t n, size_t but);

/* True if the candidate can be added. Without constraints, if only the largest
 * entry counts, the result is true for members as well: their gain is 0. */
static inline bool murk_gain_scan_can_add(const murk_gain_scan *s,
                                          uint32_t candidate)
{
    return s->evaluator->set
               ? murk_partial_plan_can_add(&s->partial, candidate, s->is_move)
               : !s->has_many_layers || !s->is_partial[candidate];
}

/* The amount by which the gain of a candidate may grow later, through rounding.
 */
static inline uint64_t murk_gain_scan_slack(const murk_gain_scan *s,
                                            uint32_t candidate)
{
    return s->evaluator->slack ? s->evaluator->slack[candidate] : 0;
}

/* Computes the gains of the n candidates in s->chunk, or takes the known ones,
 * into s->gain and s->chunk_gain. Returns the larger of `best` and the largest
 * of these gains. */
uint64_t murk_gain_scan_evaluate(murk_gain_scan *s, size_t n, uint64_t best);

/* Fills s->tie with all candidates of the largest gain over the partial plan,
 * which is worth `value`, and returns that gain. If that gain is 0, s->tie
 * receives all candidates outside the partial plan that can be added. Also
 * returns 0 if the run is interrupted. `ranking` orders the evaluator's
 * candidates by upper bounds on their gains. */
uint64_t murk_gain_scan_find_best(murk_gain_scan *s, const murk_ranked *ranking,
                                  uint64_t value);

/* The same for the move of a sensor, with the evaluator's ranking. `gain_min`
 * is the gain at the present place of the sensor, or 0: s->gain of candidates
 * with smaller gains may then be any smaller number. */
uint64_t murk_gain_scan_find_move(murk_gain_scan *s, uint64_t value,
                                  uint64_t gain_min);

/* After a scan over a growing partial plan: lowers the bounds of s->ranking to
 * the computed gains and sorts again. */
void murk_gain_scan_update_bounds(murk_gain_scan *s);

#endif
