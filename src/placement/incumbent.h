/* Finds the best plan of one count after another, and a bound for each: greedy,
 * starts, relocation, Lagrangian bound, and branch and bound. */
#ifndef MURK_PLACEMENT_INCUMBENT_H
#define MURK_PLACEMENT_INCUMBENT_H

#include "placement/exact.h"
#include "placement/settings.h"
#include "placement/starts.h"

typedef struct murk_incumbent {
    const murk_evaluator *evaluator;
    const murk_place_desc *desc;
    const murk_constraint_set *set; /* NULL: no constraint but a count */
    size_t first, last;             /* smallest and largest count tried */
    murk_gain_scan search;          /* uses all threads */
    murk_bound bound;
    murk_starts starts;
    uint32_t *greedy;       /* [last] in order of choice, without constraints */
    uint64_t *greedy_value; /* [last] value of the first k + 1 */
    uint64_t *greedy_bound; /* [last] without constraints: no plan of k + 1
                               sensors exceeds it, by greedy's scans */
    uint32_t *plan;         /* [last] the incumbent: the best plan so far */
    size_t size;            /* sensors of plan */
    uint32_t *last_plan;    /* [last] the plan of one sensor fewer */
    uint32_t *trial;        /* [last] scratch */
    uint32_t *fallback;     /* [last] with conflicts: any feasible plan */
    size_t fallback_size;
    bool is_greedy_done;  /* under constraints: greedy completed a plan */
    size_t rounds;        /* evaluations of the bound */
    bool has_multipliers; /* the bound has multipliers of an earlier call */
    murk_place_result *result;
} murk_incumbent;

/* Borrows all but err, and allocates result->sensor and result->curve. Call
 * murk_incumbent_release() also after a failure. */
murk_status murk_incumbent_init(murk_incumbent *out,
                                const murk_evaluator *evaluator,
                                const murk_constraint_set *set,
                                const murk_place_desc *desc,
                                murk_place_result *result, murk_error *err);
void murk_incumbent_release(murk_incumbent *incumbent);

/* Without constraints, before the first count: greedy, for as many sensors as
 * any count may need. */
void murk_incumbent_greedy(murk_incumbent *incumbent);

/* Finds the plan of k sensors, incumbent->plan, and stores value and bound in
 * *last. `from` is the plan of one sensor fewer and *last its value; from NULL:
 * none. */
murk_status murk_incumbent_count(murk_incumbent *incumbent, size_t k,
                                 const uint32_t *from, murk_curve_point *last,
                                 murk_error *err);

#endif
