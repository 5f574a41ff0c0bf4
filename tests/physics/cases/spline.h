/* A cubic spline through a table of reference values: level at its first node,
 * with no second derivative at its last. */
#ifndef MURK_TESTS_CASES_SPLINE_H
#define MURK_TESTS_CASES_SPLINE_H

#include <stddef.h>

#define SPLINE_NODES_MAX 64

typedef struct spline {
    size_t n;
    double x[SPLINE_NODES_MAX], y[SPLINE_NODES_MAX];
    double second[SPLINE_NODES_MAX]; /* derivatives */
} spline;

/* n >= 3 nodes, x ascending. */
spline spline_through(const double *x, const double *y, size_t n);

/* Goes on beyond the last node as its last piece does. */
double spline_at(const spline *s, double x);

#endif
