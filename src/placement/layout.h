/* The order of the photons in placement's arrays: each photon has a slot.
 *
 * Photons of one weight share 64-bit words, and each weight begins with a new
 * word, so the weighted sum of a word is the weight times a bit count. If there
 * is only one weight, or more than one distinct weight for 252 photons, photon
 * i stays in slot i, and words of mixed weights are summed photon by photon. */
#ifndef MURK_PLACEMENT_LAYOUT_H
#define MURK_PLACEMENT_LAYOUT_H

#include "placement/dose.h"
#include "placement/kernels.h"
#include "placement/problem.h"

/* A run of words whose photons have one weight, or of words with mixed weights.
 */
typedef struct murk_weight_run {
    size_t first_word, words;
    uint32_t weight; /* of each photon; not if is_mixed */
    bool is_mixed;
} murk_weight_run;

typedef struct murk_layout {
    size_t photons, slots,
        words;           /* slots = 64 * words, including unused slots */
    uint32_t *slot;      /* [photons]; NULL: photon i has slot i */
    bool is_grouped;     /* each word has photons of one weight, as a rule */
    size_t added;        /* photons with the slot of one that is gone, or behind
                          * all others (murk_layout_patch()) */
    bool is_borrowed;    /* slot and doses belong to another layout */
    uint32_t *weight;    /* [slots], 0 in unused slots */
    size_t layers;       /* entries of a photon that count: the redundancy */
    murk_doses *doses;   /* for detection probabilities, else NULL */
    uint64_t whole;      /* sum of weights times MURK_CLEAR, times layers */
    uint32_t weight_gcd; /* greatest common divisor of the weights */
    murk_weight_run *segment; /* [segments] */
    size_t segments;
    const murk_kernels *kernels;
} murk_layout;

/* With regroup false each photon i keeps slot i. Copies the weights. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_layout_init(murk_layout *out, const murk_problem *problem,
                             bool regroup, murk_error *err);
/* The layout of nearly the same photons: earlier[photons] is the number of each
 * photon in `from`, whose slot it has, or MURK_NO_PHOTON; such a photon has a
 * slot that was free, among others of its weight if `from` is grouped, or one
 * behind all others. Fails with MURK_NO_MEMORY. */
murk_status murk_layout_patch(murk_layout *out, const murk_problem *problem,
                              const murk_layout *from, const uint32_t *earlier,
                              murk_error *err);
/* The same slots with other weights, weight[photons]. Borrows from `from`,
 * which must outlive *out. *out is all zero at the first call; a second call on
 * the same *out only replaces the weights. Fails with MURK_NO_MEMORY. */
murk_status murk_layout_reweigh(murk_layout *out, const murk_layout *from,
                                const uint32_t *weight, murk_error *err);
void murk_layout_release(murk_layout *layout);

static inline size_t murk_layout_slot(const murk_layout *layout,
                                      uint32_t photon)
{
    return layout->slot ? layout->slot[photon] : photon;
}

/* The greatest common divisor of weight[n], 1 if all are 0. */
uint32_t murk_common_divisor(const uint32_t *weight, size_t n);

/* At least n bytes, zeroed and aligned to 64 bytes (one cache line, the widest
 * vector register), for free(). NULL when out of memory. */
void *murk_aligned_zeros(size_t n);

#endif
