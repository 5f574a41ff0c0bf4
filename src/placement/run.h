/* The steps that the placements of placement/place.h, placement/at_least.h and
 * placement/worst.h have in common, each with its own objective: checked
 * settings, ranked candidates, the search for a plan of one count after the
 * other, and the result. */
#ifndef MURK_PLACEMENT_RUN_H
#define MURK_PLACEMENT_RUN_H

#include "placement/search.h"
#include "placement/settings.h"

typedef struct murk_place_run {
    const murk_place_desc *desc;
    const murk_constraint_set *set; /* NULL: no constraint but a count */
    murk_constraint_set own_set;
    murk_evaluator evaluator;
    murk_gain_scan search; /* uses all threads */
    size_t first, last;    /* smallest and largest count tried */
    uint32_t *plan;        /* [last] the best plan of the present count */
    size_t size;           /* sensors of the plan; 0: none was found yet */
    uint64_t value;        /* of the plan, by the objective */
    bool is_open;          /* the bound admits that some count tried so far
                              reaches the target */
    uint32_t *trial;       /* [last] scratch */
    murk_place_result result;
    murk_arena arena; /* for arrays that live as long as the run */
} murk_place_run;

/* Checks settings and constraints, and ranks the candidates. Borrows all but
 * err. murk_place_run_end() must follow, also after a failure. */
murk_status murk_place_run_begin(murk_place_run *run,
                                 const murk_problem *problem,
                                 const murk_matrix *matrix,
                                 const murk_place_desc *desc, murk_error *err);

/* Stores plan[size] if it is the first plan of the count or worth more than the
 * stored one. True if it was stored. */
bool murk_place_run_keep(murk_place_run *run, const uint32_t *plan, size_t size,
                         uint64_t value);

/* With conflicts a search may end early, so this function stores any feasible
 * plan of n in run->search.fallback; without conflicts it does nothing. Fails
 * with MURK_RUN_FAILED if it finds no plan, but not if the run is interrupted.
 */
murk_status murk_place_run_find_fallback(murk_place_run *run, size_t n,
                                         murk_error *err);

/* Finds the best plan of n, run->plan, and stores value and bound in *point.
 * `from` is the plan of one sensor fewer, *point the point of that plan; NULL:
 * none. */
typedef murk_status (*murk_find_count)(void *context, size_t n,
                                       const uint32_t *from,
                                       murk_curve_point *point,
                                       murk_error *err);

/* Tries the counts from first to last, with a target until a plan reaches it.
 * Requests to finish (base/interrupt.h) are taken from here on, in a known
 * environment from murk_place_run_begin() on, until murk_place_run_end(); all
 * counts are tried nevertheless. Fails with MURK_INTERRUPTED if the run is
 * interrupted, or if it finished on request without a plan that reaches the
 * target. */
murk_status murk_place_run_counts(murk_place_run *run, murk_find_count find,
                                  void *context, murk_error *err);

/* The nodes of branch and bound that desc->nodes still allows after those of
 * the counts before. */
uint64_t murk_place_run_nodes_left(const murk_place_run *run,
                                   const murk_place_desc *desc);

/* Lowers the upper bound of each point of the curve to the bound of the next
 * larger count, if that is lower: a plan can be completed to the larger count,
 * and its value does not fall. Does nothing if candidates are in conflict or
 * under a rule on moves, because some plans then cannot be completed. */
void murk_place_run_join_bounds(murk_place_run *run);

/* Completes the result if status is 0, and releases the run. */
murk_status murk_place_run_end(murk_place_result *out, murk_place_run *run,
                               murk_status status);

#endif
