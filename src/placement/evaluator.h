/* What every solver asks of an environment, known or unknown, with the same
 * answers: a candidate's row, and what candidates add to a cover. */
#ifndef MURK_PLACEMENT_EVALUATOR_H
#define MURK_PLACEMENT_EVALUATOR_H

#include "placement/constraints.h"
#include "placement/gain.h"
#include "placement/matrix.h"

/* A candidate and the most it can add to whatever cover is asked about. */
typedef struct murk_ranked {
    uint64_t bound;
    uint32_t candidate;
} murk_ranked;

typedef struct murk_evaluator {
    const murk_problem *problem;
    const murk_matrix *matrix;      /* NULL: unknown environment */
    const murk_constraint_set *set; /* NULL: no rules but a count */
    const murk_layout *layout;
    murk_layout own_layout; /* unknown environment */
    size_t candidates;
    bool is_binary;         /* covers may be bits */
    size_t row_bytes;       /* of the matrix, in the mean */
    uint64_t *single_value; /* [candidates] value of each by itself */
    uint64_t *slack;        /* [candidates] by which a gain may have grown, by
                               rounding; NULL: none may */
    /* Where the clearest view alone counts, one that is dominated can add the
     * most only where its dominator does. Else nobody counts as dominated in
     * `ranked`, only in `needed`. */
    uint32_t *dominator; /* [candidates] an undominated candidate that
                            sees all it sees as clearly; or itself */
    murk_ranked *ranked; /* [candidates] undominated ones first, by falling
                            alone (and slack), then number */
    size_t undominated;
    murk_ranked *presolved; /* [needed_count] the best plan is found among these
                            by the same order */
    size_t presolved_count;
    uint64_t ceiling, grain; /* every plan's value is a multiple of grain */
    uint64_t queries;        /* made at creation */
    uint64_t search_work;    /* that searches may take; 0: MURK_SEARCH_WORK */
} murk_evaluator;

/* Matrix NULL: unknown environment. Looks once at every candidate. Plans have
 * at most `most` sensors. With keep_dominated nobody is taken for dominated. */
murk_status murk_evaluator_init(murk_evaluator *out,
                                const murk_problem *problem,
                                const murk_matrix *matrix,
                                const murk_constraint_set *set, size_t max,
                                bool keep_dominated, murk_error *err);
void murk_evaluator_release(murk_evaluator *evaluator);

/* The most that the candidate can add to any cover. */
static inline uint64_t
murk_evaluator_gain_bound(const murk_evaluator *evaluator, uint32_t candidate)
{
    return evaluator->single_value[candidate] +
           (evaluator->slack ? evaluator->slack[candidate] : 0);
}

/* Valid until the worker's next call. */
murk_row murk_evaluator_row(const murk_evaluator *evaluator, unsigned worker,
                            uint32_t candidate);

/* The work of weighing so many candidates against a cover, in the unit that
 * limits count: so many weighings of one photon. Rows of clarities, and of
 * chances, take longer; and a short row as long as one of MURK_ROW_WORK_MIN
 * photons, for what is done once a row. */
#define MURK_ROW_WORK_MIN 1024
uint64_t murk_evaluator_work(const murk_evaluator *evaluator,
                             uint64_t candidates);

/* Threads worth using to weigh n candidates. */
unsigned murk_evaluator_threads(const murk_evaluator *evaluator, size_t n);

/* gain[k] = what candidate[k] would add to the cover, k < n, over `threads` at
 * most, as is worth while; with one, as `worker`. */
void murk_evaluator_gains(const murk_evaluator *evaluator,
                          const murk_cover *cover, const uint32_t *candidate,
                          size_t n, unsigned threads, unsigned worker,
                          uint64_t *gain);

/* The same, but most[k] is not less than the gain; where evaluator->slack, and
 * many times quicker. */
void murk_evaluator_gain_bounds(const murk_evaluator *evaluator,
                                const murk_cover *cover,
                                const uint32_t *candidate, size_t n,
                                unsigned threads, unsigned worker,
                                uint64_t *max);

/* Falling bound, then rising number. */
void murk_ranked_sort(murk_ranked *ranked, size_t n);

#endif
