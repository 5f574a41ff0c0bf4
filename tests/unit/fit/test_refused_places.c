/* Least squares where residuals cannot be had everywhere, or nothing can be
 * determined: no crash, no print, and the right word for it. Deterministic. */
#include "check.h"
#include "fit/least_squares.h"
#include "unbounded.h"

#include <string.h>
#include <unistd.h>

/* log(x) + 5 has no values below 0, where the first full step goes. */
typedef struct edge {
    int refused;
    double says; /* 0: refuses; else what it says in place of a residual */
} edge;

static bool logarithm(void *context, const double *x, double *residual,
                      double *jacobian)
{
    edge *e = context;
    residual[0] = log(x[0]) + 5;
    if (jacobian) {
        jacobian[0] = 1 / x[0];
    }
    if (x[0] > 0) {
        return true;
    }
    ++e->refused;
    residual[0] = e->says;
    return e->says != 0;
}

/* With a bound that is as far from help, and with none. */
static void test_steps_shorten_where_there_are_no_residuals(void)
{
    const double far_below[] = {-100};
    const double says[] = {0, NAN, INFINITY, -INFINITY, 1e200};
    for (size_t i = 0; i < sizeof says / sizeof *says; ++i) {
        for (int is_bounded = 0; is_bounded < 2; ++is_bounded) {
            edge e = {.says = says[i]};
            const murk_least_squares p = {.n = 1,
                                          .rows = 1,
                                          .lower = is_bounded ? far_below
                                                              : none_below,
                                          .upper = none_above,
                                          .residuals = logarithm,
                                          .context = &e};
            double x = 1;
            const murk_least_squares_found found = solve(&x, &p);
            CHECK(found.end == MURK_LEAST_SQUARES_CONVERGED);
            CHECK(e.refused > 0);
            CHECK_NEAR(x, exp(-5), 1e-9);
        }
    }
}

static void test_no_residuals_at_the_start(void)
{
    edge e = {.says = NAN};
    const murk_least_squares p = {.n = 1,
                                  .rows = 1,
                                  .lower = none_below,
                                  .upper = none_above,
                                  .residuals = logarithm,
                                  .context = &e};
    double x = -1;
    const murk_least_squares_found found = solve(&x, &p);
    CHECK(found.end == MURK_LEAST_SQUARES_FAILED);
    CHECK_TEXT(found.why, "there are no finite residuals at the start");
    CHECK(x == -1 && isnan(found.cost) && found.evaluations == 1);
}

/* Values at the start alone, or a Jacobian there alone. */
static bool island(void *context, const double *x, double *residual,
                   double *jacobian)
{
    const bool *lacks_jacobian = context;
    residual[0] = x[0];
    if (jacobian) {
        jacobian[0] = *lacks_jacobian && x[0] != 3 ? NAN : 1;
    }
    return *lacks_jacobian || x[0] == 3;
}

/* Steps become shorter and shorter, which is no convergence. */
static void test_no_residuals_elsewhere(void)
{
    for (int lacks = 0; lacks < 2; ++lacks) {
        bool lacks_jacobian = lacks;
        const murk_least_squares p = {.n = 1,
                                      .rows = 1,
                                      .lower = none_below,
                                      .upper = none_above,
                                      .residuals = island,
                                      .context = &lacks_jacobian};
        double x = 3;
        const murk_least_squares_found found = solve(&x, &p);
        CHECK(found.end == MURK_LEAST_SQUARES_FAILED);
        CHECK_MENTIONS(found.why,
                       "where the search goes there are no finite residuals");
        CHECK(x == 3 && found.cost == 4.5);
    }
}

/* Runs all with stderr in a file, which must stay empty. */
static void test_nothing_is_printed(void)
{
    FILE *file = tmpfile();
    CHECK(file != NULL);
    if (!file) {
        return;
    }
    (void)fflush(stderr);
    const int terminal = dup(STDERR_FILENO);
    (void)dup2(fileno(file), STDERR_FILENO);
    test_no_residuals_at_the_start();
    test_no_residuals_elsewhere();
    (void)fflush(stderr);
    (void)dup2(terminal, STDERR_FILENO);
    (void)close(terminal);
    CHECK(lseek(fileno(file), 0, SEEK_END) == 0);
    (void)fclose(file);
}

int main(void)
{
    test_steps_shorten_where_there_are_no_residuals();
    test_no_residuals_at_the_start();
    test_no_residuals_elsewhere();
    test_nothing_is_printed();
    return check_done();
}
