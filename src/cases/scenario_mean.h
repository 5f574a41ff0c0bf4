/* The mean of coverages over several scenarios. */
#ifndef MURK_CASES_SCENARIO_MEAN_H
#define MURK_CASES_SCENARIO_MEAN_H

#include "sensing/sight.h"

/* A weighted mean that is being summed up; it begins as zeros. */
typedef struct murk_mean {
    double weight, sum, errors, squares;
} murk_mean;

/* Adds an estimate, unless its weight is 0 or its value NaN. */
void murk_mean_add(murk_mean *mean, murk_estimate of, double weight);

/* The mean; NaN if no estimate was added. The standard error is that of
 * independent estimates, or else the mean of the errors, which is an upper
 * bound for dependent estimates. */
murk_estimate murk_mean_of(const murk_mean *mean, bool are_independent);

/* The mean of whole coverage results of[n], each with the given numbers of
 * sensors and of regions of interest. Each weight[n] is 0 or more, at least one
 * is above 0, and a result of weight 0 is left out. Counts of photons are
 * summed. Release *out with murk_coverage_result_release(). Fails with
 * MURK_NO_MEMORY. */
murk_status murk_scenario_mean_coverage(murk_coverage_result *out,
                                        const murk_coverage_result *of,
                                        const double *weight, size_t n,
                                        size_t sensors, size_t regions,
                                        bool are_independent, murk_error *err);

#endif
