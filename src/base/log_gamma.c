/* Calls lgamma_r() of POSIX, the thread-safe form of lgamma(), and drops the
 * sign, which is positive for x > 0. */
#include "base/log_gamma.h"

#include <assert.h>
#include <math.h>

double murk_log_gamma(double x)
{
    assert(x > 0);
    int sign;
    return lgamma_r(x, &sign);
}
