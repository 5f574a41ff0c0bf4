/* A coverage matrix outside of any scene: the clarity (placement/problem.h)
 * with which a column (a candidate) covers a row (a photon, a point, a piece of
 * area), and the weight of each row. Rows and columns are those of set covering
 * problems in the literature; in src/placement the entries of one candidate
 * form a row.
 *
 * The matrix is stored by columns. Clarities and weights are whole numbers as
 * everywhere in src/placement. A finished matrix does not change, so any number
 * of threads may read it. */
#ifndef MURK_SPARSE_MATRIX_H
#define MURK_SPARSE_MATRIX_H

#include "placement/constraints.h"
#include "placement/problem.h"

typedef enum murk_matrix_format {
    MURK_MATRIX_DENSE_CSV,  /* one line a row, one cell a column */
    MURK_MATRIX_SPARSE_CSV, /* row,column,clarity,weight: one line an entry */
    MURK_MATRIX_OR_LIBRARY  /* Beasley's set covering files, scp*.txt */
} murk_matrix_format;

typedef struct murk_sparse_matrix {
    murk_matrix_format format; /* of the file that was read; sparse CSV for a
                                  collected matrix */
    char sha256[65];           /* of the file; empty without one */
    size_t rows, columns;
    uint32_t *weight; /* [rows], sum below 2^47 */
    double unit;   /* whole weight / given weight; 1 for a collected matrix */
    size_t *begin; /* [columns + 1]; column j has the entries begin[j] ..
                      begin[j+1] - 1 */
    uint32_t *row; /* [begin[columns]], increasing within a column, from 0 */
    uint16_t *clarity; /* [begin[columns]], 1..MURK_CLEAR */
    bool is_clear;     /* all clarities are MURK_CLEAR */
    double *cost;      /* [columns], or NULL: none given */
    char **name;       /* [columns], or NULL: none given */
} murk_sparse_matrix;

/* Reads a file in any of the formats, which are told apart by the content
 * (formats: doc/reference/matrices.md). Fails with MURK_BAD_FILE at
 * FILE:LINE:COLUMN, or at FILE or FILE:LINE if no single cell is at fault, or
 * with MURK_NO_MEMORY. A file on the disk may have 4e9 bytes at most. The
 * memory in use is in proportion to the size of the file, whatever sizes the
 * header of the file states. */
murk_status murk_sparse_matrix_read(murk_sparse_matrix **out, const char *path,
                                    murk_error *err);

/* Collects the entries of all candidates of a problem, each candidate as a
 * column. The weights are divided by their greatest common divisor, which
 * changes no plan. Fails with MURK_RUN_FAILED beyond max_entries, or with
 * MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_sparse_matrix_collect(murk_sparse_matrix **out,
                                       const murk_problem *problem,
                                       size_t max_entries, murk_error *err);
void murk_sparse_matrix_destroy(murk_sparse_matrix *matrix); /* accepts NULL */

static inline size_t
murk_sparse_matrix_entries(const murk_sparse_matrix *matrix)
{
    return matrix->begin[matrix->columns];
}

/* The entries of a matrix sorted by row: row i has column[k] and clarity[k] for
 * begin[i] <= k < begin[i + 1]. */
typedef struct murk_sparse_rows {
    size_t *begin; /* [rows + 1] */
    uint32_t *column;
    uint16_t *clarity;
} murk_sparse_rows;

/* Sorts the entries of the rows that is_wanted[rows] marks (is_wanted NULL: of
 * all rows); other rows are empty in *out. The arena owns the arrays. Returns
 * false when out of memory. */
bool murk_sparse_matrix_by_rows(murk_sparse_rows *out,
                                const murk_sparse_matrix *matrix,
                                const bool *is_wanted, murk_arena *arena);

/* The placement problem of the matrix, with redundancy 1; borrows the
 * matrix. */
murk_problem murk_sparse_matrix_problem(murk_sparse_matrix *matrix,
                                        unsigned threads);

/* ---- writing: each file complete or not at all (base/file.h) ---- */

/* Writes sparse CSV, which murk_sparse_matrix_read() reads back to the same
 * rows, columns, clarities and weights, if there is an entry and a weight above
 * 0. Whole weights that add up to more than 2^46 are scaled down and rounded in
 * reading. Costs and names of columns are not written. */
murk_status murk_sparse_matrix_write_csv(const murk_sparse_matrix *matrix,
                                         const char *path, murk_error *err);

/* Writes OR-Library's text, with costs 1 if none are given; the weights follow
 * the last row unless all are 1. Names of columns are not written. Fails with
 * MURK_RUN_FAILED unless is_clear, because the format has entries 0 and 1
 * only. */
murk_status
murk_sparse_matrix_write_or_library(const murk_sparse_matrix *matrix,
                                    const char *path, murk_error *err);

/* The question of an integer program. */
typedef struct murk_lp_goal {
    size_t count;    /* with target 0: the best plan of exactly so many columns,
                        or of any number if count is 0; with a target: used only
                        to check the constraints, as the maximum number of
                        columns (0: no maximum) */
    uint64_t target; /* 0, or: the fewest columns that reach this value, in
                        whole weight * whole clarity */
    const murk_constraints *constraints; /* NULL: none */
    unsigned redundancy; /* entries of a row that count; 0 and 1 mean one. With
                            more, the target is a sum over all entries that
                            count */
} murk_lp_goal;

/* Writes the problem as an LP file (CPLEX's format). Rows with equal entries
 * become one row with the summed weight; rows without entries and rows of
 * weight 0 are left out. With w_i the weight of row i, p_ij the clarity of an
 * entry (0..1), x_j in {0, 1} for "column j is chosen" and y in 0..1 for "row i
 * is covered (by column j)":
 *
 *     maximise sum w_i y_i, y_i <= sum_j x_j        if all are clear, else
 *     maximise sum w_i p_ij y_ij, y_ij <= x_j, sum_j y_ij <= 1
 *
 * with the sums over the columns j that have an entry in row i (with redundancy
 * k: y_i <= k, sum_j y_ij <= k, and the objective divided by k), and sum x_j =
 * count unless count is 0; or, with a target, minimise sum x_j such that the
 * value above reaches the target. Constraints on plans are further constraints
 * of the program: the budget in whole units, counts by class, x = 1 for fixed
 * columns, at most one column of a site and of a conflicting pair. Values are
 * in weights as given. Fails with MURK_RUN_FAILED if more than 1e7 entries are
 * left, if more than 1e7 pairs of candidates of different sites are in
 * conflict, or if the file cannot be written; with MURK_BAD_VALUE if a
 * constraint is malformed, if the constraints contradict each other, or if this
 * run has read the file at `path`; or with MURK_NO_MEMORY.
 *
 * Source: Church, ReVelle, Pap. Reg. Sci. 32 (1974) 101,
 * doi:10.1007/BF01942293; Cornuejols, Fisher, Nemhauser, Manage. Sci. 23 (1977)
 * 789, doi:10.1287/mnsc.23.8.789. */
murk_status murk_sparse_matrix_write_lp(const murk_sparse_matrix *matrix,
                                        const murk_lp_goal *goal,
                                        const char *path, murk_error *err);

#endif
