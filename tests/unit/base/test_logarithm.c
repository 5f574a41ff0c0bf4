/* murk_log() is within one unit in the last place of the logarithm in extended
 * precision: for all numbers that murk_random() can give near 0 and 1, for a
 * sample of those between, and for normal numbers of all magnitudes. */
#include "base/logarithm.h"

#include <float.h>
#include <math.h>

#include "base/philox.h"
#include "check.h"

/* The error of murk_log(x) in units in the last place of the true value. */
static double error_of(double x)
{
    const long double exact = logl((long double)x);
    const double rounded = fabs((double)exact);
    const double unit = nextafter(rounded, INFINITY) - rounded;
    return (double)(fabsl((long double)murk_log(x) - exact) / unit);
}

static void test_uniform_numbers(void)
{
    double worst = 0;
    for (uint32_t i = 0; i < 20000; ++i) {
        worst = fmax(worst, error_of(murk_uniform(i)));
        worst = fmax(worst, error_of(murk_uniform(UINT32_MAX - i)));
        worst = fmax(worst, error_of(murk_uniform(i * 214748u + 11)));
    }
    CHECK(worst < 1);
    CHECK(worst > 0.25); /* rounding alone costs up to one half */
}

static void test_all_magnitudes(void)
{
    double worst = 0;
    for (int k = DBL_MIN_EXP; k < DBL_MAX_EXP; ++k) {
        for (int i = 0; i < 64; ++i) {
            const double x = ldexp(0.5 + i / 128., k);
            worst = fmax(worst, error_of(x));
        }
    }
    CHECK(worst < 1);
    CHECK(worst > 0.25); /* rounding alone costs up to one half */
    CHECK(murk_log(1) == 0);
}

int main(void)
{
    test_uniform_numbers();
    test_all_magnitudes();
    return check_done();
}
