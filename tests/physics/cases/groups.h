/* The groups of reference cases: each a file NAME.c here, whose head says what
 * it holds, with a function cases_NAME. Results list them in this order. */
#ifndef MURK_TESTS_CASES_GROUPS_H
#define MURK_TESTS_CASES_GROUPS_H

#include "validation.h"

#define VALIDATION_GROUPS(X) \
    X(slabs)                 \
    X(published)             \
    X(depth)                 \
    X(disort)                \
    X(points)                \
    X(sea)                   \
    X(cloud)                 \
    X(cube)                  \
    X(grids)                 \
    X(enclosures)            \
    X(coverage)              \
    X(pixels)

#define X(name) void cases_##name(validation *v);
VALIDATION_GROUPS(X)
#undef X

#endif
