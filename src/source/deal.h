/* Deals photons to channels in proportion to weights, so that every prefix of
 * the photon indices is in proportion, too.
 *
 * The first n photons go one to each of the n channels. Photon n + k, with k
 * from 0, goes to the channel in which the fractional part of k times the
 * golden ratio falls among the cumulative weights. The limits and the sequence
 * are integers of 64 bits, so no rounding depends on the photon index. The
 * count of a channel differs from the exact share by a few photons at most (the
 * discrepancy of the sequence grows as the logarithm of the number of photons:
 * Kuipers and Niederreiter, Uniform Distribution of Sequences, 1974, ch.
 * 2.3). */
#ifndef MURK_SOURCE_DEAL_H
#define MURK_SOURCE_DEAL_H

#include <stddef.h>
#include <stdint.h>

/* limit[i] = (sum of weights 0..i / sum of all) * 2^64, for i < n - 1. The last
 * channel has no limit. weight[n] > 0 with a finite sum. */
void murk_deal_limits(const double *weight, size_t n, uint64_t *limit);

/* The channel in [0, n) of a photon. */
size_t murk_deal_one(const uint64_t *limit, size_t n, uint64_t photon);

/* Counts the photons [0, photons) of each channel into count[n]. The counts are
 * exact and take n log(photons) steps. photons < 2^62. */
void murk_deal_count(const uint64_t *limit, size_t n, uint64_t photons,
                     uint64_t *count);

#endif
