/* The reference solution of a point source in an infinite medium: rows of the
 * table, a natural cubic spline of log f through them, means of the spline
 * over spherical shells, and for isotropic scattering the exact integral over
 * the spectrum. */
#include "cases/point_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/vector.h"
#include "cases/reference.h"

/* Steps of the two integrals: the spline's over a shell, and over the
 * continuous spectrum in x, nu = tanh x, by the trapezoid rule: good to 1e-8
 * from r = .1 on. */
#define BOUNDARY_STEPS 256
#define SPECTRUM_STEPS 16384
#define SPECTRUM_END   20.0

/* The natural cubic spline (de Boor, A Practical Guide to Splines, 1978, ch.
 * 4): its tridiagonal system, solved downwards and up again. */
static void bend(point_table *t)
{
    double across[POINT_RADII_MAX] = {0};
    const double *r = t->r, *y = t->log_f;
    for (size_t i = 1; i + 1 < t->n; ++i) {
        const double before = r[i] - r[i - 1], after = r[i + 1] - r[i];
        const double slopes =
            (y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before;
        const double pivot = 2 * (before + after) - before * across[i - 1];
        across[i] = after / pivot;
        t->curvature[i] = (6 * slopes - before * t->curvature[i - 1]) / pivot;
    }
    for (size_t i = t->n - 1; i-- > 1;) {
        t->curvature[i] -= across[i] * t->curvature[i + 1];
    }
}

point_table point_table_read(double albedo, double g)
{
    point_table t = {.albedo = albedo, .g = g, .n = 1};
    murk_table *file = reference_read("point_source.csv");
    for (size_t row = 0; row < file->rows; ++row) {
        if (reference_number(file, row, "albedo") == albedo &&
            reference_number(file, row, "g") == g && t.n < POINT_RADII_MAX) {
            const double r = reference_number(file, row, "r");
            t.r[t.n] = r;
            t.log_f[t.n] = log(4 * MURK_PI * r * r *
                               reference_number(file, row, "fluence"));
            ++t.n;
        }
    }
    murk_table_destroy(file);
    if (t.n < 3) {
        fprintf(stderr, "no point source of albedo %g, g %g\n", albedo, g);
        exit(1);
    }
    bend(&t);
    return t;
}

double point_table_at(const point_table *t, size_t i)
{
    return exp(t->log_f[i]);
}

static double spline_at(const point_table *t, double r)
{
    size_t i = 1;
    while (i + 1 < t->n && t->r[i] < r) {
        ++i;
    }
    const double h = t->r[i] - t->r[i - 1];
    const double a = (t->r[i] - r) / h, b = 1 - a;
    return a * t->log_f[i - 1] + b * t->log_f[i] +
           h * h / 6 *
               ((a * a * a - a) * t->curvature[i - 1] +
                (b * b * b - b) * t->curvature[i]);
}

double point_table_fluence(const point_table *t, double r0, double r1)
{
    double sum = 0;
    for (int i = 0; i < BOUNDARY_STEPS; ++i) {
        sum += exp(spline_at(t, r0 + (r1 - r0) * (i + .5) / BOUNDARY_STEPS));
    }
    return sum / BOUNDARY_STEPS;
}

double point_table_error(double stretch)
{
    return 9.2e-4 * log(stretch);
}

/* The root of albedo * artanh(k) = k in (0, 1). */
static double discrete_root(double albedo)
{
    double low = 1e-9, high = 1 - 1e-16;
    for (int i = 0; i < 200; ++i) {
        const double k = .5 * (low + high);
        *(albedo * atanh(k) > k ? &high : &low) = k;
    }
    return low;
}

/* The integral of r exp(-a r). */
static double first_moment(double a, double r0, double r1)
{
    return (r0 / a + 1 / (a * a)) * exp(-a * r0) -
           (r1 / a + 1 / (a * a)) * exp(-a * r1);
}

double point_exact_fluence(double c, double r0, double r1)
{
    const double k = discrete_root(c), artanh_k = atanh(k);
    const double dc_dk = 1 / artanh_k - k / ((1 - k * k) * artanh_k * artanh_k);
    double sum = -2 * k / dc_dk * first_moment(k, r0, r1);
    const double h = SPECTRUM_END / SPECTRUM_STEPS;
    for (int i = 1; i <= SPECTRUM_STEPS; ++i) {
        const double x = i * h, nu = tanh(x);
        const double re = 1 - c * x * nu, im = MURK_PI / 2 * c * nu;
        const double weight = 1 / (re * re + im * im) / (nu * nu);
        sum += h * weight / (cosh(x) * cosh(x)) * first_moment(1 / nu, r0, r1);
    }
    return sum / (r1 - r0);
}
