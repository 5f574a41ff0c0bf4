/* SPOQ's random numbers: where its sensors start, and in which order they
 * move. */
#ifndef MURK_PLACEMENT_DRAW_H
#define MURK_PLACEMENT_DRAW_H

#include <stddef.h>
#include <stdint.h>

/* shuffle[m] = 0, 1, .., m - 1: the permutation of one start, yet to be
 * drawn. */
void murk_draw_begin(uint32_t *shuffle, size_t m);

/* The k-th of that random permutation, after all before it; k < m. */
uint32_t murk_draw_next(uint32_t *shuffle, size_t m, uint32_t k, uint32_t seed,
                        uint64_t restart);

/* A random order of 0..n-1, for one sweep. */
void murk_draw_order(uint32_t *order, size_t n, uint32_t seed, uint64_t restart,
                     uint32_t sweep);

#endif
