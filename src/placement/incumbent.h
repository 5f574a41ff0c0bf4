/* The best plan of one count after another, by the method that is asked for:
 * greedy, starts, relocation, bound, and branch and bound. */
#ifndef MURK_PLACEMENT_INCUMBENT_H
#define MURK_PLACEMENT_INCUMBENT_H

#include "placement/exact.h"
#include "placement/settings.h"
#include "placement/starts.h"

typedef struct murk_incumbent {
    const murk_evaluator *evaluator;
    const murk_place_desc *desc;
    const murk_constraint_set *set; /* NULL: no rules but a count */
    size_t first, last;             /* sensors tried, at least and at most */
    murk_gain_scan search;          /* spread over all threads */
    murk_bound bound;
    murk_starts starts;
    uint32_t *greedy;       /* [last] in order of choice, without rules */
    uint64_t *greedy_value; /* [last] of its first k + 1 */
    uint64_t *greedy_bound; /* [last] without rules: no plan of k + 1 is worth
                        more, by greedy's scans */
    uint32_t *plan;         /* [last] the best so far */
    size_t size;            /* sensors of plan */
    uint32_t *last_plan;    /* [last] that of one sensor fewer */
    uint32_t *trial;        /* [last] */
    uint32_t *fallback;     /* [last] with conflicts: any plan */
    size_t fallback_size;
    bool is_greedy_done;  /* under rules: without a dead end */
    size_t rounds;        /* of the bound */
    bool has_multipliers; /* the bound, from an earlier count or call */
    murk_place_result *result;
} murk_incumbent;

/* Borrows all but err; gives result->sensor and result->curve their memory.
 * Release the finding also after a failure. */
murk_status murk_incumbent_init(murk_incumbent *out,
                                const murk_evaluator *evaluator,
                                const murk_constraint_set *set,
                                const murk_place_desc *desc,
                                murk_place_result *result, murk_error *err);
void murk_incumbent_release(murk_incumbent *incumbent);

/* Without rules, before the first count: greedy, as far as any plan can need
 * it. */
void murk_incumbent_greedy(murk_incumbent *incumbent);

/* The plan of k sensors, from that of one fewer (NULL: none), worth what *last
 * says: finding->plan, and in *last its value and bound. */
murk_status murk_incumbent_count(murk_incumbent *incumbent, size_t k,
                                 const uint32_t *from, murk_curve_point *last,
                                 murk_error *err);

#endif
