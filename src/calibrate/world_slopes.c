/* Difference quotients over two steps, with their variance over batches of
 * photons, and Richardson's estimate of the bias (the error of a central
 * difference is proportional to the square of the step). */
#include "calibrate/world_slopes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The wide step: a share of the value of a positive key, of the width of the
 * bounds, or of the value of an unbounded key, which is then at least STEP_MIN
 * (a length in metres, for example). */
#define STEP_SHARE .1
#define STEP_MIN   .1

/* Slopes over one step with their variance. */
typedef struct difference {
    double *slope, *variance; /* [lit] */
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

/* Traces light at the values and evaluates the lit rows. */
static murk_status rows_at(murk_lit_rows *out, const murk_lit_desc *desc,
                           const murk_measurements *measured,
                           const double *value, murk_error *err)
{
    murk_lit lit;
    murk_status status = murk_lit_create(&lit, desc, value, err);
    if (!status) {
        status = murk_lit_read(out, &lit, measured, lit.optics, NULL, 0, err);
    }
    murk_lit_release(&lit);
    return status;
}

/* Difference quotients and their variance over batches; both lights use the
 * same random numbers. */
static void differ(difference *out, const murk_lit_desc *desc,
                   const murk_lit_rows *low, const murk_lit_rows *high,
                   double span)
{
    const size_t lit = desc->instruments->lit;
    const double batches = (double)desc->batches;
    for (size_t i = 0; i < lit; ++i) {
        out->slope[i] = (high->value[i] - low->value[i]) / span;
        double squares = 0;
        for (size_t b = 0; b < desc->batches; ++b) {
            const double d =
                (high->batch[b * lit + i] - low->batch[b * lit + i]) / span -
                out->slope[i] / batches;
            squares += d * d;
        }
        out->variance[i] = batches / (batches - 1) * squares;
    }
}

/* The difference quotients over one step. */
static murk_status difference_over(difference *out, const murk_lit_desc *desc,
                                   const murk_measurements *measured,
                                   size_t key, const double *value,
                                   double share, murk_error *err)
{
    const size_t n = desc->keys->n;
    murk_lit_rows side[2] = {{0}, {0}};
    double *moved = malloc(n * sizeof *moved), end[2];
    murk_status status =
        moved ? MURK_OK
              : murk_fail(err, MURK_NO_MEMORY, "", "no memory for slopes");
    murk_world_span(&desc->keys->key[key], value[key], share, &end[0], &end[1]);
    /* Evaluate at both values. */
    for (int i = 0; i < 2 && !status; ++i) {
        memcpy(moved, value, n * sizeof *moved);
        moved[key] = end[i];
        status = murk_lit_rows_create(&side[i], desc, 0, err);
        if (!status) {
            status = rows_at(&side[i], desc, measured, moved, err);
        }
    }
    if (!status) {
        differ(out, desc, &side[0], &side[1], end[1] - end[0]);
    }
    murk_lit_rows_release(&side[0]);
    murk_lit_rows_release(&side[1]);
    free(moved);
    return status;
}

murk_status murk_world_slopes(double *slope, double *slope_error,
                              const murk_lit_desc *desc,
                              const murk_measurements *measured, size_t key,
                              const double *value, murk_error *err)
{
    const size_t lit = desc->instruments->lit;
    double *room = calloc(4 * lit + 1, sizeof *room);
    if (!room) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for slopes");
    }
    difference wide = {room, room + lit},
               narrow = {room + 2 * lit, room + 3 * lit};
    murk_status status =
        difference_over(&wide, desc, measured, key, value, 1, err);
    if (!status) {
        status = difference_over(&narrow, desc, measured, key, value, .5, err);
    }
    for (size_t i = 0; i < lit && !status; ++i) {
        /* The bias is proportional to the square of the step, so the difference
         * is 3/4 of the bias of the wide step. */
        const double apart = wide.slope[i] - narrow.slope[i];
        const double seen =
            fmax(0, apart * apart - wide.variance[i] - narrow.variance[i]);
        const double bias = seen * 16 / 9;
        const double of_wide = wide.variance[i] + bias,
                     of_narrow = narrow.variance[i] + bias / 16;
        const bool takes_wide = of_wide < of_narrow;
        slope[i] = takes_wide ? wide.slope[i] : narrow.slope[i];
        slope_error[i] = sqrt(takes_wide ? of_wide : of_narrow);
    }
    free(room);
    return status;
}
