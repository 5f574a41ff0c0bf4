/* Coverage from its sums: C = X / Y of one map, X what is seen and Y all of its
 * weight; balanced, the mean of two such ratios. Inside this room only.
 *
 * The part of a batch in C = X / Y is C / batches + (X_b - C Y_b) / Y: the
 * second term is the ratio estimator's linearised residual, which adds up to 0,
 * so its covariance over batches is that of sensing/coverage.c over emitted
 * photons (Cochran, Sampling Techniques, 1977, ch. 6): the very same where each
 * photon is a batch. Batches of more hold the photons of each light and band in
 * proportion, as they are dealt, so that what differs between these is no error
 * (stratified sampling, ibid. ch. 5), as it is not in truth; photons one by one
 * count it. */
#ifndef MURK_CALIBRATE_COVERAGE_RATIO_H
#define MURK_CALIBRATE_COVERAGE_RATIO_H

#include "calibrate/coverage_sums.h"

/* C = sum over maps of part X / whole. */
typedef struct murk_coverage_mix {
    double part[MURK_MAP_PARTS], whole[MURK_MAP_PARTS];
    bool is_one; /* one ratio of sums, not a mean of ratios */
} murk_coverage_mix;

/* As the scene weighs the maps, by all their weight. False where they have
 * none. */
bool murk_coverage_mix_of(murk_coverage_mix *out,
                          const murk_map_weights *weights,
                          const double all[MURK_MAP_PARTS]);

/* slope[keys]; batch[batches * stride], every stride-th, or NULL. */
void murk_coverage_ratio(double *value, double *slope, double *batch,
                         size_t stride, size_t group,
                         const murk_coverage_sums *sums,
                         const murk_coverage_mix *mix);

/* Runs' parts of the slopes, part[runs * stride], each [keys], which add up to
 * slope[keys]: of the linearised residuals (X_b - C Y_b) / Y, by the quotient's
 * own rule. */
void murk_coverage_slope_parts(double *part, size_t stride, const double *slope,
                               size_t group, const murk_coverage_sums *sums,
                               const murk_coverage_mix *mix);

#endif
