/* The settings of a placement, and the result. */
#ifndef MURK_PLACEMENT_SETTINGS_H
#define MURK_PLACEMENT_SETTINGS_H

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
    uint64_t queries;      /* calls of look (unknown: each a query) */
    murk_curve_point *curve; /* [curve_points], by count; NULL without */
    size_t curve_points;
} murk_place_result;

/* Fails with MURK_BAD_VALUE. */
murk_status murk_place_check(const murk_problem *problem, bool known,
                             const murk_place_desc *desc, murk_error *err);

void murk_place_release(murk_place_result *result);

#endif
