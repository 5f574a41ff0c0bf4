/* Rows in memory, in a scratch file, and in both: every row has the entries
 * that were stored, in every format, and all methods give the same plans, with
 * photons merged and not. Fixed seeds: nothing here is random. */
#include "base/log.h"
#include "check.h"
#include "made_up.h"
#include "placement/evaluator.h"
#include "placement/matrix.h"

#include <signal.h>
#include <string.h>
#include <sys/resource.h>

enum { PHOTONS = 1000, CANDIDATES = 30 };

static bool has_entries(const murk_matrix *matrix, const made_up *m, size_t j)
{
    const murk_row *row = murk_matrix_row(matrix, j);
    const size_t photons = m->problem.photons;
    uint16_t *clarity = calloc(matrix->layout.slots, sizeof *clarity), p;
    size_t slot;
    bool is_equal = true;
    for (murk_row_walk walk = murk_row_begin(&matrix->layout, row);
         murk_row_next(&walk, &slot, &p);) {
        clarity[slot] = p;
    }
    for (size_t i = 0; i < photons; ++i) {
        is_equal = is_equal &&
                   clarity[murk_layout_slot(&matrix->layout, (uint32_t)i)] ==
                       m->clarity[j * photons + i];
    }
    free(clarity);
    return is_equal;
}

static murk_place_result plan(const made_up *m, const murk_matrix *matrix,
                              murk_place_method method)
{
    murk_place_desc desc = murk_place_defaults();
    murk_place_result result = {0};
    murk_error err = {0};
    desc.method = method;
    desc.count = 4;
    desc.restarts = 2;
    desc.nodes = 200;
    CHECK(murk_place_sensors(&result, &m->problem, matrix, &desc, &err) ==
          MURK_OK);
    return result;
}

/* Compares plans from a matrix with those from a matrix in
 * memory. */
static void check_plans(const made_up *m, const murk_matrix *memory,
                        const murk_matrix *other)
{
    for (int method = 0; method < 4; ++method) {
        murk_place_result a = plan(m, memory, (murk_place_method)method);
        murk_place_result b = plan(m, other, (murk_place_method)method);
        CHECK(a.value == b.value && a.upper == b.upper && a.nodes == b.nodes);
        CHECK(a.evaluations == b.evaluations && a.count == b.count);
        CHECK(!memcmp(a.sensor, b.sensor, a.count * sizeof *a.sensor));
        murk_place_release(&a);
        murk_place_release(&b);
    }
}

/* The given share of pairs and number of clarities make rows of one format. */
static void test_rows(murk_row_kind kind, double share, uint32_t levels)
{
    made_up *m = made_up_create(7, PHOTONS, CANDIDATES, share, levels, 3, 2);
    murk_matrix *memory = NULL;
    murk_error err = {0};
    CHECK(!murk_matrix_make(&memory, &m->problem, UINT64_MAX, MURK_MERGE_NEVER,
                            &err));
    const uint64_t all = murk_row_space_bytes(memory->space);
    const uint64_t bytes[] = {0, all / 2, all, UINT64_MAX};
    for (size_t k = 0; k < 4; ++k) {
        murk_matrix *matrix = NULL;
        CHECK(!murk_matrix_make(&matrix, &m->problem, bytes[k],
                                MURK_MERGE_NEVER, &err));
        size_t in_file = 0;
        matrix->space->window_max = 0; /* pages are evicted at every reading */
        for (size_t j = 0; j < CANDIDATES; ++j) {
            CHECK(matrix->row[j].kind == kind && has_entries(matrix, m, j));
            in_file += matrix->row[j].is_in_file;
        }
        /* A quarter of the memory is for pages of the file. */
        CHECK(k == 0  ? in_file == CANDIDATES
              : k < 3 ? in_file > 3 && in_file < CANDIDATES - 3
                      : in_file == 0);
        CHECK((uint64_t)murk_tally_read(&matrix->space->memory) <= bytes[k]);
        CHECK(murk_matrix_bytes(matrix) == murk_matrix_bytes(memory));
        matrix->space->window_max = 100000;
        check_plans(m, memory, matrix);
        murk_matrix_destroy(matrix);
        /* Merged rows are stored again. */
        CHECK(!murk_matrix_make(&matrix, &m->problem, bytes[k],
                                MURK_MERGE_ALWAYS, &err));
        check_plans(m, memory, matrix);
        murk_matrix_destroy(matrix);
    }
    murk_matrix_destroy(memory);
    made_up_destroy(m);
}

/* A matrix that the disk can hold once but not twice stays unmerged. Last: the
 * limit on the size of files stays. */
static void test_too_little_disk_to_merge(void)
{
    made_up *m = made_up_create(7, PHOTONS, CANDIDATES, .3, 1, 1, 2);
    murk_matrix *memory = NULL, *matrix = NULL;
    murk_error err = {0};
    CHECK(!murk_matrix_make(&memory, &m->problem, UINT64_MAX, MURK_MERGE_NEVER,
                            &err));
    const rlim_t size = murk_row_space_bytes(memory->space) * 3 / 2;
    const struct rlimit limit = {size, size};
    signal(SIGXFSZ, SIG_IGN);
    CHECK(setrlimit(RLIMIT_FSIZE, &limit) == 0);
    CHECK(!murk_matrix_make(&matrix, &m->problem, 0, MURK_MERGE_ALWAYS, &err));
    CHECK_TEXT(err.text, "");
    CHECK(matrix && matrix->layout.photons == PHOTONS);
    if (matrix) {
        check_plans(m, memory, matrix);
    }
    murk_matrix_destroy(matrix);
    murk_matrix_destroy(memory);
    made_up_destroy(m);
}

enum { MANY = 1200 };

/* The gains of all candidates, from the last one to the first. */
static void gains_of(const made_up *m, const murk_matrix *matrix,
                     uint64_t gain[MANY])
{
    uint32_t candidate[MANY];
    murk_evaluator evaluator;
    murk_cover empty;
    murk_error err = {0};
    CHECK(!murk_evaluator_init(&evaluator, &m->problem, matrix, NULL, 4, 0,
                               true, &err));
    CHECK(murk_cover_init(&empty, evaluator.layout, evaluator.is_binary));
    for (uint32_t k = 0; k < MANY; ++k) {
        candidate[k] = MANY - 1 - k;
        gain[k] = 0;
    }
    murk_evaluator_gains(&evaluator, &empty, candidate, MANY, 2, 0, gain);
    murk_cover_release(&empty);
    murk_evaluator_release(&evaluator);
}

/* So many rows in a file are evaluated in the order of the file. */
static void test_many_rows_in_a_file(void)
{
    uint64_t in_memory[MANY], in_file[MANY];
    made_up *m = made_up_create(11, 200, MANY, 0.05, 9, 3, 2);
    murk_matrix *memory = NULL, *file = NULL;
    murk_error err = {0};
    CHECK(!murk_matrix_create(&memory, &m->problem, UINT64_MAX, &err));
    CHECK(!murk_matrix_create(&file, &m->problem, 0, &err));
    if (memory && file) {
        gains_of(m, memory, in_memory);
        gains_of(m, file, in_file);
        CHECK(in_memory[7] > 0);
        CHECK(memcmp(in_memory, in_file, sizeof in_memory) == 0);
    }
    murk_matrix_destroy(memory);
    murk_matrix_destroy(file);
    made_up_destroy(m);
}

int main(void)
{
    test_many_rows_in_a_file();
    murk_warn_to(NULL); /* the forecasts */
    test_rows(MURK_ROW_BITS, .3, 1);
    test_rows(MURK_ROW_PACKED, .3, 50);
    test_rows(MURK_ROW_DENSE, .9, 50);
    test_rows(MURK_ROW_LIST, .02, 50);
    test_rows(MURK_ROW_CLEAR_LIST, .02, 1);
    test_too_little_disk_to_merge();
    return check_done();
}
