/* Quantiles against published tables, and ranks against their own law. */
#include "base/quantile.h"
#include "check.h"

/* Fisher and Yates, Statistical Tables, table III: two-sided 5 % and 1 %. */
static void test_student(void)
{
    static const struct {
        size_t degrees;
        double t975, t995;
    } table[] = {{1, 12.706205, 63.656741}, {2, 4.302653, 9.924843},
                 {3, 3.182446, 5.840909},   {4, 2.776445, 4.604095},
                 {9, 2.262157, 3.249836},   {10, 2.228139, 3.169273},
                 {19, 2.093024, 2.860935},  {120, 1.979930, 2.617421}};
    for (size_t i = 0; i < sizeof table / sizeof *table; ++i) {
        CHECK_NEAR(murk_student_upper(0.025, table[i].degrees), table[i].t975,
                   1e-6);
        CHECK_NEAR(murk_student_upper(0.005, table[i].degrees), table[i].t995,
                   1e-6);
        CHECK_NEAR(murk_student_upper(0.975, table[i].degrees), -table[i].t975,
                   1e-6);
    }
    CHECK_NEAR(murk_student_upper(0.025, 1000000), 1.959966, 1e-6);
    CHECK_NEAR(murk_student_upper(0.5, 7), 0, 1e-12);
}

/* P(K <= k) summed term by term with whole binomials. */
static double at_max(size_t n, double q, size_t k)
{
    double term = pow(1 - q, (double)n), sum = 0;
    for (size_t i = 0; i <= k; ++i) {
        sum += term;
        term *= q / (1 - q) * (double)(n - i) / (double)(i + 1);
    }
    return sum;
}

static void test_ranks(void)
{
    const double miss = 0.025;
    for (size_t n = 1; n <= 400; ++n) {
        const murk_order_statistics r = murk_quantile_ranks(n, 0.05, miss);
        CHECK((double)r.value >= 0.05 * (double)n - 1e-9 &&
              (double)r.value - 1 < 0.05 * (double)n);
        if (r.lower > 0) {
            CHECK(at_max(n, 0.05, r.lower - 1) <= miss);
        }
        CHECK(at_max(n, 0.05, r.lower) > miss || r.lower == n);
        if (r.upper > 0) {
            CHECK(1 - at_max(n, 0.05, r.upper - 1) <= miss);
            CHECK(r.upper == 1 || 1 - at_max(n, 0.05, r.upper - 2) > miss);
        }
        CHECK(r.lower <= r.value && (r.value <= r.upper || r.upper == 0));
    }
    /* .95^71 is more than 2.5 %, .95^72 less: no lower limit before 72. */
    CHECK(murk_quantile_ranks(71, 0.05, miss).lower == 0);
    CHECK(murk_quantile_ranks(72, 0.05, miss).lower == 1);
    CHECK(murk_quantile_ranks(1, 0.05, miss).upper == 0);
    const murk_order_statistics many = murk_quantile_ranks(1000000, 0.05, miss);
    const double sigma = sqrt(1e6 * 0.05 * 0.95);
    CHECK(many.value == 50000);
    CHECK_NEAR((double)many.lower, 50000 - 1.96 * sigma, 2);
    CHECK_NEAR((double)many.upper, 50000 + 1.96 * sigma, 2);
}

int main(void)
{
    test_student();
    test_ranks();
    return check_done();
}
