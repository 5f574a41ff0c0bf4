#include "report/chart_axis.h"

#include "report/html.h"

#include <math.h>

/* Ticks aimed at. */
#define TICKS 6

/* What is less is nothing: steps of it would leave the doubles. */
#define MIN 1e-290

murk_axis murk_axis_of(double from, double to, murk_axis_scale scale)
{
    return (murk_axis){INFINITY, -INFINITY, from, to, scale};
}

static double raw_of(const murk_axis *a, double value)
{
    return a->scale == MURK_SCALE_LOG ? log10(value) : value;
}

void murk_axis_widen(murk_axis *a, double value)
{
    const double v = raw_of(a, value);
    if (isfinite(v)) {
        a->low = fmin(a->low, v);
        a->high = fmax(a->high, v);
    }
}

void murk_axis_close(murk_axis *a, double room)
{
    /* a range that adding changes nothing of is none */
    const double min = 1e-9 * fmax(fabs(a->low), fabs(a->high));
    if (!(a->high - a->low > min && a->high - a->low > MIN)) {
        const double by = a->scale == MURK_SCALE_WHOLE || fabs(a->high) < MIN
                              ? 0.5
                              : 0.1 * fabs(a->high);
        a->low -= by;
        a->high += by;
    }
    const double by = room * (a->high - a->low);
    a->low -= by;
    a->high += by;
}

double murk_axis_place(const murk_axis *a, double value)
{
    const double v = fmin(fmax(raw_of(a, value), a->low), a->high);
    /* halves: the whole range may be beyond a double */
    const double share = (v / 2 - a->low / 2) / (a->high / 2 - a->low / 2);
    return a->from + share * (a->to - a->from);
}

/* ---- ticks ---- */

static double round_step(double range)
{
    const double rough = range / TICKS;
    const double ten = pow(10, floor(log10(rough)));
    const double m = rough / ten;
    return ten * (m <= 1 ? 1 : m <= 2 ? 2 : m <= 5 ? 5 : 10);
}

static double clock_step(double hours)
{
    static const double steps[] = {0.25, 0.5, 1, 2, 3, 6};
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && hours / steps[i] > 9) {
        ++i;
    }
    return steps[i];
}

/* Powers of ten, and over less than three of them 2 and 5 times those. */
static size_t log_ticks(double out[MURK_TICKS_MAX], const murk_axis *a)
{
    static const double within[] = {1, 2, 5};
    const double decades = a->high - a->low;
    const double stride = fmax(1, ceil(decades / 8));
    const int each = decades > 3 ? 1 : 3;
    size_t n = 0;
    for (double e = floor(a->low / stride) * stride; e <= a->high;
         e += stride) {
        for (int k = 0; k < each && n < MURK_TICKS_MAX; ++k) {
            const double value = within[k] * pow(10, e);
            if (log10(value) >= a->low - 1e-9 &&
                log10(value) <= a->high + 1e-9) {
                out[n++] = value;
            }
        }
    }
    return n;
}

size_t murk_axis_ticks(double out[MURK_TICKS_MAX], double *step,
                       const murk_axis *a)
{
    *step = 0;
    if (a->scale == MURK_SCALE_LOG) {
        const size_t n = log_ticks(out, a);
        if (n >= 2) {
            return n;
        }
    }
    const bool is_log = a->scale == MURK_SCALE_LOG;
    const double low = is_log ? pow(10, a->low) : a->low;
    const double high = is_log ? pow(10, a->high) : a->high;
    double by = a->scale == MURK_SCALE_CLOCK ? clock_step(high - low)
                                             : round_step(high - low);
    by = a->scale == MURK_SCALE_WHOLE ? fmax(1, by) : by;
    const double first = ceil(low / by - 1e-9);
    size_t n = 0;
    while (n < MURK_TICKS_MAX && (first + (double)n) * by <= high + 1e-9 * by) {
        out[n] = (first + (double)n) * by + 0.0; /* no -0 */
        ++n;
    }
    *step = by;
    return n;
}

void murk_axis_write(FILE *to, const murk_axis *a, double value, double step)
{
    if (a->scale == MURK_SCALE_CLOCK) {
        const int minutes = (int)lround(fmin(fmax(value, 0), 99) * 60);
        fprintf(to, "%02d:%02d", minutes / 60, minutes % 60);
        return;
    }
    const bool is_share = a->scale == MURK_SCALE_SHARE;
    const double shown = is_share ? 100 * value : value;
    const double by = is_share ? 100 * step : step;
    const double max = fabs(shown);
    const int decimals = by > 0 ? -(int)floor(log10(by * 1.0001)) : 0;
    /* five digits tell ticks apart, but not those of surveyed coordinates */
    const bool tells_apart = !(by > 0 && by < 1e-4 * max);
    if (max > 0 && ((max >= 99999.5 && tells_apart) || max < 1e-4)) {
        murk_page_power(to, shown, 5);
    } else if (by > 0 && decimals <= 8) {
        fprintf(to, "%.*f", decimals > 0 ? decimals : 0, shown);
    } else {
        fprintf(to, "%.7g", shown);
    }
    fputs(is_share ? " %" : "", to);
}
