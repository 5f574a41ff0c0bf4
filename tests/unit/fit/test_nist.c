/* Certified regressions come out to six digits, with their standard errors,
 * from both of their starts. Deterministic: no false alarms. */
#include "check.h"
#include "fit/certainty.h"
#include "fit/least_squares.h"
#include "nist.h"

#include <string.h>

static void check_digits(const char *name, const char *what, size_t j,
                         double got, double want)
{
    CHECK(fabs(got - want) <= 1e-6 * fabs(want));
    if (!(fabs(got - want) <= 1e-6 * fabs(want))) {
        printf("  %s: %s %zu is %.12g, want %.12g\n", name, what, j + 1, got,
               want);
    }
}

#define ROWS_MAX 40

/* Certified errors take the variance of a row from the residuals. */
static void check_errors(const nist_problem *p, const double *b)
{
    double residual[ROWS_MAX], jacobian[ROWS_MAX * NIST_N_MAX];
    double scale[NIST_N_MAX];
    (void)nist_residuals((void *)p, b, residual, jacobian);
    for (size_t i = 0; i < p->rows * p->n; ++i) {
        jacobian[i] /= p->residual_deviation;
    }
    for (size_t j = 0; j < p->n; ++j) {
        scale[j] = fabs(b[j]);
    }
    murk_certainty certainty = {0};
    CHECK(murk_certainty_create(&certainty, jacobian, p->rows, p->n, NULL,
                                scale, 2, NULL) == MURK_OK);
    CHECK(certainty.determined == p->n);
    for (size_t j = 0; j < certainty.n; ++j) {
        check_digits(p->name, "error", j, certainty.standard_error[j],
                     p->error[j]);
    }
    murk_certainty_release(&certainty);
}

static void test_values_are_the_certified_ones(const nist_problem *p,
                                               const double *start)
{
    double b[NIST_N_MAX];
    memcpy(b, start, sizeof b);
    const murk_least_squares problem = nist_least_squares(p);
    murk_least_squares_found found;
    murk_error err = {0};
    CHECK(murk_least_squares_solve(&found, b, &problem, &err) == MURK_OK);
    CHECK(found.end == MURK_LEAST_SQUARES_CONVERGED);
    check_digits(p->name, "sum of squares", 0, 2 * found.cost,
                 p->sum_of_squares);
    for (size_t j = 0; j < p->n; ++j) {
        check_digits(p->name, "parameter", j, b[j], p->value[j]);
    }
    check_errors(p, b);
}

int main(void)
{
    for (size_t i = 0; i < NIST_PROBLEMS; ++i) {
        test_values_are_the_certified_ones(&nist_problems[i],
                                           nist_problems[i].start[0]);
        test_values_are_the_certified_ones(&nist_problems[i],
                                           nist_problems[i].start[1]);
    }
    return check_done();
}
