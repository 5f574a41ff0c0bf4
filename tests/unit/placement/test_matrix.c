/* The matrix of a known environment: its size, its limits, and Ctrl-C. */
#include "base/interrupt.h"
#include "base/scratch_file.h"
#include "check.h"
#include "made_up.h"
#include "placement/worst_bound.h"

#include <signal.h>
#include <sys/resource.h>

#define MATRIX_MAX ((uint64_t)1 << 32)

static void test_pairs_and_memory(void)
{
    made_up *m = made_up_create(1, 6400, 20, 0.25, 1, 1, 2);
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    uint64_t pairs = 0;
    for (size_t k = 0; k < 6400 * 20; ++k) {
        pairs += m->clarity[k] > 0;
    }
    CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
          MURK_OK);
    CHECK(murk_matrix_pairs(matrix) == pairs);
    const size_t bytes = murk_matrix_bytes(matrix);
    CHECK(bytes > 20 * 6400 / 8 && bytes < 2 * 20 * 6400 / 8); /* bits */
    murk_matrix_destroy(matrix);
    made_up_destroy(m);
}

enum { FULL_PHOTONS = 1000000 };

/* All rows have an entry for every photon. */
static void full_row(void *context, unsigned worker, size_t candidate,
                     murk_sparse_row *row)
{
    (void)worker;
    (void)candidate;
    *row = *(const murk_sparse_row *)context;
}

/* Makes a matrix of 4e6 candidates and 1e6 photons, 8 TB. */
static murk_status make_too_large(murk_matrix **out, murk_error *err)
{
    uint32_t *photon = malloc(FULL_PHOTONS * sizeof *photon);
    uint32_t *weight = malloc(FULL_PHOTONS * sizeof *weight);
    uint16_t *clarity = malloc(FULL_PHOTONS * sizeof *clarity);
    for (uint32_t i = 0; i < FULL_PHOTONS; ++i) {
        photon[i] = i;
        weight[i] = clarity[i] = 1;
    }
    murk_sparse_row full = {FULL_PHOTONS, photon, clarity};
    const murk_problem problem = {.photons = FULL_PHOTONS,
                                  .candidates = 4000000,
                                  .weight = weight,
                                  .get_row = full_row,
                                  .context = &full,
                                  .threads = 1,
                                  .is_reweighed = true};
    /* The sample of rows shows the size, and no further row is computed. */
    const murk_status status =
        murk_matrix_create(out, &problem, 100000000, err);
    free(photon);
    free(weight);
    free(clarity);
    return status;
}

static void test_too_large_is_refused_with_figures(void)
{
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    if (murk_scratch_free_bytes() > 7e12) {
        return; /* such a disk holds the matrix */
    }
    CHECK(make_too_large(&matrix, &err) == MURK_RUN_FAILED);
    CHECK(matrix == NULL);
    CHECK_TEXT(err.where, murk_scratch_folder());
    CHECK_MENTIONS(err.text, "4000000 candidates and 1000000 photons");
    CHECK_MENTIONS(err.text, "8e+03 GB: 0.075 GB in memory");
    CHECK_MENTIONS(err.text, "TMPDIR");
}

/* A matrix that needs a scratch file, in a folder that does not exist. */
static void test_missing_scratch_folder(void)
{
    made_up *m = made_up_create(1, 6400, 20, 0.9, 100, 1, 2);
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    setenv("TMPDIR", "/there/is/no/such/folder", 1);
    CHECK(murk_matrix_create(&matrix, &m->problem, 100000, &err) ==
          MURK_RUN_FAILED);
    CHECK(matrix == NULL);
    CHECK_TEXT(err.where, "/there/is/no/such/folder");
    CHECK_MENTIONS(err.text, "cannot write a scratch file: No such file");
    /* With enough memory no file is needed, though it might have been. */
    CHECK(murk_matrix_create(&matrix, &m->problem, 350000, &err) == MURK_OK);
    murk_matrix_destroy(matrix);
    unsetenv("TMPDIR");
    made_up_destroy(m);
}

/* The sample looks at 32 of 1000 candidates and sees few of the 39 that see
 * all; a file that cannot grow any more ends the run. Last but one: the limit
 * on the size of files stays. */
static void test_growth_behind_the_sample(void)
{
    const struct rlimit limit = {10000, 10000};
    made_up *m = made_up_create(1, 3200, 1000, 0, 100, 1, 2);
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    for (size_t j = 1; j < 40; ++j) {
        for (size_t i = 0; i < 3200; ++i) {
            m->clarity[j * 3200 + i] = 1;
        }
    }
    signal(SIGXFSZ, SIG_IGN);
    CHECK(setrlimit(RLIMIT_FSIZE, &limit) == 0);
    CHECK(murk_matrix_create(&matrix, &m->problem, 280000, &err) ==
          MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "File too large");
    CHECK(matrix == NULL);
    made_up_destroy(m);
}

static void row_then_interrupt(void *context, unsigned worker, size_t candidate,
                               murk_sparse_row *row)
{
    made_up_row(context, worker, candidate, row);
    if (candidate == 7) {
        murk_interrupt_request();
    }
}

/* After Ctrl-C, neither bound makes a further evaluation, and each returns
 * a value that still bounds every plan. */
static void check_bounds_stop(made_up *m, murk_matrix *matrix)
{
    /* Both bounds, of the sum and of the worst of two blocks. */
    const uint32_t plan[] = {0, 1, 2};
    const murk_blocks blocks = {.n = 2, .first = {0, 32, 64}};
    murk_evaluator evaluator;
    murk_bound bound;
    murk_block_layouts layouts;
    murk_worst_bound worst;
    murk_error err = {0};
    uint64_t upper = MURK_SHARE_ONE;
    CHECK(!murk_evaluator_init(&evaluator, &m->problem, matrix, NULL, 3, 0,
                               true, &err));
    CHECK(!murk_bound_init(&bound, &evaluator, &err));
    CHECK(!murk_block_layouts_init(&layouts, &evaluator, &blocks, &err));
    CHECK(!murk_worst_bound_init(&worst, &layouts, &err));
    /* After a request to stop, both return the bound that needs no
     * evaluation. */
    murk_interrupt_request();
    CHECK(murk_bound_tighten(&bound, 3, 0, plan, 3, 400) == evaluator.ceiling);
    CHECK(bound.evaluations == 0);
    CHECK(
        !murk_worst_bound_tighten(&worst, 3, 0, plan, 3, 60, 8, &upper, &err));
    CHECK(worst.bound.evaluations == 0 && upper == MURK_SHARE_ONE);
    murk_worst_bound_release(&worst);
    murk_block_layouts_release(&layouts);
    murk_bound_release(&bound);
    murk_evaluator_release(&evaluator);
}

/* Last: the flag stays up. */
static void test_interrupt_ends_all(void)
{
    made_up *m = made_up_create(1, 64, 200, 0.3, 9, 1, 2);
    murk_matrix *matrix = NULL, *late = NULL;
    murk_place_desc desc = murk_place_defaults();
    murk_place_result result = {0};
    murk_error err = {0};
    desc.count = 3;
    CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
          MURK_OK);
    check_bounds_stop(m, matrix);
    m->problem.get_row = row_then_interrupt;
    CHECK(murk_place_sensors(&result, &m->problem, NULL, &desc, &err) ==
          MURK_INTERRUPTED);
    CHECK(result.sensor == NULL && result.curve == NULL);
    CHECK(murk_place_sensors(&result, &m->problem, matrix, &desc, NULL) ==
          MURK_INTERRUPTED);
    CHECK(result.sensor == NULL);
    CHECK(murk_matrix_create(&late, &m->problem, MATRIX_MAX, NULL) ==
          MURK_INTERRUPTED);
    CHECK(late == NULL);
    murk_matrix_destroy(matrix);
    made_up_destroy(m);
}

int main(void)
{
    test_pairs_and_memory();
    test_too_large_is_refused_with_figures();
    test_missing_scratch_folder();
    test_growth_behind_the_sample();
    test_interrupt_ends_all();
    return check_done();
}
