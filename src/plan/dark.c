/* Coverage in a scene in which no light source emits: every share is NaN, for
 * the total, for each map, for each sensor and for each region of interest. */
#include "plan/dark.h"

#include <math.h>
#include <stdlib.h>

/* An undefined share. */
static const murk_estimate NOTHING = {NAN, NAN};

/* n undefined shares; NULL when out of memory. */
static double *none_of(size_t n)
{
    double *out = malloc(n * sizeof *out + 1);
    for (size_t i = 0; out && i < n; ++i) {
        out[i] = NAN;
    }
    return out;
}

murk_status murk_dark_coverage(murk_coverage_result *out,
                               const murk_stage *stage, size_t n,
                               murk_error *err)
{
    /* The totals and the values of each sensor. */
    const size_t regions = stage->scene->placement.n_interests;
    murk_coverage_result made = {.total = NOTHING,
                                 .surface = NOTHING,
                                 .volume = NOTHING,
                                 .map = {{0, NAN, NAN}, {0, NAN, NAN}},
                                 .sum_of_views = NAN,
                                 .covers = none_of(n),
                                 .only_it_covers = none_of(n),
                                 .seen_by_at_least = none_of(n)};
    made.region = regions ? calloc(regions, sizeof *made.region) : NULL;
    if (!made.covers || !made.only_it_covers || !made.seen_by_at_least ||
        (regions && !made.region)) {
        murk_coverage_result_release(&made);
        return murk_fail(err, MURK_NO_MEMORY, stage->scene->path,
                         "no memory for %zu sensors", n);
    }
    /* The regions of interest. */
    for (size_t i = 0; i < regions; ++i) {
        made.region[i].coverage = NOTHING;
    }
    *out = made;
    return MURK_OK;
}
