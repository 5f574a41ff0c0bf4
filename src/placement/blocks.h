/* Blocks: the photons of several scenarios (clear air, fog) in one problem, and
 * the coverage of each block.
 *
 * The blocks lie one after the other and share the rows of the matrix. Each
 * block has a layout with the same slots and weight 0 outside the block.
 * Coverages of blocks are compared as shares of the block's own weight, in
 * units of 1 / MURK_SHARE_ONE, rounded down. So they are whole numbers, and the
 * rounding error is below 3e-16.
 *
 * With regret the worth of a block is 1 minus the shortfall against a
 * reference, the best coverage known for that block alone. The plan of the
 * smallest largest regret is then the plan of the largest smallest worth. A
 * worth exceeds 1 if a plan covers more than the reference. */
#ifndef MURK_PLACEMENT_BLOCKS_H
#define MURK_PLACEMENT_BLOCKS_H

#include "placement/evaluator.h"

/* A chosen limit of scenarios. */
#define MURK_BLOCKS_MAX 64
/* 2^52: shares up to 2 are exact as doubles, which have 53 bits, and sums over
 * 64 blocks fit 64 bits. */
#define MURK_SHARE_ONE (UINT64_C(1) << 52)

typedef enum murk_block_measure {
    MURK_BLOCK_SHARE,           /* worth = share */
    MURK_BLOCK_REGRET,          /* 1 - (reference - share) */
    MURK_BLOCK_REGRET_RELATIVE, /* 1 - (reference - share) / reference, with the
                                   reference as a share; 1 if the reference is
                                   0: no candidate sees the block */
} murk_block_measure;

/* Block c has the photons first[c] .. first[c + 1] - 1, with a positive total
 * weight. */
typedef struct murk_blocks {
    size_t n;
    size_t first[MURK_BLOCKS_MAX + 1];
    murk_block_measure measure;
    uint64_t reference[MURK_BLOCKS_MAX]; /* with regret: a value (weight times
                                            MURK_CLEAR), at most that of the
                                            whole block */
} murk_blocks;

typedef struct murk_block_layouts {
    const murk_blocks *blocks;
    const murk_evaluator *evaluator;     /* of all blocks together */
    murk_layout layout[MURK_BLOCKS_MAX]; /* with the evaluator's slots */
    uint64_t whole[MURK_BLOCKS_MAX];     /* weight times MURK_CLEAR */
    /* The worth of a block in units of 1 / MURK_SHARE_ONE is MURK_SHARE_ONE *
     * value / unit + offset. */
    uint64_t unit[MURK_BLOCKS_MAX], offset[MURK_BLOCKS_MAX];
    uint64_t *max; /* [candidates][n] upper bounds on gains: the value of the
                      candidate alone in the block, plus the rounding slack of
                      detection probabilities */
    uint64_t ceiling[MURK_BLOCKS_MAX]; /* value of all candidates together */
} murk_block_layouts;

/* Borrows evaluator and blocks. Fails with MURK_RUN_FAILED if the photons of a
 * block have no weight, or with MURK_NO_MEMORY. Call
 * murk_block_layouts_release() also after a failure. */
murk_status murk_block_layouts_init(murk_block_layouts *out,
                                    const murk_evaluator *evaluator,
                                    const murk_blocks *blocks, murk_error *err);
void murk_block_layouts_release(murk_block_layouts *layouts);

/* part / whole in units of 1 / MURK_SHARE_ONE, rounded down. */
uint64_t murk_share_units(uint64_t part, uint64_t whole);

/* The worth of block c with this value, in units of 1 / MURK_SHARE_ONE. */
uint64_t murk_block_worth(const murk_block_layouts *layouts, size_t c,
                          uint64_t value);

/* gain[k * n + c] = the gain of candidate[k] in block c (weight times
 * MURK_CLEAR), for k < count and n blocks. Uses the number of threads that
 * murk_evaluator_threads() gives (placement/evaluator.h). */
void murk_block_gains(const murk_block_layouts *layouts,
                      const murk_cover *cover, const uint32_t *candidate,
                      size_t count, uint64_t *gain);

#endif
