/* The second derivatives solve a system of three diagonals, from continuity of
 * the first at the nodes (de Boor, A Practical Guide to Splines, 1978, ch. 4).
 */
#include "cases/spline.h"

#include <assert.h>

spline spline_through(const double *x, const double *y, size_t n)
{
    assert(n >= 3 && n <= SPLINE_NODES_MAX);
    spline s = {.n = n};
    double upper[SPLINE_NODES_MAX];
    for (size_t i = 0; i < n; ++i) {
        s.x[i] = x[i];
        s.y[i] = y[i];
    }
    upper[0] = .5;
    s.second[0] = 3 * (y[1] - y[0]) / ((x[1] - x[0]) * (x[1] - x[0]));
    for (size_t i = 1; i + 1 < n; ++i) {
        const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
        const double bend =
            6 * ((y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before);
        const double pivot = 2 * (before + after) - before * upper[i - 1];
        upper[i] = after / pivot;
        s.second[i] = (bend - before * s.second[i - 1]) / pivot;
    }
    s.second[n - 1] = 0;
    for (size_t i = n - 1; i-- > 0;) {
        s.second[i] -= upper[i] * s.second[i + 1];
    }
    return s;
}

double spline_at(const spline *s, double x)
{
    size_t i = 0;
    while (i + 2 < s->n && x > s->x[i + 1]) {
        ++i;
    }
    const double h = s->x[i + 1] - s->x[i];
    const double a = (s->x[i + 1] - x) / h, b = 1 - a;
    return a * s->y[i] + b * s->y[i + 1] +
           ((a * a * a - a) * s->second[i] +
            (b * b * b - b) * s->second[i + 1]) *
               h * h / 6;
}
