/* Difference quotients over two steps, with their variance over batches of
 * photons, and Richardson's estimate of the bias (the error of a central
 * difference is proportional to the square of the step). */
#include "calibrate/world_slopes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The wide step is STEP_SHARE of the value of a key that is searched in
 * logarithms, of the width of the bounds of another key, or of the absolute
 * value of a key without bounds. In the last case the step is at least
 * STEP_MIN, in the unit of the key. */
#define STEP_SHARE .1
#define STEP_MIN   .1

/* Slopes over one step with their variance. */
typedef struct difference {
    double *slope, *variance; /* [light rows] */
} difference;

void murk_world_span(const murk_free_key *key, double value, double share,
                     double *low, double *high)
{
    const bool is_bounded = isfinite(key->lower) && isfinite(key->upper);
    const double step =
        share * (key->is_log  ? STEP_SHARE * value
                 : is_bounded ? STEP_SHARE * (key->upper - key->lower)
                              : fmax(STEP_SHARE * fabs(value), STEP_MIN));
    *low = fmax(value - step, key->lower);
    *high = fmin(value + step, key->upper);
}

/* Traces light at the values and evaluates the light rows. */
static murk_status rows_at(murk_lighting_rows *out,
                           const murk_lighting_desc *desc,
                           const murk_readings *measured, const double *value,
                           murk_error *err)
{
    murk_lighting lighting = {0};
    murk_status status = murk_lighting_rows_create(out, desc, 0, err);
    status = status ? status : murk_lighting_build(&lighting, desc, value, err);
    status = status ? status : murk_lighting_trace(&lighting, 0, err);
    status = status ? status
                    : murk_lighting_read(out, &lighting, measured,
                                         lighting.optics, NULL, 0, err);
    murk_lighting_release(&lighting);
    return status;
}

/* Difference quotients and their variance over batches; both lights use the
 * same random numbers. */
static void differ(difference *out, const murk_lighting_desc *desc,
                   const murk_lighting_rows *low,
                   const murk_lighting_rows *high, double span)
{
    const size_t lights = desc->instruments->lights;
    const double batches = (double)desc->batches;
    for (size_t i = 0; i < lights; ++i) {
        out->slope[i] = (high->value[i] - low->value[i]) / span;
        double squares = 0;
        for (size_t b = 0; b < desc->batches; ++b) {
            const double d =
                (high->batch[b * lights + i] - low->batch[b * lights + i]) /
                    span -
                out->slope[i] / batches;
            squares += d * d;
        }
        out->variance[i] = batches / (batches - 1) * squares;
    }
}

/* The difference quotients for a step of this share of the wide one. */
static murk_status differ_by_step(difference *out,
                                  const murk_lighting_desc *desc,
                                  const murk_readings *measured, size_t key,
                                  const double *value, double share,
                                  murk_error *err)
{
    const size_t n = desc->keys->n;
    murk_lighting_rows side[2] = {{0}, {0}};
    double *moved = malloc(n * sizeof *moved), end[2];
    murk_status status =
        moved ? MURK_OK : murk_no_memory(err, "", "for slopes");
    murk_world_span(&desc->keys->key[key], value[key], share, &end[0], &end[1]);
    /* Evaluate at both values. */
    for (int i = 0; i < 2 && !status; ++i) {
        memcpy(moved, value, n * sizeof *moved);
        moved[key] = end[i];
        status = rows_at(&side[i], desc, measured, moved, err);
    }
    if (!status) {
        differ(out, desc, &side[0], &side[1], end[1] - end[0]);
    }
    murk_lighting_rows_release(&side[0]);
    murk_lighting_rows_release(&side[1]);
    free(moved);
    return status;
}

murk_status murk_world_slopes(double *slope, double *slope_error,
                              const murk_lighting_desc *desc,
                              const murk_readings *measured, size_t key,
                              const double *value, murk_error *err)
{
    const size_t lights = desc->instruments->lights;
    double *scratch = calloc(4 * lights + 1, sizeof *scratch);
    if (!scratch) {
        return murk_no_memory(err, "", "for slopes");
    }
    difference wide = {scratch, scratch + lights},
               narrow = {scratch + 2 * lights, scratch + 3 * lights};
    murk_status status =
        differ_by_step(&wide, desc, measured, key, value, 1, err);
    status = status
                 ? status
                 : differ_by_step(&narrow, desc, measured, key, value, .5, err);
    for (size_t i = 0; i < lights && !status; ++i) {
        /* The bias is proportional to the square of the step, so the difference
         * is 3/4 of the bias of the wide step. */
        const double deviation = wide.slope[i] - narrow.slope[i];
        const double excess = fmax(0, deviation * deviation - wide.variance[i] -
                                          narrow.variance[i]);
        const double bias = excess * 16 / 9;
        const double of_wide = wide.variance[i] + bias,
                     of_narrow = narrow.variance[i] + bias / 16;
        const bool takes_wide = of_wide < of_narrow;
        slope[i] = takes_wide ? wide.slope[i] : narrow.slope[i];
        slope_error[i] = sqrt(takes_wide ? of_wide : of_narrow);
    }
    free(scratch);
    return status;
}
