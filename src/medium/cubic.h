/* Cubic polynomials along a segment of a ray: the trilinear interpolation of
 * a cell, restricted to a line, is a cubic. s runs from 0 to 1 over the
 * segment; the value at s is c[0] + c[1] s + c[2] s^2 + c[3] s^3. Densities
 * are 0 or more on [0, 1], except for rounding. For use inside src/medium only.
 */
#ifndef MURK_MEDIUM_CUBIC_H
#define MURK_MEDIUM_CUBIC_H

typedef struct murk_cubic {
    double c[4];
} murk_cubic;

/* The cubic along the line from a to b, both in the unit cell, for the
 * values at the corners: corner[4 x + 2 y + z] at (x, y, z). */
murk_cubic murk_cubic_in_cell(const double corner[8], const double a[3],
                              const double b[3]);

/* sum += scale * cubic */
static inline void murk_cubic_add(murk_cubic *sum, double scale,
                                  const murk_cubic *cubic)
{
    for (int i = 0; i < 4; ++i) {
        sum->c[i] += scale * cubic->c[i];
    }
}

/* The value at s; never below 0. */
static inline double murk_cubic_value(const murk_cubic *cubic, double s)
{
    const double *c = cubic->c;
    const double value = ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
    return value > 0 ? value : 0;
}

/* The integral from 0 to s. */
static inline double murk_cubic_integral(const murk_cubic *cubic, double s)
{
    const double *c = cubic->c;
    return (((c[3] / 4 * s + c[2] / 3) * s + c[1] / 2) * s + c[0]) * s;
}

/* The s at which the integral from 0 reaches `share` of the integral over [0,
 * 1]. `share` itself, cut to 0..1, if `share` is not inside (0, 1) or the whole
 * integral is not above 0. Closed form for a linear function, otherwise
 * Newton's method with a bracket, in at most 64 steps. */
double murk_cubic_reach(const murk_cubic *cubic, double share);

#endif
