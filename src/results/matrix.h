/* A plan over a coverage matrix: what `murk place --matrix` works out, and how
 * it is told. */
#ifndef MURK_RESULTS_MATRIX_H
#define MURK_RESULTS_MATRIX_H

#include "results/fields.h"
#include "results/session.h"
#include "sparse/matrix.h"

/* What the chosen columns cover, in weight * clarity. */
typedef struct murk_covering {
    uint64_t *alone, *only;   /* [count] */
    uint64_t *seen_by;        /* [count]: weight covered by 1, 2, .. or more */
    uint64_t sum, whole_rows; /* of alone; of all weights */
} murk_covering;

/* The command as far as it has come. */
typedef struct murk_matrix_plan {
    murk_session session; /* without scene, stage and light */
    const char *file;     /* of the matrix, as named */
    murk_sparse_matrix *matrix;
    murk_place_desc desc;
    murk_detection detection;
    unsigned redundancy;          /* >= 1 */
    double target, budget;        /* 0: not asked for */
    murk_constraints constraints; /* with a budget */
    int64_t *cost;                /* [matrix->columns] of the rules */
    murk_place_result place;
    murk_covering covers;
} murk_matrix_plan;

/* Rows of plan.json, yet without `run`, and the summary; of: a
 * murk_matrix_plan. */
void murk_results_list_matrix_plan(murk_results_fields *f, const void *of);
void murk_matrix_plan_print(const void *of);

#endif
