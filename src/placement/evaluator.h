/* The evaluator answers the questions of every solver, with equal answers for a
 * known and an unknown environment: the row of a candidate, and the gains of
 * candidates over a cover. The evaluator also holds the results of presolve. */
#ifndef MURK_PLACEMENT_EVALUATOR_H
#define MURK_PLACEMENT_EVALUATOR_H

#include "base/arena.h"
#include "base/pool.h"
#include "placement/constraints.h"
#include "placement/gain.h"
#include "placement/matrix.h"
#include "placement/ranked_rows.h"

typedef struct murk_evaluator {
    const murk_problem *problem;
    const murk_matrix *matrix;      /* NULL: unknown environment */
    const murk_constraint_set *set; /* NULL: no constraint but a count */
    const murk_layout *layout;
    murk_layout own_layout; /* unknown environment only */
    size_t candidates;
    murk_ranked_rows cached; /* unknown environment only */
    const murk_row *row;     /* [candidates] stored rows, those of the matrix or
                                the cached ones; row[j].memory NULL: another rank
                                has the row, or the problem is asked */
    bool has_all_rows;       /* all rows are stored here */
    bool is_binary; /* the entries of all rows are MURK_CLEAR, so covers may be
                       bits */
    size_t row_bytes;       /* stored here, per candidate */
    uint64_t *single_value; /* [candidates] value of each candidate alone */
    uint64_t *slack; /* [candidates] the amount by which a gain may grow later,
                        through rounding; NULL: gains never grow */
    /* If only the largest entry of a photon counts, a dominated candidate can
     * have the largest gain only if the dominator has the same gain. With
     * redundancy, or with detection probabilities in plans of several sensors,
     * that is not so: `ranked` then treats every candidate as undominated, and
     * only `presolved` leaves candidates out. */
    uint32_t *dominator; /* [candidates] an undominated candidate whose entries
                            are nowhere smaller; or the candidate itself */
    murk_ranked *ranked; /* [candidates] undominated candidates first; by
                            falling single_value + slack, then by cost if
                            murk_presolve() has run, then by index */
    size_t undominated;
    murk_ranked *presolved; /* [presolved_count] candidates that suffice for an
                               optimal plan, by falling single_value + slack;
                               the others follow them */
    size_t presolved_count;
    uint64_t ceiling, grain; /* ceiling: value of all candidates together; each
                                value is a multiple of grain */
    uint64_t queries; /* rows evaluated at creation; unknown environment only */
    uint64_t
        search_work; /* maximum work of the searches; 0: MURK_SEARCH_WORK */
    murk_arena arena;
} murk_evaluator;

/* matrix NULL: unknown environment, in which the problem is asked once for the
 * row of each candidate, and rows of row_memory bytes altogether are
 * cached. Plans have at most `max` sensors. keep_dominated: without
 * presolve. Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_evaluator_init(murk_evaluator *out,
                                const murk_problem *problem,
                                const murk_matrix *matrix,
                                const murk_constraint_set *set, size_t max,
                                uint64_t row_memory, bool keep_dominated,
                                murk_error *err);
void murk_evaluator_release(murk_evaluator *evaluator);

/* Upper bound on the gain of the candidate over any cover. */
static inline uint64_t
murk_evaluator_gain_bound(const murk_evaluator *evaluator, uint32_t candidate)
{
    return evaluator->single_value[candidate] +
           (evaluator->slack ? evaluator->slack[candidate] : 0);
}

/* True if ranks have the rows of their own candidates alone. The functions of
 * this header that say so are then collective: all ranks call them with the
 * same arguments in the same order, from the thread that works for the host. A
 * failure of a rank shows in murk_interrupted(), and results are arbitrary
 * then. In an unknown environment of which not all rows are stored, the
 * functions that compute gains are collective, too: ranks divide the rows that
 * have to be computed. */
static inline bool
murk_evaluator_is_distributed(const murk_evaluator *evaluator)
{
    return evaluator->matrix && evaluator->matrix->is_distributed;
}

/* The row of a candidate, valid until the worker's next call. Collective with a
 * distributed matrix. */
murk_row murk_evaluator_row(const murk_evaluator *evaluator, unsigned worker,
                            uint32_t candidate);

/* The row of a candidate if this rank has it, for loops that divide candidates
 * among threads and ranks; false otherwise. Not collective. */
bool murk_evaluator_own_row(murk_row *out, const murk_evaluator *evaluator,
                            unsigned worker, uint32_t candidate);

/* With a distributed matrix: completes word[n], of which each rank has filled
 * the words of its own candidates and left the others 0. Collective. */
void murk_evaluator_complete(const murk_evaluator *evaluator, uint64_t *word,
                             size_t n);

/* Adds the rows of all candidates to a cover. Collective with a distributed
 * matrix. Fails with MURK_NO_MEMORY or the failure of another rank. */
murk_status murk_evaluator_cover_all(const murk_evaluator *evaluator,
                                     murk_cover *cover, murk_error *err);

/* True if rows are asked of the problem in parts, so that searches should name
 * their needs (murk_row_need). */
static inline bool murk_evaluator_asks_parts(const murk_evaluator *evaluator)
{
    return !evaluator->has_all_rows && !evaluator->matrix &&
           evaluator->problem->get_part;
}

/* Fills entry_max[slots] with upper bounds on the amounts by which an entry of
 * each photon can increase the value of the cover (murk_row_need). */
void murk_evaluator_bound_entries(const murk_evaluator *evaluator,
                                  const murk_cover *cover, uint64_t *entry_max);

/* The row of a candidate as far as it is needed; with need->gain_min 0.
 * Collective with a distributed matrix. */
murk_row murk_evaluator_part(const murk_evaluator *evaluator, unsigned worker,
                             uint32_t candidate, const murk_row_need *need);

/* The work of evaluating candidates against a cover, in evaluations of one
 * photon of a 0/1 row. Rows of clarities and of probabilities take longer. A
 * row has some fixed cost, so the work of a row is at least that of
 * MURK_ROW_WORK_MIN photons. */
#define MURK_ROW_WORK_MIN 1024
uint64_t murk_evaluator_work(const murk_evaluator *evaluator,
                             uint64_t candidates);

/* The number of threads that are worth using to evaluate n candidates. */
unsigned murk_evaluator_threads(const murk_evaluator *evaluator, size_t n);

/* Runs job(context, worker, k) for k < n, with the number of threads that
 * murk_evaluator_threads() gives. */
void murk_evaluator_run(const murk_evaluator *evaluator, size_t n,
                        murk_worker_job job, void *context);

/* gain[k] = the gain of candidate[k] over the cover, k < n. Uses at most
 * `threads` threads. If the calling thread works alone, it asks for rows as
 * worker number `worker`. This and the next two functions are collective with a
 * distributed matrix. */
void murk_evaluator_gains(const murk_evaluator *evaluator,
                          const murk_cover *cover, const uint32_t *candidate,
                          size_t n, unsigned threads, unsigned worker,
                          uint64_t *gain);

/* The same with upper bounds instead of gains, many times faster. Only if
 * evaluator->slack is set. */
void murk_evaluator_gain_bounds(const murk_evaluator *evaluator,
                                const murk_cover *cover,
                                const uint32_t *candidate, size_t n,
                                unsigned threads, unsigned worker,
                                uint64_t *max);

/* murk_evaluator_gains() with the needs of a search: instead of a gain below
 * need->gain_min, gain[k] may be any smaller number. need NULL: all gains are
 * exact. */
void murk_evaluator_needed_gains(const murk_evaluator *evaluator,
                                 const murk_cover *cover,
                                 const uint32_t *candidate, size_t n,
                                 unsigned threads, unsigned worker,
                                 const murk_row_need *need, uint64_t *gain);

/* Sorts by falling bound, then by index. */
void murk_ranked_sort(murk_ranked *ranked, size_t n);

#endif
