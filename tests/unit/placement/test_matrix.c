/* The matrix of a known environment: its size, its limits, and Ctrl-C. */
#include "base/interrupt.h"
#include "check.h"
#include "made_up.h"
#include "placement/worst_bound.h"

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
    const size_t bytes = murk_matrix_memory_bytes(matrix);
    CHECK(bytes > 20 * 6400 / 8 && bytes < 2 * 20 * 6400 / 8); /* bits */
    murk_matrix_destroy(matrix);
    made_up_destroy(m);
}

static void test_too_large_is_refused_with_figures(void)
{
    made_up *m = made_up_create(1, 6400, 20, 0.9, 100, 1, 1);
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_create(&matrix, &m->problem, 100000, &err) ==
          MURK_RUN_FAILED);
    CHECK(matrix == NULL);
    CHECK_MENTIONS(err.text, "20 candidates and 6400 photons");
    CHECK_MENTIONS(err.text, "0.0001 GB");
    made_up_destroy(m);
}

/* The pilot looks at 32 of 1000 candidates and sees few of the 39 that see all;
 * the watch while filling counts what is stored. */
static void test_growth_behind_the_pilot_is_noticed(void)
{
    made_up *m = made_up_create(1, 3200, 1000, 0, 100, 1, 1);
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    for (size_t j = 1; j < 40; ++j) {
        for (size_t i = 0; i < 3200; ++i) {
            m->clarity[j * 3200 + i] = 1;
        }
    }
    const uint64_t max = 1000 * 200;
    CHECK(murk_matrix_create(&matrix, &m->problem, max, &err) ==
          MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "GB");
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
    test_growth_behind_the_pilot_is_noticed();
    test_interrupt_ends_all();
    return check_done();
}
