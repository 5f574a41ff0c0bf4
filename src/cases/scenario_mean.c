/* The weighted mean of estimates and of whole coverage results over scenarios,
 * with the error of independent estimates or, if they share random numbers, an
 * upper bound of the error. */
#include "cases/scenario_mean.h"

#include <math.h>
#include <stdlib.h>

void murk_mean_add(murk_mean *mean, murk_estimate of, double weight)
{
    if (weight > 0 && isfinite(of.value)) {
        const double error = weight * of.standard_error;
        mean->weight += weight;
        mean->sum += weight * of.value;
        mean->errors += error;
        mean->squares += error * error;
    }
}

murk_estimate murk_mean_of(const murk_mean *mean, bool are_independent)
{
    const double error = are_independent ? sqrt(mean->squares) : mean->errors;
    return mean->weight > 0
               ? (murk_estimate){mean->sum / mean->weight, error / mean->weight}
               : (murk_estimate){NAN, NAN};
}

/* The sums for those members of a coverage result that are estimates. */
typedef struct estimates {
    murk_mean total, surface, volume, at_least, map[2];
    murk_mean *region; /* [regions] */
} estimates;

/* Adds the coverage of one scenario: estimates to `to`, the values by sensor
 * and the counts of photons to `sum`. */
static void add(murk_coverage_result *sum, estimates *to,
                const murk_coverage_result *of, double weight, size_t sensors,
                size_t regions)
{
    murk_mean_add(&to->total, of->total, weight);
    murk_mean_add(&to->surface, of->surface, weight);
    murk_mean_add(&to->volume, of->volume, weight);
    murk_mean_add(&to->at_least, of->at_least, weight);
    for (size_t p = 0; p < 2; ++p) {
        const murk_map_share *map = &of->map[p];
        murk_mean_add(&to->map[p],
                      (murk_estimate){map->weight, map->standard_error},
                      weight);
        sum->map[p].photons += map->photons;
    }
    /* Regions of interest, then the values by sensor. */
    for (size_t i = 0; i < regions; ++i) {
        murk_mean_add(&to->region[i], of->region[i].coverage, weight);
        sum->region[i].photons += of->region[i].photons;
    }
    sum->sum_of_views += weight * of->sum_of_views;
    for (size_t i = 0; i < sensors; ++i) {
        sum->covers[i] += weight * of->covers[i];
        sum->only_it_covers[i] += weight * of->only_it_covers[i];
        sum->seen_by_at_least[i] += weight * of->seen_by_at_least[i];
    }
}

murk_status murk_scenario_mean_coverage(murk_coverage_result *out,
                                        const murk_coverage_result *of,
                                        const double *weight, size_t n,
                                        size_t sensors, size_t regions,
                                        bool are_independent, murk_error *err)
{
    estimates sums = {.region = calloc(regions + 1, sizeof *sums.region)};
    murk_coverage_result mean = {0};
    double all = 0;
    if (!murk_coverage_result_create(&mean, sensors, regions) || !sums.region) {
        free(sums.region);
        murk_coverage_result_release(&mean);
        return murk_no_memory(err, "", "for the coverage of %zu sensors",
                              sensors);
    }
    for (size_t c = 0; c < n; ++c) {
        if (weight[c] > 0) {
            all += weight[c];
            add(&mean, &sums, &of[c], weight[c], sensors, regions);
        }
    }
    /* Divide by the weight of the scenarios. */
    mean.total = murk_mean_of(&sums.total, are_independent);
    mean.surface = murk_mean_of(&sums.surface, are_independent);
    mean.volume = murk_mean_of(&sums.volume, are_independent);
    mean.at_least = murk_mean_of(&sums.at_least, are_independent);
    for (size_t p = 0; p < 2; ++p) {
        const murk_estimate map = murk_mean_of(&sums.map[p], are_independent);
        mean.map[p].weight = map.value;
        mean.map[p].standard_error = map.standard_error;
    }
    for (size_t i = 0; i < regions; ++i) {
        mean.region[i].coverage =
            murk_mean_of(&sums.region[i], are_independent);
    }
    mean.sum_of_views /= all;
    for (size_t i = 0; i < sensors; ++i) {
        mean.covers[i] /= all;
        mean.only_it_covers[i] /= all;
        mean.seen_by_at_least[i] /= all;
    }
    free(sums.region);
    *out = mean;
    return MURK_OK;
}
