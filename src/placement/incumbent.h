/* Finds the best plan of one count after another by the value, and a bound for
 * each: greedy, starts, relocation, Lagrangian bound, and branch and bound. */
#ifndef MURK_PLACEMENT_INCUMBENT_H
#define MURK_PLACEMENT_INCUMBENT_H

#include "placement/exact.h"
#include "placement/run.h"
#include "placement/starts.h"

typedef struct murk_incumbent {
    murk_place_run *run;
    const murk_place_desc *desc;
    murk_gain_scan *search; /* that of the run */
    murk_bound bound;
    murk_starts starts;
    uint32_t *greedy; /* [last], the largest count of the run: candidates
                         in order of choice, without constraints;
                         not before murk_incumbent_greedy() */
    bool has_greedy;
    uint64_t *greedy_value; /* [last] value of the first k + 1 */
    uint64_t *greedy_bound; /* [last] without constraints: no plan of k + 1
                               sensors exceeds it, by greedy's scans */
    uint32_t *plan;         /* [last] the incumbent: the best plan so far */
    size_t size;            /* sensors of plan */
    bool is_greedy_done;    /* under constraints: greedy completed a plan */
    uint32_t *with_start;   /* [last + start_size] scratch: a plan, then the
                               start plan */
    size_t rounds;          /* evaluations of the bound for the plan, at most */
    bool has_multipliers;   /* the bound has multipliers of an earlier call */
} murk_incumbent;

/* Borrows all but err; plan[run->last] receives the plans. desc may differ from
 * that of the run in target and nodes. Call murk_incumbent_release() also after
 * a failure. */
murk_status murk_incumbent_init(murk_incumbent *out, murk_place_run *run,
                                const murk_place_desc *desc, uint32_t *plan,
                                murk_error *err);
void murk_incumbent_release(murk_incumbent *incumbent);

/* Without constraints, before the first count: greedy up to the largest count
 * of the run, or until the plan reaches the target. */
void murk_incumbent_greedy(murk_incumbent *incumbent);

/* Finds the plan of k sensors, incumbent->plan, and stores value and bound in
 * *last. `from` is the plan of one sensor fewer and *last its value; from NULL:
 * none. Fails with MURK_RUN_FAILED if no plan keeps the constraints or none was
 * found, or with MURK_NO_MEMORY. If the run is interrupted *last may stay
 * unchanged. After a request to finish, the plan is greedy's, or that of one
 * sensor fewer with one more, and the bound that of greedy's scans. */
murk_status murk_incumbent_count(murk_incumbent *incumbent, size_t k,
                                 const uint32_t *from, murk_curve_point *last,
                                 murk_error *err);

/* Adds the counters of the searches to the result of the run. */
void murk_incumbent_count_work(const murk_incumbent *incumbent);

#endif
