/* Estimates the covariance of values and slopes from runs of photons, and
 * solves the corrected equations in the eigenvectors of J^T J and of the noise
 * relative to it. */
#include "calibrate/slope_noise.h"

#include "fit/ceres_bridge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Directions with a singular value of at most this share of the largest carry
 * no information. */
#define NOTHING 1e-12

/* No step is taken along a direction if more than this share of the apparent
 * information is noise. */
#define NOISE_MAX .5

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for slopes' noise");
}

void murk_slope_noise_release(murk_slope_noise *noise)
{
    murk_arena_release(&noise->arena);
    *noise = (murk_slope_noise){0};
}

/* Fills off[n_light][1 + n] with the whitened deviation of a run. */
static void off_of_run(double *off, const murk_fit_search *s,
                       const double *part, const double *total, size_t run)
{
    const size_t width = s->n + 1;
    const murk_model_facts *facts = murk_model_facts_of(s->model);
    const size_t runs = facts->runs, lights = facts->lights;
    for (size_t i = 0; i < s->n_light; ++i) {
        const size_t at = s->place[i] * width;
        for (size_t k = 0; k < width; ++k) {
            off[i * width + k] = part[run * lights * width + at + k] -
                                 total[at + k] / (double)runs;
        }
        /* Slopes with respect to logarithms. */
        for (size_t k = 0; k < s->n; ++k) {
            off[i * width + 1 + k] *=
                s->desc->keys->key[k].is_log ? s->value[k] : 1;
        }
    }
    murk_whitening_apply(s->whitening, off, width);
}

void murk_slope_noise_add(murk_slope_noise *out, const double *off,
                          const double *jacobian, size_t n_light, size_t n)
{
    const size_t width = n + 1;
    double square = 0;
    for (size_t i = 0; i < n_light; ++i) {
        square += off[i * width] * off[i * width];
    }
    out->share += square;
    for (size_t i = 0; i < n_light; ++i) {
        const double *row = off + i * width;
        for (size_t k = 0; k < n; ++k) {
            /* The slope of a residual is the negative slope of the row. */
            out->bias[k] += jacobian[i * n + k] * row[0] * square;
            out->bias[k] += row[0] * row[1 + k];
            for (size_t j = 0; j < n; ++j) {
                out->noise[k * n + j] += row[1 + k] * row[1 + j];
            }
        }
    }
}

/* Sums over all runs. part[runs][lights][1 + n] as murk_model_parts() gives it.
 */
static murk_status sum_runs(murk_slope_noise *out, const murk_fit_search *s,
                            const double *part, murk_error *err)
{
    const size_t n = s->n, width = n + 1;
    const murk_model_facts *facts = murk_model_facts_of(s->model);
    const size_t runs = facts->runs, lights = facts->lights;
    murk_arena arena = {0};
    double *total = murk_arena_array(&arena, lights * width, sizeof *total);
    double *off = murk_arena_array(&arena, s->n_light * width, sizeof *off);
    double *residual =
        murk_arena_array(&arena, s->n_fitted * width, sizeof *residual);
    if (arena.is_short) {
        murk_arena_release(&arena);
        return no_memory(err);
    }
    /* Jacobian of the residuals, and total of the runs. */
    double *jacobian = residual + s->n_fitted;
    murk_fit_search_residuals(s, residual, jacobian);
    for (size_t i = 0; i < runs * lights * width; ++i) {
        total[i % (lights * width)] += part[i];
    }
    /* Add each run, then scale. */
    for (size_t run = 0; run < runs; ++run) {
        off_of_run(off, s, part, total, run);
        murk_slope_noise_add(out, off, jacobian, s->n_light, n);
    }
    const double unbiased = (double)runs / ((double)runs - 1);
    out->share *= unbiased / (double)s->n_light;
    out->share = fmin(out->share, 1);
    for (size_t k = 0; k < n; ++k) {
        out->bias[k] *= unbiased;
    }
    for (size_t k = 0; k < n * n; ++k) {
        out->noise[k] *= unbiased;
    }
    murk_arena_release(&arena);
    return MURK_OK;
}

murk_status murk_slope_noise_find(murk_slope_noise *out,
                                  const murk_fit_search *s, murk_error *err)
{
    *out = (murk_slope_noise){0};
    out->bias = murk_arena_array(&out->arena, s->n, sizeof(double));
    out->noise = murk_arena_array(&out->arena, s->n * s->n, sizeof(double));
    if (out->arena.is_short) {
        return no_memory(err);
    }
    if (s->n_light == 0) {
        return MURK_OK;
    }
    double *part;
    murk_status status = murk_model_parts(s->model, &part, err);
    status = status ? status : sum_runs(out, s, part, err);
    free(part);
    return status;
}

/* Singular value decomposition J = U diag(s) V^T: singular[n], direction[n][n];
 * *rank is the number of directions with information. */
static murk_status split(double *singular, double *direction, size_t *rank,
                         const double *jacobian, size_t rows, size_t n,
                         murk_error *err)
{
    const murk_ceres *ceres = murk_ceres_load(err);
    const murk_status status =
        ceres ? ceres->singular(singular, direction, jacobian, rows, n, err)
              : MURK_RUN_FAILED;
    *rank = 0;
    while (!status && *rank < n && singular[*rank] > NOTHING * singular[0]) {
        ++*rank;
    }
    return status;
}

murk_status murk_slope_noise_offset(double *offset,
                                    const murk_slope_noise *noise,
                                    const double *jacobian, size_t rows,
                                    size_t n, murk_error *err)
{
    double *scratch = calloc(n * n + 2 * n + 1, sizeof *scratch);
    if (!scratch) {
        return no_memory(err);
    }
    double *singular = scratch, *step = scratch + n,
           *direction = scratch + 2 * n;
    size_t rank;
    /* step = -(J^T J)^-1 b, direction by direction. */
    const murk_status status =
        split(singular, direction, &rank, jacobian, rows, n, err);
    for (size_t r = 0; r < rank && !status; ++r) {
        const double *v = direction + r * n;
        double along = 0;
        for (size_t k = 0; k < n; ++k) {
            along += v[k] * noise->bias[k];
        }
        for (size_t k = 0; k < n; ++k) {
            step[k] -= v[k] * along / (singular[r] * singular[r]);
        }
    }
    /* offset = J step. */
    for (size_t i = 0; i < rows && !status; ++i) {
        offset[i] = 0;
        for (size_t k = 0; k < n; ++k) {
            offset[i] += jacobian[i * n + k] * step[k];
        }
    }
    free(scratch);
    return status;
}

/* The noise in units of the information: T^T N T with T = V diag(1 / s). */
static void in_own_scale(double *out, const double *noise,
                         const double *singular, const double *direction,
                         size_t rank, size_t n)
{
    for (size_t a = 0; a < rank; ++a) {
        for (size_t b = 0; b < rank; ++b) {
            double sum = 0;
            for (size_t k = 0; k < n * n; ++k) {
                sum += direction[a * n + k / n] * noise[k] *
                       direction[b * n + k % n];
            }
            out[a * rank + b] = sum / (singular[a] * singular[b]);
        }
    }
}

static bool are_finite(const double *a, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        if (!isfinite(a[i])) {
            return false;
        }
    }
    return true;
}

/* The decomposition that step and information need: J^T J = V diag(s^2) V^T,
 * and the noise in units of J^T J, Q diag(part) Q^T. */
typedef struct axes {
    size_t rank;
    double *singular, *direction; /* [rank], [rank][n] */
    double *part, *axis;          /* [rank], [rank][rank] */
    murk_arena arena;
} axes;

static murk_status find_axes(axes *out, const murk_slope_noise *noise,
                             const double *jacobian, size_t rows, size_t n,
                             murk_error *err)
{
    const size_t size = sizeof(double);
    murk_arena *arena = &out->arena;
    *out = (axes){0};
    out->singular = murk_arena_array(arena, n, size);
    out->part = murk_arena_array(arena, n, size);
    out->direction = murk_arena_array(arena, n * n, size);
    out->axis = murk_arena_array(arena, n * n, size);
    double *scaled = murk_arena_array(arena, n * n, size);
    if (arena->is_short) {
        return no_memory(err);
    }
    const murk_ceres *ceres = murk_ceres_load(err);
    if (!ceres) {
        return MURK_RUN_FAILED;
    }
    /* Information, then noise relative to it. */
    murk_status status = split(out->singular, out->direction, &out->rank,
                               jacobian, rows, n, err);
    if (!status && out->rank) {
        in_own_scale(scaled, noise->noise, out->singular, out->direction,
                     out->rank, n);
        status = are_finite(scaled, out->rank * out->rank)
                     ? ceres->singular(out->part, out->axis, scaled, out->rank,
                                       out->rank, err)
                     : murk_fail(err, MURK_RUN_FAILED, "fit",
                                 "the noise of slopes is not finite: start "
                                 "nearer to what was measured");
    }
    return status;
}

murk_status murk_slope_noise_step(double *step, double *length,
                                  const murk_slope_noise *noise,
                                  const double *residual,
                                  const double *jacobian, size_t rows, size_t n,
                                  murk_error *err)
{
    axes a;
    const murk_status status = find_axes(&a, noise, jacobian, rows, n, err);
    double *score =
        status ? NULL : murk_arena_array(&a.arena, n, sizeof *score);
    if (!score) {
        murk_arena_release(&a.arena);
        return status ? status : no_memory(err);
    }
    /* The score: b - J^T residual. */
    for (size_t k = 0; k < n; ++k) {
        score[k] = noise->bias[k];
        for (size_t i = 0; i < rows; ++i) {
            score[k] -= jacobian[i * n + k] * residual[i];
        }
        step[k] = 0;
    }
    *length = 0;
    /* Step along each direction that is not dominated by noise. */
    for (size_t q = 0; q < a.rank; ++q) {
        double along = 0;
        for (size_t r = 0; r < a.rank; ++r) {
            double of = 0;
            for (size_t k = 0; k < n; ++k) {
                of += a.direction[r * n + k] * score[k];
            }
            along += a.axis[q * a.rank + r] * of / a.singular[r];
        }
        const double signal_share = 1 - a.part[q];
        if (a.part[q] > NOISE_MAX) {
            continue;
        }
        *length += along * along / signal_share;
        for (size_t r = 0; r < a.rank; ++r) {
            for (size_t k = 0; k < n; ++k) {
                step[k] += a.axis[q * a.rank + r] / a.singular[r] *
                           a.direction[r * n + k] * along / signal_share;
            }
        }
    }
    *length = sqrt(*length);
    murk_arena_release(&a.arena);
    return MURK_OK;
}

murk_status murk_slope_noise_information(double *rows_out, double *max,
                                         const murk_slope_noise *noise,
                                         const double *jacobian, size_t rows,
                                         size_t n, murk_error *err)
{
    axes a;
    const murk_status status = find_axes(&a, noise, jacobian, rows, n, err);
    *max = !status && a.rank ? a.part[0] : 0;
    memset(rows_out, 0, n * n * sizeof *rows_out);
    /* The square root of the information that remains in each direction. */
    for (size_t q = 0; q < a.rank && !status; ++q) {
        const double left =
            fmax(0, 1 - a.part[q]) / sqrt(1 + noise->share * a.part[q]);
        for (size_t r = 0; r < a.rank; ++r) {
            for (size_t k = 0; k < n; ++k) {
                rows_out[q * n + k] += left * a.axis[q * a.rank + r] *
                                       a.singular[r] * a.direction[r * n + k];
            }
        }
    }
    murk_arena_release(&a.arena);
    return status;
}
