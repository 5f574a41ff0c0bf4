/* Which candidates: SPOQ, greedy, the best of many, and a bound on how far
 * from the best any plan can be.
 *
 * `spoq` is the paper's algorithm to the letter: random start; sweeps over the
 * sensors in fresh random order, each moved to the candidate that adds most to
 * the others, ties at random; until a sweep brings no gain. `best` takes
 * greedy and SPOQ starts, then certified relocation: a sensor stays on ties,
 * and sweeps go on until one moves nothing, so no single relocation helps and
 * the plan is worth at least n / (2n - 1) of the optimum; then, where the
 * environment is known, branch and bound within `nodes`. `exact` is greedy and
 * branch and bound alone.
 *
 * A plan that sees all that all candidates see is the best, and no further work
 * goes into its count. In a known environment the work of searching is limited
 * to MURK_SEARCH_WORK, and starts to as much again: from where half of it is
 * spent, points of the curve are greedy's, with the bound that greedy's scans
 * give; where all of it is, relocation ends as it stands (is_work_cut).
 *
 * With a target, counts are tried from 1 up; where a count's plan falls short
 * though its bound does not, branch and bound has its say before the next.
 *
 * Under rules (placement/constraints.h) every method keeps to them: a move is
 * one that leaves a plan, and the certificate speaks of those; with a budget
 * greedy goes by gain per cost, against the best single sensor, and sensors
 * are also added where they can be paid. A count that the rules bring to a dead
 * end is met by any plan that a search finds, improved.
 *
 * Source: SPOQ, shared paper of 2013; Nemhauser, Wolsey, Fisher, Math.
 * Program. 14 (1978) 265, doi:10.1007/BF01588971; Cornuejols, Fisher,
 * Nemhauser, Manage. Sci. 23 (1977) 789, doi:10.1287/mnsc.23.8.789 (greedy
 * and Lagrangian bound for facility location). */
#ifndef MURK_PLACEMENT_PLACE_H
#define MURK_PLACEMENT_PLACE_H

#include "placement/constraints.h"
#include "placement/problem.h"

/* In weighings of one photon for one candidate, of which some 16 take a
 * nanosecond: half a minute of one processor. A plan of 5 sensors among 1188
 * places that see 10,000 photons takes a hundredth of it. */
#define MURK_SEARCH_WORK UINT64_C(500000000000)

/* `best` stops after so many starts in a row without gain. */
#define MURK_STARTS_WITHOUT_GAIN 20

typedef enum murk_place_method {
    MURK_PLACE_BEST,
    MURK_PLACE_SPOQ,
    MURK_PLACE_GREEDY,
    MURK_PLACE_EXACT
} murk_place_method;

typedef struct murk_place_desc {
    murk_place_method method;
    size_t count;    /* sensors wanted, 1 .. candidates; with a target: at
                        most */
    uint64_t target; /* 0, or: as few sensors as are worth so much */
    size_t restarts; /* SPOQ starts at most, >= 1; `spoq` makes exactly one */
    uint64_t nodes;  /* work of the branch and bound at most
                        (placement/exact.h), of all counts together, known
                        environment; 0: none */
    uint64_t search_work; /* 0: MURK_SEARCH_WORK */
    uint32_t seed;
    bool with_curve; /* also the best found for 1 .. count - 1 sensors; under
                        rules from the fewest that they allow on; not with a
                        budget */
    const murk_constraints *constraints; /* NULL: none but the count; borrowed.
                                With a budget count is the most sensors, 0: any
                                number */
    bool keep_dominated;                 /* no presolve: for comparison */
} murk_place_desc;

murk_place_desc murk_place_defaults(void); /* best, 1, 200, 1e6, 1, true */

typedef struct murk_curve_point {
    size_t count;
    uint64_t value; /* best found */
    uint64_t upper; /* no plan of that count is worth more */
} murk_curve_point;

typedef struct murk_place_result {
    size_t count;
    size_t *sensor;        /* [count] candidates, increasing */
    uint64_t value;        /* sum_i weight_i f_i (placement/problem.h) */
    uint64_t upper;        /* >= value of every plan of that count */
    bool proven_optimal;   /* value == upper, or the plan is otherwise proven */
    const char *guarantee; /* static text */
    uint64_t cost;         /* of the sensors, by the rules */
    size_t fewest;         /* no fewer sensors reach the target; 0 without */
    uint64_t ceiling;      /* all candidates chosen */
    uint64_t whole;        /* everything: sum_i weight_i * MURK_CLEAR, times
                              the redundancy */
    size_t after_presolve; /* candidates left after dominance */
    size_t restarts;       /* SPOQ starts made */
    uint64_t nodes;        /* of branch and bound */
    bool is_cut;           /* it ended by desc->nodes, unproven */
    bool is_work_cut;      /* relocation or starts ended by MURK_SEARCH_WORK */
    uint64_t evaluations;  /* candidates weighed against a present plan */
    uint64_t looks;        /* calls of look (unknown: each a query) */
    murk_curve_point *curve; /* [curve_points], by count; NULL without */
    size_t curve_points;
} murk_place_result;

/* Known environment: from the matrix. `problem` gives weights and threads. */
murk_status murk_place_known(murk_place_result *result,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_place_desc *desc, murk_error *err);

/* Unknown environment: looks again at each evaluation, O(photons) memory. The
 * same plan as known, decision for decision (presolve, which needs the matrix,
 * must not change it). */
murk_status murk_place_unknown(murk_place_result *result,
                               const murk_problem *problem,
                               const murk_place_desc *desc, murk_error *err);

void murk_place_release(murk_place_result *result);

#endif
