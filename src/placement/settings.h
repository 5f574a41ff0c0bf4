/* The settings and the result of a placement, and the check of the settings. */
#ifndef MURK_PLACEMENT_SETTINGS_H
#define MURK_PLACEMENT_SETTINGS_H

#include "base/kinds.h"
#include "placement/constraints.h"
#include "placement/problem.h"

/* Default limit of the searches' work, in evaluations of one photon for one
 * candidate. Some 16 take a nanosecond, so this is half a minute of one
 * processor. A plan of 5 sensors among 1188 candidates and 10,000 photons takes
 * a hundredth of it. */
#define MURK_SEARCH_WORK UINT64_C(500000000000)

/* Default memory of rows. */
#define MURK_ROW_MEMORY ((uint64_t)1 << 30)

/* MURK_PLACE_BEST makes no further start after this many in a row without gain.
 * A choice, not a measurement. */
#define MURK_STARTS_WITHOUT_GAIN 20

typedef struct murk_place_desc {
    murk_place_method method;
    size_t count;    /* sensors of the plan, 1..candidates; with a target the
                        maximum */
    uint64_t target; /* 0, or the value that the fewest sensors are to reach */
    size_t restarts; /* maximum number of SPOQ starts for the plan (with a
                        target for each count), >= 1; smaller counts of a curve
                        get fewer; MURK_PLACE_SPOQ makes one for each count */
    uint64_t nodes; /* maximum work of branch and bound (placement/exact.h), all
                       counts together; known environment only; 0: no branch and
                       bound */
    uint64_t search_work; /* maximum work of the searches; 0: MURK_SEARCH_WORK.
                             It counts evaluations, whether or not a row is
                             cached */
    uint64_t row_memory;  /* bytes of cached rows in an unknown environment;
                             callers make the matrix of a known environment
                             with it */
    uint32_t seed;
    bool with_curve; /* also find plans of fewer sensors, from 1 or from the
                        smallest feasible count; not with a budget */
    const murk_constraints
        *constraints; /* borrowed; NULL: none but the count. With a budget
                         `count` is the maximum, and 0 means any number */
    const uint32_t *start_plan; /* [start_size] borrowed: distinct candidates at
                                   which the search begins (placement/place.h);
                                   NULL: no start plan is given */
    size_t start_size;
    bool is_of_sequence; /* one of many plans of a scene that changes: greedy
                            makes a cheap bound, as the search from a start plan
                            does, and takes the curve from its own plan */
    bool keep_dominated; /* without presolve, for comparison */
} murk_place_desc;

murk_place_desc
murk_place_defaults(void); /* best, 1 sensor, 200 starts, 1e6 nodes, 1 GiB of
                              rows, seed 1, with a curve */

/* True if the search ends with branch and bound, in a known environment. A
 * search that begins at a start plan is meant to be short, so only
 * MURK_PLACE_EXACT proves plans there. */
static inline bool murk_place_has_proof(const murk_place_desc *desc)
{
    return desc->method == MURK_PLACE_EXACT ||
           (desc->method == MURK_PLACE_BEST && !desc->start_plan);
}

typedef struct murk_curve_point {
    size_t count;
    uint64_t value; /* of the best plan found, as in murk_place_result */
    uint64_t upper; /* an upper bound on the value of any plan of exactly
                       `count` sensors that the constraints admit */
} murk_curve_point;

typedef struct murk_place_result {
    size_t count;
    size_t *sensor;        /* [count] candidates, increasing */
    uint64_t value;        /* sum_i weight_i f_i (placement/problem.h), or the
                              value that placement/at_least.h or
                              placement/worst.h defines */
    uint64_t upper;        /* an upper bound on the value of any plan of `count`
                              sensors (with a budget: of any number up to
                              desc->count) that the constraints admit */
    bool proven_optimal;   /* value (less the cost of moves) == upper */
    const char *guarantee; /* a fraction of the optimum that a theorem assures,
                              or "none"; static text */
    uint64_t cost;         /* of the sensors, in the unit of the constraints */
    bool has_moves; /* the constraints have a rule on moves, so `upper` and the
                       points of the curve are of the value less the cost of
                       the moves, or 0 if the cost is larger */
    size_t moves;   /* of the plan */
    uint64_t move_cost; /* of these moves, as a value */
    size_t fewest;      /* lower bound on the number of sensors that reach the
                           target; 0 without a target */
    uint64_t ceiling;   /* value of all candidates together */
    uint64_t whole;     /* sum_i weight_i * MURK_CLEAR, times the redundancy */
    size_t after_presolve; /* candidates that the searches treat as undominated
                              (placement/evaluator.h) */
    size_t restarts;       /* SPOQ starts made; murk_place_sensors() leaves out
                              those for the smaller counts of a curve */
    size_t started_from; /* candidates of desc->start_plan in the plan that the
                            search began with */
    uint64_t nodes;      /* work of branch and bound */
    bool is_cut; /* branch and bound ended without a proof, at desc->nodes or by
                    a request to finish */
    bool is_work_cut;     /* the searches ended at desc->search_work */
    bool is_interrupted;  /* the searches were asked to finish
                             (base/interrupt.h): plan, bound and counters are
                             those reached so far, which depend on the time of
                             the request */
    bool is_late;         /* likewise by the deadline of the searches */
    uint64_t evaluations; /* gains of candidates that were computed */
    uint64_t queries;     /* rows evaluated or added, whether cached or asked of
                             the problem; unknown environment only */
    murk_curve_point
        *curve; /* [curve_points], by increasing count; NULL without a curve */
    size_t curve_points;
} murk_place_result;

/* Checks the settings against the problem. Fails with MURK_BAD_VALUE. */
murk_status murk_place_check(const murk_problem *problem, bool known,
                             const murk_place_desc *desc, murk_error *err);

void murk_place_release(murk_place_result *result);

/* The value of the plan less the cost of its moves, or 0 if the cost is larger:
 * the value that result->upper bounds. */
static inline uint64_t murk_place_objective(const murk_place_result *result)
{
    return result->value > result->move_cost ? result->value - result->move_cost
                                             : 0;
}

#endif
