/* The mean of coverages over several scenarios. */
#ifndef MURK_CASES_SCENARIO_MEAN_H
#define MURK_CASES_SCENARIO_MEAN_H

#include "sensing/sight.h"

/* The mean of the estimates of[n] by weight[n], over the finite ones; NaN if
 * there is none. The standard error is that of independent estimates, or else
 * the mean of the errors, which is an upper bound for dependent estimates. */
murk_estimate murk_scenario_mean(const murk_estimate *of, const double *weight,
                                 size_t n, bool are_independent);

/* The mean of whole coverage results of[n], each with as many sensors and
 * regions of interest. Release *out with murk_coverage_result_release(). Fails
 * with MURK_NO_MEMORY. */
murk_status murk_scenario_mean_coverage(murk_coverage_result *out,
                                        const murk_coverage_result *of,
                                        const double *weight, size_t n,
                                        size_t sensors, size_t regions,
                                        bool are_independent, murk_error *err);

#endif
