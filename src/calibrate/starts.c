/* Chooses start values, runs the searches and compares their ends. */
#include "calibrate/starts.h"

#include "base/rng.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Further starts lie within this factor of the values of the scene, or within
 * this share of the width of the bounds. */
#define START_FACTOR 4.0
#define START_SHARE  .9

/* Start value i of a key: the value of the scene first, random ones around it
 * later. */
static double start_of(const murk_free_key *key, uint32_t seed, size_t i,
                       size_t k)
{
    if (i == 0) {
        return key->start;
    }
    const double u =
        2 * murk_random(seed, MURK_FIT_START, i, (uint32_t)k, 0).u[0] - 1;
    double v;
    if (key->is_log) {
        v = key->start * pow(START_FACTOR, u);
    } else if (isfinite(key->lower) && isfinite(key->upper)) {
        v = .5 * (key->lower + key->upper +
                  START_SHARE * u * (key->upper - key->lower));
    } else {
        v = key->start + u * fmax(fabs(key->start), 1);
    }
    return fmin(fmax(v, key->lower), key->upper);
}

/* Costs that differ by less belong to the same minimum: light and the end of a
 * search are not known more precisely. It is a tenth of the change of cost at
 * one standard error. */
#define SAME_MINIMUM .1

/* True if start a is better than b. A start that converged wins unless the
 * other is lower by more than the errors of n parameters explain; within one
 * minimum the earlier start is kept. */
static bool is_better(const murk_calibration_start *a,
                      const murk_calibration_start *b, size_t n)
{
    if (isnan(b->chi2) || a->converged == b->converged) {
        return isnan(b->chi2) || a->cost < b->cost - SAME_MINIMUM;
    }
    const double lead = (double)n;
    return a->cost < b->cost + (a->converged ? lead : -lead);
}

/* Adds advice to a message: not every value of an unbounded world key gives a
 * valid scene. */
static void advise_bounds(murk_error *told, const murk_free_keys *keys,
                          murk_status status)
{
    const size_t length = strlen(told->text);
    for (size_t k = 0; status == MURK_BAD_VALUE && k < keys->n; ++k) {
        const murk_free_key *key = &keys->key[k];
        if (key->kind == MURK_FREE_WORLD &&
            !(isfinite(key->lower) && isfinite(key->upper))) {
            snprintf(told->text + length, sizeof told->text - length,
                     "; --bounds %.80s=LOW:HIGH keeps the search inside",
                     key->name);
            return;
        }
    }
}

murk_status murk_fit_start(murk_calibration *out, murk_fit_search *s, size_t i,
                           double *x, murk_error *err)
{
    const murk_calibration_desc *desc = s->desc;
    murk_calibration_start *start = &out->start[i];
    /* Start values and the cost to beat. */
    for (size_t k = 0; k < out->n; ++k) {
        start->from[k] = start_of(&desc->keys->key[k], desc->seed, i, k);
    }
    s->start = i;
    s->cost_to_beat = i > 0 ? out->start[out->best].cost : INFINITY;
    murk_fit_search_coordinates(s, start->from, x);
    /* Search; only the first start may fail the fit. */
    murk_error told = {0};
    const murk_status status = murk_fit_search_run(s, x, start, &told);
    if (status) {
        advise_bounds(&told, desc->keys, status);
        snprintf(start->why, sizeof start->why, "%.250s", told.text);
        start->chi2 = NAN;
        if (i == 0 || status == MURK_INTERRUPTED || status == MURK_NO_MEMORY) {
            return murk_fail(err, status, told.where, "%s", told.text);
        }
        return MURK_OK;
    }
    if (s->is_dropped) { /* chi2 stays NaN: nothing was found */
        return MURK_OK;
    }
    /* Compare with the best. */
    murk_fit_search_values(s, x, start->to);
    if (i == 0 || is_better(start, &out->start[out->best], out->n)) {
        out->best = i;
    }
    return MURK_OK;
}
