/* ln Gamma against factorials and Gamma(1/2), and from many threads at once:
 * the thread sanitizer must find nothing. Nothing here is random. */
#include "base/log_gamma.h"
#include "base/pool.h"
#include "check.h"

#include <float.h>
#include <math.h>

#define PI   3.141592653589793
#define MANY 64

static void test_factorials(void)
{
    double factorial = 1;
    for (int n = 1; n <= 20; ++n) {
        const double want = log(factorial), got = murk_log_gamma(n);
        CHECK(fabs(got - want) <= 4 * DBL_EPSILON * fmax(1, want));
        factorial *= n;
    }
    CHECK(fabs(murk_log_gamma(.5) - log(PI) / 2) <= 4 * DBL_EPSILON);
}

static double at(uint64_t i)
{
    return .1 + .37 * (double)i;
}

static void fill(void *context, uint64_t i)
{
    double *value = context;
    value[i] = murk_log_gamma(at(i));
}

static void test_threads(void)
{
    double value[MANY];
    murk_pool_run(4, MANY, fill, value);
    for (uint64_t i = 0; i < MANY; ++i) {
        CHECK(value[i] == murk_log_gamma(at(i)));
    }
}

int main(void)
{
    test_factorials();
    test_threads();
    return check_done();
}
