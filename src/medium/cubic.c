/* Cubics along a ray: coefficients from the corners of a cell, and inversion
 * of the integral. */
#include "medium/cubic.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/* A bisection halves the bracket, so 64 bisections make the bracket narrower
 * than the rounding of 1. Newton's method needs far fewer steps. */
#define STEPS_MAX 64

murk_cubic murk_cubic_in_cell(const double corner[8], const double a[3],
                              const double b[3])
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2];
    double c0[2], c1[2],
        c2[2]; /* quadratics on the two faces z = 0 and z = 1 */
    for (int z = 0; z < 2; ++z) {
        const double low = corner[z], high = corner[2 + z];
        const double low_x = corner[4 + z] - low, high_x = corner[6 + z] - high;
        const double u0 = low + low_x * a[0], u1 = low_x * dx;
        const double v0 = high + high_x * a[0] - u0, v1 = high_x * dx - u1;
        c0[z] = u0 + v0 * a[1];
        c1[z] = u1 + v1 * a[1] + v0 * dy;
        c2[z] = v1 * dy;
    }
    const double d0 = c0[1] - c0[0], d1 = c1[1] - c1[0], d2 = c2[1] - c2[0];
    return (murk_cubic){{c0[0] + d0 * a[2], c1[0] + d1 * a[2] + d0 * dz,
                         c2[0] + d2 * a[2] + d1 * dz, d2 * dz}};
}

/* The s, at most 1, at which the integral of c0 + c1 s from 0 reaches `target`.
 * The form of the root contains no difference of nearly equal numbers. */
static double reach_of_line(double c0, double c1, double target)
{
    const double end = sqrt(fmax(0, c0 * c0 + 2 * c1 * target));
    return fmin(1, 2 * target / (c0 + end));
}

double murk_cubic_reach(const murk_cubic *cubic, double share)
{
    const double *c = cubic->c;
    const double whole = murk_cubic_integral(cubic, 1);
    if (!(whole > 0) || !(share > 0 && share < 1)) {
        return share > 0 ? fmin(1, share) : 0;
    }
    const double target = share * whole;
    if (c[2] == 0 && c[3] == 0) {
        return reach_of_line(c[0], c[1], target);
    }
    /* Newton's method; a step that leaves the bracket is replaced by a
     * bisection. */
    double low = 0, high = 1, s = share;
    for (int i = 0; i < STEPS_MAX; ++i) {
        const double off = murk_cubic_integral(cubic, s) - target;
        low = off > 0 ? low : s;
        high = off > 0 ? s : high;
        double next = s - off / murk_cubic_value(cubic, s);
        if (!(next > low && next < high)) { /* also if the step is NaN (0/0) */
            next = low + (high - low) / 2;
        }
        const bool is_settled = fabs(next - s) <= DBL_EPSILON * s;
        s = next;
        if (is_settled) {
            break;
        }
    }
    return s;
}
