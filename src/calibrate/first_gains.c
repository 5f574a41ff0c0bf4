/* Linear least squares for one factor at a time: rows that use a factor are
 * proportional to it. */
#include "calibrate/first_gains.h"

#include <math.h>

/* The factor that fits the rows best; the slope of a row with respect to a
 * factor is the row with factor 1. */
static double best_gain(const murk_fit_search *s, size_t k)
{
    double with_measured = 0, with_itself = 0;
    for (size_t i = 0; i < s->n_fitted; ++i) {
        const size_t row = s->fitted[i];
        const double p = s->slope[row * s->n + k] / s->error[row];
        with_measured += p * (s->measured[row] / s->error[row]);
        with_itself += p * p;
    }
    return with_measured / with_itself;
}

murk_status murk_fit_first_gains(murk_fit_search *s, double *x, murk_error *err)
{
    const murk_free_keys *keys = s->desc->keys;
    bool has_gains = false;
    for (size_t k = 0; k < s->n; ++k) {
        has_gains = has_gains || keys->key[k].kind == MURK_FREE_GAIN;
    }
    if (!has_gains) {
        return MURK_OK;
    }
    murk_fit_search_values(s, x, s->value);
    const murk_status status = murk_model_predict(
        s->model, s->value, s->predicted, s->slope, &s->share, err);
    for (size_t k = 0; k < s->n && !status; ++k) {
        const murk_free_key *key = &keys->key[k];
        const double gain = key->kind == MURK_FREE_GAIN ? best_gain(s, k) : NAN;
        if (gain > 0 && isfinite(gain)) {
            x[k] = fmin(fmax(gain, key->lower), key->upper);
        }
    }
    return status;
}
