/* A plan over a coverage matrix: the result of `murk place --matrix`, as
 * plan.json and as summary. */
#ifndef MURK_RESULTS_MATRIX_H
#define MURK_RESULTS_MATRIX_H

#include "results/fields.h"
#include "results/session.h"
#include "sparse/matrix.h"

/* What the chosen columns cover. */
typedef struct murk_covering {
    uint64_t *alone, *only; /* [count] */
    uint64_t
        *seen_by; /* [count]; element k is the weight of the rows that at least
                     k + 1 of the chosen columns cover, however little */
    uint64_t sum, whole_rows; /* sum of alone[]; weight of all rows */
} murk_covering;

/* A plan for a matrix, whose members are filled as the matrix is read, columns
 * are chosen and the plan is measured. */
typedef struct murk_matrix_plan {
    murk_session session; /* without scene, stage and light */
    const char *file;     /* path of the matrix, as named by the caller */
    murk_sparse_matrix *matrix;
    murk_place_desc desc;
    murk_detection detection;
    unsigned redundancy;          /* >= 1 */
    double time_limit_s;          /* of the search; 0: none */
    double target, budget;        /* 0: not asked for */
    murk_constraints constraints; /* used if there is a budget */
    int64_t *cost;                /* [matrix->columns]; cost of each column, in
                                     units of MURK_COST_UNIT (plan/poses.h);
                                     NULL without a budget */
    murk_place_result place;
    murk_covering covers;
} murk_matrix_plan;

/* The first lists the fields of plan.json except `identity`, `files` and `run`,
 * the second prints the summary. `of` points to a murk_matrix_plan. */
void murk_results_list_matrix_plan(murk_results_fields *f, const void *of);
void murk_matrix_plan_print(const void *of);

#endif
