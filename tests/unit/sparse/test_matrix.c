/* A coverage matrix is the same whichever format it comes in, and after it was
 * written and read again; its weights keep their ratios exactly where whole
 * numbers can. Nothing here is random but for a fixed seed. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "base/file.h"
#include "base/rng.h"
#include "check.h"
#include "sparse/matrix.h"

#include <stdlib.h>
#include <unistd.h>

static char path[200], other[200];

static murk_sparse_matrix *read_text(const char *text)
{
    murk_sparse_matrix *m = NULL;
    murk_error err = {0};
    CHECK(murk_file_write(path, text, strlen(text), &err) == MURK_OK);
    CHECK(murk_sparse_matrix_read(&m, path, &err) == MURK_OK);
    if (!m) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return m;
}

static uint16_t at(const murk_sparse_matrix *m, size_t row, size_t column)
{
    for (size_t k = m->begin[column]; k < m->begin[column + 1]; ++k) {
        if (m->row[k] == row) {
            return m->clarity[k];
        }
    }
    return 0;
}

static bool are_equal(const murk_sparse_matrix *a, const murk_sparse_matrix *b)
{
    const size_t entries = murk_sparse_matrix_entries(a);
    return a->rows == b->rows && a->columns == b->columns &&
           a->unit == b->unit && a->is_clear == b->is_clear &&
           entries == murk_sparse_matrix_entries(b) &&
           memcmp(a->weight, b->weight, a->rows * sizeof *a->weight) == 0 &&
           memcmp(a->begin, b->begin, (a->columns + 1) * sizeof *a->begin) ==
               0 &&
           memcmp(a->row, b->row, entries * sizeof *a->row) == 0 &&
           memcmp(a->clarity, b->clarity, entries * sizeof *a->clarity) == 0;
}

static void check_texts_are_equal(const char *one, const char *two)
{
    murk_sparse_matrix *a = read_text(one), *b = read_text(two);
    if (!are_equal(a, b)) {
        printf("not equal:\n%s\n%s\n", one, two);
    }
    CHECK(are_equal(a, b));
    murk_sparse_matrix_destroy(a);
    murk_sparse_matrix_destroy(b);
}

static void test_all_formats_hold_the_same_matrix(void)
{
    const char *const dense = "1,0,1,0\n0,1,0,0\n0,0,0,0\n";
    static const char *const same[] = {
        "\357\273\2771,0,1,0\n0,1,0,0\n0,0,0,0", /* a mark, no end of line */
        "# said\r\n1, 0 ,\t1,0.0\r\n\r\n+0,1e0,0,0\r\n  # more\n0,0,0,0\r\n",
        "a,b,c,d\n1,0,1,0\n0,1,0,0\n0,0,0,0\n",
        "row,a,b,c,d\nx,1,0,1,0\ny,0,1,0,0\nz,0,0,0,0\n",
        ",a,b,c,d\n7,1,0,1,0\n8,0,1,0,0\n9,0,0,0,0\n",
        "a,b,c,weight,d\n1,0,1,1,0\n0,1,0,1,0\n0,0,0,1,0\n",
        "row,column\n1,1\n1,3\n2,2\n3,\n,4\n",
        "column,row,clarity\n2,2,1\n4,3,0\n3,1,\n1,1,1.0\n",
        "weight,row,column\n,3,\n,,4\n1,2,2\n,1,3\n1,1,1\n",
        "3 4 1 1 1 1\n2 1 3\n1 2\n0\n",
        " 3\t4\r\n5 6.5\n7 8\n2 3 1\n1\n2 0 \n",
        "3 4 1 1 1 1 2 1 3 1 2 0 1 1 1",
    };
    for (size_t i = 0; i < sizeof same / sizeof *same; ++i) {
        check_texts_are_equal(dense, same[i]);
    }
    check_texts_are_equal("1,.5\n.25,0\n",
                          "row,column,clarity\n2,1,.25\n1,2,.5\n1,1,\n");
    murk_sparse_matrix *m = read_text(dense);
    CHECK(m->rows == 3 && m->columns == 4 && m->is_clear);
    CHECK(at(m, 0, 0) == MURK_CLEAR && at(m, 0, 1) == 0);
    CHECK(at(m, 0, 2) == MURK_CLEAR && at(m, 1, 1) == MURK_CLEAR);
    CHECK(murk_sparse_matrix_entries(m) == 3 && m->begin[3] == m->begin[4]);
    murk_sparse_matrix_destroy(m);
}

static void test_names_and_costs_are_stored(void)
{
    murk_sparse_matrix *m =
        read_text("\"near, the door\",\"a \"\"b\"\"\",weight\n1,0,2\n");
    CHECK(m->columns == 2 && m->name && m->weight[0] == 2);
    CHECK_TEXT(m->name[0], "near, the door");
    CHECK_TEXT(m->name[1], "a \"b\"");
    murk_sparse_matrix_destroy(m);
    m = read_text("1 2 3 4.5\n1 2\n");
    CHECK(m->cost && m->cost[0] == 3 && m->cost[1] == 4.5 && !m->name);
    murk_sparse_matrix_destroy(m);
}

static void check_weights(const char *text, double unit, uint32_t first,
                          uint32_t second)
{
    murk_sparse_matrix *m = read_text(text);
    CHECK(m->unit == unit);
    CHECK(m->weight[0] == first && m->weight[1] == second);
    murk_sparse_matrix_destroy(m);
}

static void test_weights_are_whole_by_a_power_of_ten(void)
{
    check_weights("a,weight\n1,3\n1,0\n", 1, 3, 0);
    check_weights("a,weight\n1,.1\n1,.35\n", 100, 10, 35);
    check_weights("a,weight\n1,1e-12\n1,3e-12\n", 1e12, 1, 3);
    check_weights("a,weight\n1,1e12\n1,0\n", UINT32_MAX / 1e12, UINT32_MAX, 0);
    /* a third has no last digit: as fine as 32 bits are */
    murk_sparse_matrix *m = read_text("a,weight\n1,1\n1,0.33333333333333331\n");
    CHECK(m->weight[0] == UINT32_MAX && m->weight[1] == UINT32_MAX / 3);
    murk_sparse_matrix_destroy(m);
}

typedef murk_status (*writer)(const murk_sparse_matrix *, const char *,
                              murk_error *);

static void check_comes_back(const murk_sparse_matrix *m, writer write)
{
    murk_sparse_matrix *again = NULL;
    murk_error err = {0};
    CHECK(write(m, other, &err) == MURK_OK);
    CHECK(murk_sparse_matrix_read(&again, other, &err) == MURK_OK);
    CHECK(again && are_equal(m, again));
    murk_sparse_matrix_destroy(again);
}

/* A problem of every clarity there is, over rows that weigh 6, 12, .. */
static void get_row(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *out)
{
    static uint32_t photon[MURK_CLEAR];
    static uint16_t clarity[MURK_CLEAR];
    (void)context;
    (void)worker;
    for (uint32_t i = 0; i < MURK_CLEAR; ++i) {
        photon[i] = i;
        clarity[i] = (uint16_t)(i + 1);
    }
    *out = (murk_sparse_row){candidate ? 0 : MURK_CLEAR, photon, clarity};
}

static void test_what_is_written_reads_back(void)
{
    /* A matrix with weights survives CSV, and has no OR-Library form. */
    murk_error err = {0};
    murk_sparse_matrix *m = read_text("a,b,weight\n1,0,.125\n.3,1,7\n0,0,2\n");
    check_comes_back(m, murk_sparse_matrix_write_csv);
    CHECK(murk_sparse_matrix_write_or_library(m, other, &err) ==
          MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "0 and 1 only");
    murk_sparse_matrix_destroy(m);
    /* Matrices of ones and zeros survive both formats. */
    m = read_text("1,0,0\n1,0,1\n0,0,0\n");
    check_comes_back(m, murk_sparse_matrix_write_csv);
    check_comes_back(m, murk_sparse_matrix_write_or_library);
    murk_sparse_matrix_destroy(m);
    /* So do matrices that were read from the OR-Library format. */
    m = read_text("2 3 1 1 1\n1 2\n2 1 3\n.5 3\n");
    check_comes_back(m, murk_sparse_matrix_write_csv);
    check_comes_back(m, murk_sparse_matrix_write_or_library);
    murk_sparse_matrix_destroy(m);

    /* A matrix from a placement problem divides weights by their common
     * factor. */
    uint32_t *weight = malloc(MURK_CLEAR * sizeof *weight);
    for (uint32_t i = 0; i < MURK_CLEAR; ++i) {
        weight[i] = 6 * (1 + i % 5);
    }
    const murk_problem problem = {.photons = MURK_CLEAR,
                                  .candidates = 2,
                                  .weight = weight,
                                  .get_row = get_row,
                                  .threads = 1};
    CHECK(murk_sparse_matrix_collect(&m, &problem, MURK_CLEAR, &err) ==
          MURK_OK);
    CHECK(m->weight[0] == 1 && m->weight[4] == 5 && !m->is_clear);
    check_comes_back(m, murk_sparse_matrix_write_csv);
    murk_sparse_matrix_destroy(m);
    /* More photons than the limit are refused. */
    m = NULL;
    err = (murk_error){0};
    CHECK(murk_sparse_matrix_collect(&m, &problem, MURK_CLEAR - 1, &err) ==
          MURK_RUN_FAILED);
    CHECK(m == NULL);
    CHECK_MENTIONS(err.text, "65535 photons, a matrix may have 65534");
    free(weight);
}

/* Any order of the lines gives the same. */
static void test_lines_may_be_shuffled(void)
{
    enum { ROWS = 40, COLUMNS = 30 };
    char sorted[40000] = "row,column,clarity\n", mixed[40000];
    strcpy(mixed, sorted);
    for (int pass = 0; pass < 2; ++pass) {
        char *text = pass ? mixed : sorted;
        for (int k = 0; k < ROWS * COLUMNS; ++k) {
            /* 7 has no divisor in common with 1200 */
            const int n = pass ? 7 * k % (ROWS * COLUMNS) : k;
            const double u = murk_random(1, MURK_EMIT, (uint64_t)n, 0, 0).u[0];
            sprintf(text + strlen(text), "%d,%d,%.3f\n", n / COLUMNS + 1,
                    n % COLUMNS + 1, u < 0.3 ? u : 0);
        }
    }
    check_texts_are_equal(sorted, mixed);
}

int main(void)
{
    snprintf(path, sizeof path, "%s/murk-matrix-%ld.csv", P_tmpdir,
             (long)getpid());
    snprintf(other, sizeof other, "%s/murk-matrix-%ld.out", P_tmpdir,
             (long)getpid());
    test_all_formats_hold_the_same_matrix();
    test_names_and_costs_are_stored();
    test_weights_are_whole_by_a_power_of_ten();
    test_what_is_written_reads_back();
    test_lines_may_be_shuffled();
    unlink(path);
    unlink(other);
    return check_done();
}
