/* A search that must not be refused, and bounds that are none. */
#ifndef MURK_TESTS_UNBOUNDED_H
#define MURK_TESTS_UNBOUNDED_H

#include "check.h"
#include "fit/least_squares.h"

#include <math.h>

static const double none_below[4] = {-INFINITY, -INFINITY, -INFINITY,
                                     -INFINITY};
static const double none_above[4] = {INFINITY, INFINITY, INFINITY, INFINITY};

static inline murk_least_squares_found solve(double *x,
                                             const murk_least_squares *p)
{
    murk_least_squares_found found = {.end = MURK_LEAST_SQUARES_FAILED};
    murk_error err = {0};
    CHECK(murk_least_squares_solve(&found, x, p, &err) == MURK_OK);
    return found;
}

#endif
