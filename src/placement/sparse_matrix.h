/* A coverage matrix outside of any scene: which column (a candidate) covers
 * which row (a photon, a point, a piece of area), how clearly, and how much
 * each row weighs.
 *
 * Kept by columns, in whole numbers like all of placement. Immutable once
 * made, so any number of threads may look. */
#ifndef MURK_PLACEMENT_SPARSE_MATRIX_H
#define MURK_PLACEMENT_SPARSE_MATRIX_H

#include "placement/constraints.h"
#include "placement/problem.h"

typedef enum murk_matrix_format {
    MURK_MATRIX_DENSE_CSV,  /* a line a row, a cell a column */
    MURK_MATRIX_SPARSE_CSV, /* row,column,clarity,weight: a line an entry */
    MURK_MATRIX_OR_LIBRARY  /* Beasley's set covering files, scp*.txt */
} murk_matrix_format;

typedef struct murk_sparse_matrix {
    murk_matrix_format format; /* it was read from */
    char sha256[65];           /* of the file; empty without one */
    size_t rows, columns;
    uint32_t *weight;  /* [rows], sum below 2^47 */
    double unit;       /* whole weight / weight as given */
    size_t *begin;     /* [columns + 1]; of column j: begin[j] .. begin[j+1] */
    uint32_t *row;     /* [begin[columns]], rising within a column, from 0 */
    uint16_t *clarity; /* likewise, 1..MURK_CLEAR */
    bool is_clear;     /* all clarities are MURK_CLEAR */
    double *cost;      /* [columns], or NULL: none given */
    char **name;       /* [columns], or NULL: none given */
} murk_sparse_matrix;

/* Reads any of the formats, told from the content; scenes/README.md describes
 * them. Fails with MURK_BAD_FILE at FILE:LINE:COLUMN. At most 4 GB; memory is
 * in proportion to the file's size, whatever its header says. */
murk_status murk_sparse_matrix_read(murk_sparse_matrix **out, const char *path,
                                    murk_error *err);

/* All looks of a problem, its weights divided by their greatest common
 * divisor, which changes no plan. Fails with MURK_RUN_FAILED beyond
 * most_entries. */
murk_status murk_sparse_matrix_collect(murk_sparse_matrix **out,
                                       const murk_problem *problem,
                                       size_t max_entries, murk_error *err);
void murk_sparse_matrix_destroy(murk_sparse_matrix *matrix); /* NULL is fine */

static inline size_t
murk_sparse_matrix_entries(const murk_sparse_matrix *matrix)
{
    return matrix->begin[matrix->columns];
}

/* The placement problem over it; borrows it. */
murk_problem murk_sparse_matrix_problem(murk_sparse_matrix *matrix,
                                        unsigned threads);

/* ---- writing: each file whole or not at all (base/file.h) ---- */

/* Sparse CSV, which reads back to the same matrix. */
murk_status murk_sparse_matrix_write_csv(const murk_sparse_matrix *matrix,
                                         const char *path, murk_error *err);

/* OR-Library's text, all costs 1 where none are given; weights that differ
 * follow behind the last row. Fails with MURK_RUN_FAILED unless is_clear: the
 * format knows 0 and 1 only. */
murk_status
murk_sparse_matrix_write_or_library(const murk_sparse_matrix *matrix,
                                    const char *path, murk_error *err);

/* What a solver of integer programs is asked. */
typedef struct murk_lp_goal {
    size_t count;    /* of so many columns the best; 0: as many as pay */
    uint64_t target; /* not 0: the fewest worth so much, in weight * clarity */
    const murk_constraints *constraints; /* NULL: none */
    unsigned redundancy; /* views of a row that count, 0 or 1: one; the
                            target is then in weight * clarity * views */
} murk_lp_goal;

/* The problem as an LP file (CPLEX's format). Rows that are covered alike are
 * one row of their summed weight. With x_j in {0, 1} for "column j is chosen"
 * and y in 0..1 for "this row is covered (by column j)":
 *
 *     maximise sum w_i y_i, y_i <= sum_j x_j        where all are clear, else
 *     maximise sum w_i p_ij y_ij, y_ij <= x_j, sum_j y_ij <= 1
 *
 * (k views count: y_i <= k, sum_j y_ij <= k, and the objective over k), with
 * sum x_j = count; or the least sum x_j that reaches the target. Rules
 * are further rows: the budget in the rules' whole units, counts by class, x =
 * 1 for fixed ones, at most one of a site and of a pair that excludes each
 * other. The objective is in weights as given. Fails with MURK_RUN_FAILED
 * beyond 1e7 entries or excluding pairs. Source: Church, ReVelle, Pap. Reg.
 * Sci. 32 (1974) 101, doi:10.1007/BF01942293; Cornuejols, Fisher, Nemhauser,
 * Manage. Sci. 23 (1977) 789, doi:10.1287/mnsc.23.8.789. */
murk_status murk_sparse_matrix_write_lp(const murk_sparse_matrix *matrix,
                                        const murk_lp_goal *goal,
                                        const char *path, murk_error *err);

#endif
