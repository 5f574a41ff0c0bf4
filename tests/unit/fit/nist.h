/* Nonlinear regression with certified answers: NIST Statistical Reference
 * Datasets (StRD), Nonlinear Regression, doi:10.18434/T43G6C: Misra1a (Misra,
 * NIST, 1978), Thurber (Thurber, NIST, 197?), MGH09 (Kowalik and Osborne,
 * Methods for Unconstrained Optimization Problems, 1978). Read at second hand,
 * in copies of the data sets' own files. */
#ifndef MURK_TESTS_NIST_H
#define MURK_TESTS_NIST_H

#include "base/status.h"
#include "fit/least_squares.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define NIST_N_MAX 7

typedef struct nist_problem {
    const char *name;
    size_t n, rows;
    const double (*xy)[2]; /* [rows] predictor, response */
    double start[2][NIST_N_MAX];
    double value[NIST_N_MAX], error[NIST_N_MAX]; /* certified */
    double sum_of_squares, residual_deviation;   /* certified */
    /* The model at b[n] and its slopes. */
    double (*model)(const double *b, double x, double *slope);
} nist_problem;

static double nist_misra1a(const double *b, double x, double *slope)
{
    const double e = exp(-b[1] * x);
    slope[0] = 1 - e;
    slope[1] = b[0] * x * e;
    return b[0] * (1 - e);
}

static double nist_thurber(const double *b, double x, double *slope)
{
    const double above = b[0] + x * (b[1] + x * (b[2] + x * b[3]));
    const double below = 1 + x * (b[4] + x * (b[5] + x * b[6]));
    double power = 1;
    for (int k = 0; k < 4; ++k, power *= x) {
        slope[k] = power / below;
    }
    power = x;
    for (int k = 4; k < 7; ++k, power *= x) {
        slope[k] = -power * above / (below * below);
    }
    return above / below;
}

static double nist_mgh09(const double *b, double x, double *slope)
{
    const double above = x * x + x * b[1], below = x * x + x * b[2] + b[3];
    slope[0] = above / below;
    slope[1] = b[0] * x / below;
    slope[2] = -b[0] * above * x / (below * below);
    slope[3] = -b[0] * above / (below * below);
    return b[0] * above / below;
}

static const double nist_misra1a_xy[][2] = {
    {77.6, 10.07},  {114.9, 14.73}, {141.1, 17.94}, {190.8, 23.93},
    {239.9, 29.61}, {289.0, 35.18}, {332.8, 40.02}, {378.4, 44.82},
    {434.8, 50.76}, {477.3, 55.05}, {536.8, 61.01}, {593.1, 66.40},
    {689.1, 75.47}, {760.0, 81.78},
};

static const double nist_thurber_xy[][2] = {
    {-3.067, 80.574},   {-2.981, 84.248},   {-2.921, 87.264},
    {-2.912, 87.195},   {-2.840, 89.076},   {-2.797, 89.608},
    {-2.702, 89.868},   {-2.699, 90.101},   {-2.633, 92.405},
    {-2.481, 95.854},   {-2.363, 100.696},  {-2.322, 101.060},
    {-1.501, 401.672},  {-1.460, 390.724},  {-1.274, 567.534},
    {-1.212, 635.316},  {-1.100, 733.054},  {-1.046, 759.087},
    {-0.915, 894.206},  {-0.714, 990.785},  {-0.566, 1090.109},
    {-0.545, 1080.914}, {-0.400, 1122.643}, {-0.309, 1178.351},
    {-0.109, 1260.531}, {-0.103, 1273.514}, {0.010, 1288.339},
    {0.119, 1327.543},  {0.377, 1353.863},  {0.790, 1414.509},
    {0.963, 1425.208},  {1.006, 1421.384},  {1.115, 1442.962},
    {1.572, 1464.350},  {1.841, 1468.705},  {2.047, 1447.894},
    {2.200, 1457.628},
};

static const double nist_mgh09_xy[][2] = {
    {4.0, 0.1957},    {2.0, 0.1947},    {1.0, 0.1735},    {0.5, 0.16},
    {0.25, 0.0844},   {0.167, 0.0627},  {0.125, 0.0456},  {0.1, 0.0342},
    {0.0833, 0.0323}, {0.0714, 0.0235}, {0.0625, 0.0246},
};

static const nist_problem nist_problems[] = {
    {"Misra1a",
     2,
     14,
     nist_misra1a_xy,
     {{500, 1e-4}, {250, 5e-4}},
     {2.3894212918e+02, 5.5015643181e-04},
     {2.7070075241e+00, 7.2668688436e-06},
     1.2455138894e-01,
     1.0187876330e-01,
     nist_misra1a},
    {"Thurber",
     7,
     37,
     nist_thurber_xy,
     {{1000, 1000, 400, 40, 0.7, 0.3, 0.03},
      {1300, 1500, 500, 75, 1, 0.4, 0.05}},
     {1.2881396800e+03, 1.4910792535e+03, 5.8323836877e+02, 7.5416644291e+01,
      9.6629502864e-01, 3.9797285797e-01, 4.9727297349e-02},
     {4.6647963344e+00, 3.9571156086e+01, 2.8698696102e+01, 5.5675370270e+00,
      3.1333340687e-02, 1.4984928198e-02, 6.5842344623e-03},
     5.6427082397e+03,
     1.3714600784e+01,
     nist_thurber},
    {"MGH09",
     4,
     11,
     nist_mgh09_xy,
     {{25, 39, 41.5, 39}, {0.25, 0.39, 0.415, 0.39}},
     {1.9280693458e-01, 1.9128232873e-01, 1.2305650693e-01, 1.3606233068e-01},
     {1.1435312227e-02, 1.9633220911e-01, 8.0842031232e-02, 9.0025542308e-02},
     3.0750560385e-04,
     6.6279236551e-03,
     nist_mgh09},
};

#define NIST_PROBLEMS (sizeof nist_problems / sizeof *nist_problems)

/* As murk_residuals; the context is the problem. */
static inline bool nist_residuals(void *context, const double *b,
                                  double *residual, double *jacobian)
{
    const nist_problem *p = context;
    for (size_t i = 0; i < p->rows; ++i) {
        double slope[NIST_N_MAX];
        residual[i] = p->model(b, p->xy[i][0], slope) - p->xy[i][1];
        for (size_t j = 0; jacobian && j < p->n; ++j) {
            jacobian[i * p->n + j] = slope[j];
        }
    }
    return true;
}

static const double nist_lower[NIST_N_MAX] = {-INFINITY, -INFINITY, -INFINITY,
                                              -INFINITY, -INFINITY, -INFINITY,
                                              -INFINITY};
static const double nist_upper[NIST_N_MAX] = {
    INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};

/* A plain least-squares problem, to the last digits. */
static inline murk_least_squares nist_least_squares(const nist_problem *p)
{
    return (murk_least_squares){.n = p->n,
                                .rows = p->rows,
                                .lower = nist_lower,
                                .upper = nist_upper,
                                .residuals = nist_residuals,
                                .context = (void *)p,
                                .iterations_max = 1000,
                                .tolerance = 1e-14};
}

#endif
