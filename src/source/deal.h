/* Dealing photons to channels in proportion to weights, one by one, so that
 * every prefix of the photons is dealt fairly.
 *
 * The first photons go one to each channel; photon k after them goes where the
 * fractional part of k times the golden ratio falls among the cumulative
 * weights. All in whole numbers, so the answer is the same on any machine. No
 * channel is ever more than a few photons from its share (the sequence's
 * discrepancy grows as log n: Kuipers and Niederreiter, Uniform Distribution
 * of Sequences, 1974, ch. 2.3). */
#ifndef MURK_SOURCE_DEAL_H
#define MURK_SOURCE_DEAL_H

#include <stddef.h>
#include <stdint.h>

/* limit[i] = (weights 0..i together / all) * 2^64, for i < n - 1. The last
 * one has no limit. weight[n] > 0, their sum finite. */
void murk_deal_limits(const double *weight, size_t n, uint64_t *limit);

/* Which of n channels photon goes to. */
size_t murk_deal_one(const uint64_t *limit, size_t n, uint64_t photon);

/* How many of the photons [0, photons) go to each: fills count[n]. Exact, in
 * n log(photons) steps. photons < 2^62. */
void murk_deal_count(const uint64_t *limit, size_t n, uint64_t photons,
                     uint64_t *count);

#endif
