/* Coverage as a ratio of sums, C = X / Y: X is the sum of weight times clarity
 * (visibility times transmittance) over the records in view, and Y the sum of
 * the weights of all records. Both maps form one ratio; with balanced weights,
 * C is the mean of the ratios of the two maps, or the ratio of the only map
 * that has weight. For use inside src/calibrate only.
 *
 * The contribution of a batch to C = X / Y is C / batches + (X_b - C Y_b) / Y.
 * The second term is the linearised residual of the ratio estimator and sums to
 * 0. The covariance over batches is therefore computed as sensing/coverage.c
 * computes that over emitted photons (Cochran, Sampling Techniques, 1977,
 * ch. 6), and both are equal if each photon is a batch. Larger batches contain
 * the photons of each light source and band in proportion, so differences
 * between sources do not count as error (stratified sampling, ibid. ch. 5).
 * That is correct, because the proportions are fixed; photons taken one by one
 * would count these differences. */
#ifndef MURK_CALIBRATE_COVERAGE_RATIO_H
#define MURK_CALIBRATE_COVERAGE_RATIO_H

#include "calibrate/coverage_sums.h"

/* C = sum over maps of part * X / whole. */
typedef struct murk_coverage_mix {
    double part[MURK_MAP_PARTS], whole[MURK_MAP_PARTS];
    bool is_one; /* one ratio of sums instead of a mean of ratios */
} murk_coverage_mix;

/* Sets the weights of both maps from the weights that the scene states and
 * all[], the total weight of the records of each map. False if no map that
 * counts has weight, or if a weight is not finite. */
bool murk_coverage_mix_of(murk_coverage_mix *out,
                          const murk_map_weights *weights,
                          const double all[MURK_MAP_PARTS]);

/* Computes the coverage of a group with slope[keys] and, unless batch is NULL,
 * batch[batches * stride] (every stride-th element), the contributions of the
 * batches. */
void murk_coverage_ratio(double *value, double *slope, double *batch,
                         size_t stride, size_t group,
                         const murk_coverage_sums *sums,
                         const murk_coverage_mix *mix);

/* Contributions of the runs to the slopes: part[run * stride + k] is that of a
 * run to slope[k], and all runs add up to slope[k]. Each is an equal share of
 * slope[k] plus the derivative of the linearised residual (X_r - C Y_r) / Y of
 * the run r, by the quotient rule. */
void murk_coverage_slope_parts(double *part, size_t stride, const double *slope,
                               size_t group, const murk_coverage_sums *sums,
                               const murk_coverage_mix *mix);

#endif
