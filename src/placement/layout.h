/* Where photons lie inside placement's arrays.
 *
 * Photons of one weight are put side by side, each weight starting a new word
 * of 64, so that a sum over a word is a count times the weight. Where nearly
 * every photon has its own weight they stay as they are, and such words are
 * summed photon by photon. */
#ifndef MURK_PLACEMENT_LAYOUT_H
#define MURK_PLACEMENT_LAYOUT_H

#include "placement/dose.h"
#include "placement/kernels.h"
#include "placement/problem.h"

/* Words of one weight, or of mixed ones. */
typedef struct murk_weight_run {
    size_t first_word, words;
    uint32_t weight; /* of each photon, unless is_mixed */
    bool is_mixed;
} murk_weight_run;

typedef struct murk_layout {
    size_t photons, slots, words; /* slots = 64 * words, padding included */
    uint32_t *slot;               /* [photons]; NULL: photon i has slot i */
    bool is_borrowed;             /* slot and doses are another layout's */
    uint32_t *weight;             /* [slots], 0 in the padding */
    size_t layers;       /* views of a photon that count: the redundancy */
    murk_doses *doses;   /* where chances are independent, else NULL */
    uint64_t whole;      /* sum of weights times MURK_CLEAR, times layers */
    uint32_t weight_gcd; /* greatest common divisor of the weights */
    murk_weight_run *segment; /* [segments] */
    size_t segments;
    const murk_kernels *kernels;
} murk_layout;

/* regroup false keeps every photon in its place. */
murk_status murk_layout_init(murk_layout *out, const murk_problem *problem,
                             bool regroup, murk_error *err);
/* The same slots under other weights, weight[photons]. Borrows from `from`,
 * which must outlive it; called again, it changes the weights of *out. */
murk_status murk_layout_reweigh(murk_layout *out, const murk_layout *from,
                                const uint32_t *weight, murk_error *err);
void murk_layout_release(murk_layout *layout);

static inline size_t murk_layout_slot(const murk_layout *layout,
                                      uint32_t photon)
{
    return layout->slot ? layout->slot[photon] : photon;
}

/* n bytes or more, zeroed, 64-byte aligned, for free(); NULL when out of
 * memory. */
void *murk_aligned_zeros(size_t n);

#endif
