/* Standard errors and confounded directions from the singular value
 * decomposition of the scaled Jacobian (fit/certainty.h). Singular values are
 * used instead of J^T J, which would lose half of the digits. */
#include "fit/certainty.h"

#include "fit/ceres_bridge.h"

#include <assert.h>
#include <float.h>
#include <math.h>

/* If the data do not depend on a direction, rounding may give a parameter that
 * is not part of the direction a component of this size. In such a direction
 * components up to this size are ignored. A true component is overlooked only
 * if one scale along the direction moves the parameter by less than this share
 * of its scale. */
#define SHARE_MIN 1.5e-8 /* sqrt(DBL_EPSILON), rounded up */

/* The largest error of a direction that enters a variance, in scales. A key
 * that is searched in logarithms never moves as far, because it changes by a
 * factor of 1e9 at most (MURK_FREE_REACH in calibrate/search_state.c; some 21
 * scales), nor does a key with two bounds, of which the distance is the scale.
 * An undetermined direction enters the variance of a parameter with a small
 * component by this error, not by an infinite one. */
#define SCALES_MAX 1e3

/* The columns of the Jacobian of the free parameters, in units of the scales,
 * and their singular values and directions (fit/ceres_bridge.h). */
typedef struct scaled {
    size_t n, rows;
    size_t *parameter; /* [n] */
    double *jacobian;  /* [rows][n] */
    double *singular;  /* [n] */
    double *direction; /* [n][n] */
    murk_arena arena;  /* of all arrays */
} scaled;

static murk_status check(const double *jacobian, size_t rows, size_t n,
                         const double *scale, double undetermined,
                         murk_error *err)
{
    if (!(undetermined > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, "fit",
                         "undetermined is %g, must be above 0", undetermined);
    }
    /* For each parameter: the scale, then the slopes of all rows. */
    for (size_t j = 0; j < n; ++j) {
        if (!(scale[j] > 0 && isfinite(scale[j]))) {
            return murk_fail(err, MURK_BAD_VALUE, "fit",
                             "the scale of parameter %zu is %g, must be above "
                             "0",
                             j, scale[j]);
        }
        for (size_t i = 0; i < rows; ++i) {
            const double slope = jacobian[i * n + j];
            if (!isfinite(slope * scale[j])) {
                return murk_fail(err, MURK_BAD_VALUE, "fit",
                                 "row %zu depends on parameter %zu by %g, must "
                                 "be finite",
                                 i + 1, j, slope);
            }
        }
    }
    return MURK_OK;
}

/* Release also after a failure. */
static murk_status scaled_create(scaled *s, const double *jacobian, size_t rows,
                                 size_t n, const bool *is_fixed,
                                 const double *scale, murk_error *err)
{
    /* Select the free parameters and scale their columns. */
    s->rows = rows;
    s->parameter = murk_arena_array(&s->arena, n, sizeof *s->parameter);
    s->jacobian = murk_arena_array(&s->arena, rows * n, sizeof(double));
    s->singular = murk_arena_array(&s->arena, n, sizeof(double));
    s->direction = murk_arena_array(&s->arena, n * n, sizeof(double));
    if (s->arena.is_short) {
        return murk_no_memory(err, "fit", "for the errors of %zu parameters",
                              n);
    }
    for (size_t j = 0; j < n; ++j) {
        if (!is_fixed || !is_fixed[j]) {
            s->parameter[s->n++] = j;
        }
    }
    for (size_t i = 0; i < rows; ++i) {
        for (size_t k = 0; k < s->n; ++k) {
            const size_t j = s->parameter[k];
            s->jacobian[i * s->n + k] = jacobian[i * n + j] * scale[j];
        }
    }
    if (!s->n) {
        return MURK_OK;
    }
    const murk_ceres *ceres = murk_ceres_load(err);
    return ceres ? ceres->singular(s->singular, s->direction, s->jacobian, rows,
                                   s->n, err)
                 : MURK_RUN_FAILED;
}

/* Singular values up to this one count as rounding errors. */
static double rounding(const scaled *s)
{
    const size_t size = s->rows > s->n ? s->rows : s->n;
    return s->n ? (double)size * DBL_EPSILON * s->singular[0] : 0;
}

static void read_directions(murk_certainty *out, const scaled *s,
                            double undetermined)
{
    const double nothing = rounding(s);
    out->directions = s->n;
    for (size_t d = 0; d < s->n; ++d) {
        out->direction_error[d] =
            s->singular[d] > nothing ? 1 / s->singular[d] : INFINITY;
        out->determined += out->direction_error[d] <= undetermined;
        for (size_t k = 0; k < s->n; ++k) {
            out->direction[d * out->n + s->parameter[k]] =
                s->direction[d * s->n + k];
        }
    }
}

/* The covariance of scaled parameters, with the error of each direction cut at
 * SCALES_MAX. A direction on which the data do not depend counts only if a
 * component exceeds SHARE_MIN. */
static double covariance_of(const murk_certainty *c, size_t i, size_t j)
{
    double sum = 0;
    for (size_t d = 0; d < c->directions; ++d) {
        const double a = c->direction[d * c->n + i];
        const double b = c->direction[d * c->n + j];
        const double error = fmin(c->direction_error[d], SCALES_MAX);
        const bool is_shared = fabs(a) > SHARE_MIN || fabs(b) > SHARE_MIN;
        if (isfinite(c->direction_error[d]) || is_shared) {
            sum += a * error * (b * error);
        }
    }
    return sum;
}

static void read_errors(murk_certainty *out, const bool *is_fixed,
                        const double *scale, double undetermined)
{
    const size_t n = out->n;
    for (size_t j = 0; j < n; ++j) {
        const bool is_free = !is_fixed || !is_fixed[j];
        const double error = sqrt(covariance_of(out, j, j));
        out->standard_error[j] =
            is_free && error <= undetermined ? error * scale[j] : NAN;
    }
    /* Covariance and correlation of the parameters that have an error; NaN for
     * the others. */
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            const double a = out->standard_error[i], b = out->standard_error[j];
            double covariance = NAN, correlation = NAN;
            if (isfinite(a) && isfinite(b)) {
                covariance = covariance_of(out, i, j) * scale[i] * scale[j];
                correlation = i == j ? 1 : covariance / (a * b);
            }
            out->covariance[i * n + j] = out->covariance[j * n + i] =
                covariance;
            out->correlation[i * n + j] = out->correlation[j * n + i] =
                correlation;
        }
    }
}

murk_status murk_certainty_create(murk_certainty *out, const double *jacobian,
                                  size_t rows, size_t n, const bool *is_fixed,
                                  const double *scale, double undetermined,
                                  murk_error *err)
{
    assert(out && jacobian && rows > 0 && n > 0 && scale);
    murk_certainty c = {.n = n};
    scaled s = {0};
    murk_status status = check(jacobian, rows, n, scale, undetermined, err);
    if (status ||
        (status = scaled_create(&s, jacobian, rows, n, is_fixed, scale, err))) {
        goto done;
    }
    /* Memory for the results, then directions and errors. */
    c.covariance = murk_arena_array(&c.arena, n * n, sizeof(double));
    c.correlation = murk_arena_array(&c.arena, n * n, sizeof(double));
    c.standard_error = murk_arena_array(&c.arena, n, sizeof(double));
    c.direction = murk_arena_array(&c.arena, n * n, sizeof(double));
    c.direction_error = murk_arena_array(&c.arena, n, sizeof(double));
    if (c.arena.is_short) {
        status =
            murk_no_memory(err, "fit", "for the errors of %zu parameters", n);
        goto done;
    }
    read_directions(&c, &s, undetermined);
    read_errors(&c, is_fixed, scale, undetermined);
    *out = c;
    c = (murk_certainty){0};
done:
    murk_certainty_release(&c);
    murk_arena_release(&s.arena);
    return status;
}

void murk_certainty_release(murk_certainty *certainty)
{
    murk_arena_release(&certainty->arena);
    *certainty = (murk_certainty){0};
}
