/* The weighted mean of estimates and of whole coverage results over scenarios,
 * with the error of independent estimates or, if they share random numbers, an
 * upper bound of it. */
#include "cases/scenario_mean.h"

#include <math.h>
#include <stdlib.h>

murk_estimate murk_scenario_mean(const murk_estimate *of, const double *weight,
                                 size_t n, bool are_independent)
{
    double all = 0, sum = 0, error = 0, squares = 0;
    for (size_t c = 0; c < n; ++c) {
        if (weight[c] > 0 && isfinite(of[c].value)) {
            const double mine = weight[c] * of[c].standard_error;
            all += weight[c];
            sum += weight[c] * of[c].value;
            error += mine;
            squares += mine * mine;
        }
    }
    return all > 0 ? (murk_estimate){sum / all,
                                     (are_independent ? sqrt(squares) : error) /
                                         all}
                   : (murk_estimate){NAN, NAN};
}

static double mean_of(const murk_coverage_result *of, const double *weight,
                      size_t n,
                      double (*read)(const murk_coverage_result *of, size_t i),
                      size_t i)
{
    double all = 0, sum = 0;
    for (size_t c = 0; c < n; ++c) {
        if (weight[c] > 0) {
            all += weight[c];
            sum += weight[c] * read(&of[c], i);
        }
    }
    return sum / all;
}

static double read_covers(const murk_coverage_result *of, size_t i)
{
    return of->covers[i];
}

static double read_only(const murk_coverage_result *of, size_t i)
{
    return of->only_it_covers[i];
}

static double read_seen(const murk_coverage_result *of, size_t i)
{
    return of->seen_by_at_least[i];
}

static double read_sum_of_views(const murk_coverage_result *of, size_t i)
{
    (void)i;
    return of->sum_of_views;
}

typedef murk_estimate (*reader)(const murk_coverage_result *of, size_t i);

static murk_estimate read_total(const murk_coverage_result *of, size_t i)
{
    (void)i;
    return of->total;
}

static murk_estimate read_surface(const murk_coverage_result *of, size_t i)
{
    (void)i;
    return of->surface;
}

static murk_estimate read_volume(const murk_coverage_result *of, size_t i)
{
    (void)i;
    return of->volume;
}

static murk_estimate read_map_surface(const murk_coverage_result *of, size_t i)
{
    (void)i;
    return (murk_estimate){of->map[0].weight, of->map[0].standard_error};
}

static murk_estimate read_map_volume(const murk_coverage_result *of, size_t i)
{
    (void)i;
    return (murk_estimate){of->map[1].weight, of->map[1].standard_error};
}

static murk_estimate read_region(const murk_coverage_result *of, size_t i)
{
    return of->region[i].coverage;
}

static murk_status fill(murk_coverage_result *out,
                        const murk_coverage_result *of, const double *weight,
                        size_t n, size_t sensors, size_t regions)
{
    /* Allocate the arrays by sensor and by region. */
    out->covers = calloc(sensors + 1, sizeof *out->covers);
    out->only_it_covers = calloc(sensors + 1, sizeof *out->only_it_covers);
    out->seen_by_at_least = calloc(sensors + 1, sizeof *out->seen_by_at_least);
    out->region = regions ? calloc(regions, sizeof *out->region) : NULL;
    if (!out->covers || !out->only_it_covers || !out->seen_by_at_least ||
        (regions && !out->region)) {
        return MURK_NO_MEMORY;
    }
    /* Means by sensor; counts of photons are added. */
    out->sum_of_views = mean_of(of, weight, n, read_sum_of_views, 0);
    for (size_t i = 0; i < sensors; ++i) {
        out->covers[i] = mean_of(of, weight, n, read_covers, i);
        out->only_it_covers[i] = mean_of(of, weight, n, read_only, i);
        out->seen_by_at_least[i] = mean_of(of, weight, n, read_seen, i);
    }
    for (size_t i = 0; i < regions; ++i) {
        for (size_t c = 0; c < n; ++c) {
            out->region[i].photons +=
                weight[c] > 0 ? of[c].region[i].photons : 0;
        }
    }
    return MURK_OK;
}

murk_status murk_scenario_mean_coverage(murk_coverage_result *out,
                                        const murk_coverage_result *of,
                                        const double *weight, size_t n,
                                        size_t sensors, size_t regions,
                                        bool are_independent, murk_error *err)
{
    murk_coverage_result mean = {0};
    murk_estimate *each = calloc(n + 1, sizeof *each);
    if (!each || fill(&mean, of, weight, n, sensors, regions)) {
        free(each);
        murk_coverage_result_release(&mean);
        return murk_fail(err, MURK_NO_MEMORY, "",
                         "no memory for the coverage of %zu sensors", sensors);
    }
    /* Each estimate of a coverage result has a function that reads it from one
     * scenario and a place that receives the mean. */
    enum { PLAIN = 5 };
    const reader readers[PLAIN] = {read_total, read_surface, read_volume,
                                   read_map_surface, read_map_volume};
    murk_estimate map[2];
    murk_estimate *const to[PLAIN] = {&mean.total, &mean.surface, &mean.volume,
                                      &map[0], &map[1]};
    for (size_t k = 0; k < PLAIN + regions; ++k) {
        const reader read = k < PLAIN ? readers[k] : read_region;
        for (size_t c = 0; c < n; ++c) {
            each[c] = weight[c] > 0 ? read(&of[c], k < PLAIN ? 0 : k - PLAIN)
                                    : (murk_estimate){NAN, NAN};
        }
        *(k < PLAIN ? to[k] : &mean.region[k - PLAIN].coverage) =
            murk_scenario_mean(each, weight, n, are_independent);
    }
    /* The two maps, surface and volume. */
    for (size_t p = 0; p < 2; ++p) {
        mean.map[p].weight = map[p].value;
        mean.map[p].standard_error = map[p].standard_error;
        for (size_t c = 0; c < n; ++c) {
            mean.map[p].photons += weight[c] > 0 ? of[c].map[p].photons : 0;
        }
    }
    free(each);
    *out = mean;
    return MURK_OK;
}
