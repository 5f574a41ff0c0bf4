/* The verdict of a fit.
 *
 * The whitened residuals of a correct model with correct errors have unit
 * variance, so the sum of their squares follows chi-squared with as many
 * degrees of freedom as there are fitted rows minus free parameters. The upper
 * tail is the probability of a value at least as large. A parameter at a bound,
 * or along a direction that the data do not determine (fit/certainty.h), has no
 * standard error. */
#include "calibrate/verdict.h"

#include "base/stats.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* The verdict calls the scatter of the readings too large if p_value is below
 * this, and too small if 1 - p_value is: 5 % of correct fits together. */
#define REMARKABLE .025

bool murk_calibration_determines(const murk_calibration *c, size_t k)
{
    return !c->at_bound[k] && isfinite(c->standard_error[k]);
}

const char *murk_calibration_status(const murk_calibration *c, size_t k)
{
    return c->at_bound[k]                      ? "at its bound"
           : murk_calibration_determines(c, k) ? "determined"
                                               : "not determined by these data";
}

/* Appends to the verdict; cuts text that does not fit. */
__attribute__((format(printf, 2, 3))) static void say(murk_calibration *c,
                                                      const char *format, ...)
{
    const size_t length = strlen(c->verdict);
    va_list list;
    va_start(list, format);
    (void)vsnprintf(c->verdict + length, sizeof c->verdict - length, format,
                    list);
    va_end(list);
}

/* States which parameters the data do not determine: a single one by name, of
 * several the number. Then states the number of parameters at a bound. */
static void say_what_is_unknown(murk_calibration *c, const murk_free_keys *keys)
{
    size_t unknown = 0, first = 0, bound = 0;
    for (size_t k = 0; k < c->n; ++k) {
        const bool is_unknown =
            !c->at_bound[k] && !murk_calibration_determines(c, k);
        first = is_unknown && unknown == 0 ? k : first;
        unknown += is_unknown;
        bound += c->at_bound[k];
    }
    if (unknown == 1) {
        say(c, " The data do not determine %.80s.", keys->key[first].name);
    } else if (unknown > 1) {
        say(c, " The data do not determine %zu of the %zu values.", unknown,
            c->n);
    }
    if (bound > 0) {
        say(c, " %zu of the %zu values ended at a bound.", bound, c->n);
    }
}

void murk_calibration_judge(murk_calibration *c, const murk_free_keys *keys)
{
    const double n = (double)c->degrees_of_freedom;
    c->p_value = murk_chi2_upper(c->chi2, n);
    c->is_accepted = !(c->p_value < MURK_FIT_REFUSED);
    c->verdict[0] = '\0';
    /* The model, by chi-squared. */
    if (isnan(c->p_value)) {
        say(c, "There are no more readings than values, so nothing can tell "
               "whether the model fits.");
    } else if (!c->is_accepted) {
        say(c,
            MURK_VERDICT_REFUSED
            "the data refuse this model, chi2 is %.4g where %.0f +- %.0f "
            "is due (chance %.1g). The values and their errors are not to be "
            "used.",
            c->chi2, n, sqrt(2 * n), c->p_value);
    } else {
        say(c, "%s (chi2 %.4g where %.0f +- %.0f is due, chance %.2g).",
            c->p_value < REMARKABLE
                ? "Not well: the readings scatter about the model somewhat "
                  "more than their errors say"
            : c->p_value > 1 - REMARKABLE
                ? "Yes, better than it should: the readings' errors are "
                  "probably stated too large"
                : "Yes: the readings scatter about the model as their errors "
                  "say",
            c->chi2, n, sqrt(2 * n), c->p_value);
    }
    /* The search, and single parameters. */
    if (!c->converged) {
        say(c, " The search did not converge.");
    }
    say_what_is_unknown(c, keys);
}
