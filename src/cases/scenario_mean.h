/* Coverages of several conditions as one. */
#ifndef MURK_CASES_SCENARIO_MEAN_H
#define MURK_CASES_SCENARIO_MEAN_H

#include "sensing/sight.h"

/* The mean of estimates[n] by weight, over those that are finite. Errors: of
 * independent estimates, or the most that they can make together. */
murk_estimate murk_scenario_mean(const murk_estimate *of, const double *weight,
                                 size_t n, bool are_independent);

/* The same of all that a coverage of `sensors` says, with `regions` of
 * interest. Release *out with murk_coverage_result_release(). */
murk_status murk_scenario_mean_coverage(murk_coverage_result *out,
                                        const murk_coverage_result *of,
                                        const double *weight, size_t n,
                                        size_t sensors, size_t regions,
                                        bool are_independent, murk_error *err);

#endif
