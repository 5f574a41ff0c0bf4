/* Writes coverage matrices as text: sparse CSV for murk's own reader, and
 * OR-Library's set covering format. */
#include "sparse/matrix.h"

#include "base/file.h"
#include "base/number.h"

#include <stdlib.h>

/* Six digits read back to the same clarity, as one unit of clarity is 1.5e-5.
 */
static void print_entry(FILE *to, size_t row, size_t column, uint16_t clarity)
{
    fprintf(to, "%zu,%zu,%.6g", row + 1, column + 1,
            (double)clarity / MURK_CLEAR);
}

static void print_weight(FILE *to, const murk_sparse_matrix *m, size_t row)
{
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, m->weight[row] / m->unit);
    fputs(text, to);
}

static bool all_weigh_one(const murk_sparse_matrix *m)
{
    bool is_one = m->unit == 1;
    for (size_t i = 0; i < m->rows && is_one; ++i) {
        is_one = m->weight[i] == 1;
    }
    return is_one;
}

/* is_covered[rows], for free(). */
static bool *find_covered(const murk_sparse_matrix *m)
{
    bool *is_covered = calloc(m->rows + 1, sizeof *is_covered);
    for (size_t k = 0; is_covered && k < murk_sparse_matrix_entries(m); ++k) {
        is_covered[m->row[k]] = true;
    }
    return is_covered;
}

static murk_status open_for(murk_file **file, const char *path, void *memory,
                            murk_error *err)
{
    return memory ? murk_file_create(file, path, err)
                  : murk_no_memory(err, path, "to write it");
}

murk_status murk_sparse_matrix_write_csv(const murk_sparse_matrix *m,
                                         const char *path, murk_error *err)
{
    murk_file *file = NULL;
    bool *is_covered = find_covered(m);
    const murk_status status = open_for(&file, path, is_covered, err);
    if (status) {
        free(is_covered);
        return status;
    }
    FILE *to = murk_file_stream(file);
    /* Rows first: weights, and rows that no column covers. */
    const bool has_weights = !all_weigh_one(m);
    const char *end = has_weights ? ",\n" : "\n";
    fprintf(to, "row,column,clarity%s\n", has_weights ? ",weight" : "");
    for (size_t i = 0; i < m->rows; ++i) {
        if (has_weights) {
            fprintf(to, "%zu,,,", i + 1);
            print_weight(to, m, i);
            fputc('\n', to);
        } else if (!is_covered[i]) {
            fprintf(to, "%zu,,\n", i + 1);
        }
    }
    /* Then the entries, by column. */
    for (size_t j = 0; j < m->columns; ++j) {
        if (m->begin[j] == m->begin[j + 1]) {
            fprintf(to, ",%zu,%s", j + 1, end);
        }
        for (size_t k = m->begin[j]; k < m->begin[j + 1]; ++k) {
            print_entry(to, m->row[k], j, m->clarity[k]);
            fputs(end, to);
        }
    }
    free(is_covered);
    return murk_file_commit(&file, err);
}

/* Twelve numbers a line, as in the files of OR-Library. */
#define NUMBERS_A_LINE 12

static void separate(FILE *to, size_t k, size_t n)
{
    fputc((k + 1) % NUMBERS_A_LINE == 0 || k + 1 == n ? '\n' : ' ', to);
}

static void print_rows(FILE *to, const murk_sparse_matrix *m,
                       const murk_sparse_rows *rows)
{
    char text[MURK_NUMBER_SIZE];
    fprintf(to, "%zu %zu\n", m->rows, m->columns);
    for (size_t j = 0; j < m->columns; ++j) {
        murk_number_print(text, m->cost ? m->cost[j] : 1);
        fputs(text, to);
        separate(to, j, m->columns);
    }
    for (size_t i = 0; i < m->rows; ++i) {
        const size_t n = rows->begin[i + 1] - rows->begin[i];
        fprintf(to, "%zu\n", n);
        for (size_t k = 0; k < n; ++k) {
            fprintf(to, "%zu", (size_t)rows->column[rows->begin[i] + k] + 1);
            separate(to, k, n);
        }
    }
    const bool has_weights = !all_weigh_one(m);
    for (size_t i = 0; i < m->rows && has_weights; ++i) {
        print_weight(to, m, i);
        separate(to, i, m->rows);
    }
}

murk_status murk_sparse_matrix_write_or_library(const murk_sparse_matrix *m,
                                                const char *path,
                                                murk_error *err)
{
    if (!m->is_clear) {
        return murk_fail(err, MURK_RUN_FAILED, path,
                         "OR-Library's text holds 0 and 1 only, and some "
                         "sightlines are dimmed; CSV holds them");
    }
    murk_file *file = NULL;
    murk_arena arena = {0};
    murk_sparse_rows rows;
    const bool has_rows = murk_sparse_matrix_by_rows(&rows, m, NULL, &arena);
    murk_status status = open_for(&file, path, has_rows ? &rows : NULL, err);
    if (!status) {
        print_rows(murk_file_stream(file), m, &rows);
        status = murk_file_commit(&file, err);
    }
    murk_arena_release(&arena);
    return status;
}
