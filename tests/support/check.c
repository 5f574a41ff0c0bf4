/* The counters behind the check macros, the exit codes of a test program, and
 * the distance of a value from its expectation in standard errors. */
#include "check.h"

#include <stdlib.h>

int check_failures;
int check_count;

int check_done(void)
{
    if (check_count == 0) {
        printf("nothing was checked\n");
        return 1;
    }
    return check_failures != 0;
}

void check_skip(const char *why)
{
    printf("skipped: %s\n", why);
    exit(77);
}

double sigmas_off(double got, double want, double sigma)
{
    const double off = fabs(got - want) / sigma;
    return sigma > 0 && !isnan(off) ? off : INFINITY;
}
