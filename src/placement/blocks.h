/* Photons in blocks, one a condition (clear air, fog), and how much of each
 * block is covered.
 *
 * The blocks of a problem lie behind one another and share its rows; a view of
 * one block is the same layout with no weight elsewhere. Coverages of
 * different blocks are compared as shares of their own weight, in units of
 * 1 / MURK_SHARE_ONE, rounded down: whole numbers again, and what is rounded
 * away is less than 3e-16.
 *
 * With regret a block counts by how far it is from a reference, the best
 * coverage known for that block alone: worth is 1 less the regret, so the plan
 * of the least largest regret is that of the largest least worth. Worth exceeds
 * 1 where a plan covers more than the reference. */
#ifndef MURK_PLACEMENT_BLOCKS_H
#define MURK_PLACEMENT_BLOCKS_H

#include "placement/evaluator.h"

#define MURK_BLOCKS_MAX 64
#define MURK_SHARE_ONE  (UINT64_C(1) << 52)

typedef enum murk_block_measure {
    MURK_BLOCK_SHARE,           /* worth = share */
    MURK_BLOCK_REGRET,          /* 1 - (reference - share) */
    MURK_BLOCK_REGRET_RELATIVE, /* 1 - (reference - share) / reference; 1 where
                                   the reference is 0: nobody sees anything */
} murk_block_measure;

/* first[n + 1]: block c has the photons first[c] .. first[c + 1] - 1. Each has
 * weight. */
typedef struct murk_blocks {
    size_t n;
    size_t first[MURK_BLOCKS_MAX + 1];
    murk_block_measure measure;
    uint64_t reference[MURK_BLOCKS_MAX]; /* with regret: a value, weight times
                                            MURK_CLEAR, at most the whole */
} murk_blocks;

typedef struct murk_block_views {
    const murk_blocks *blocks;
    const murk_evaluator *evaluator;     /* over all of them */
    murk_layout layout[MURK_BLOCKS_MAX]; /* slots as the evaluator's */
    uint64_t whole[MURK_BLOCKS_MAX];     /* weight times MURK_CLEAR */
    /* A block's worth is value / unit + offset, in units of MURK_SHARE_ONE. */
    uint64_t unit[MURK_BLOCKS_MAX], offset[MURK_BLOCKS_MAX];
    uint64_t *max; /* [candidates][n] no gain is more: value by itself, and
                       what rounding may add */
    uint64_t ceiling[MURK_BLOCKS_MAX]; /* all candidates chosen */
} murk_block_views;

/* Borrows both. Release also after a failure. */
murk_status murk_block_views_init(murk_block_views *out,
                                  const murk_evaluator *evaluator,
                                  const murk_blocks *blocks, murk_error *err);
void murk_block_views_release(murk_block_views *views);

/* part of whole, 0 .. MURK_SHARE_ONE. */
uint64_t murk_share_units(uint64_t part, uint64_t whole);

/* What a block is worth by the measure of the blocks, in units. */
uint64_t murk_block_worth(const murk_block_views *views, size_t c,
                          uint64_t value);

/* gain[k * n + c] = what candidate[k] would add to the cover in block c, over
 * all threads. */
void murk_block_gains(const murk_block_views *views, const murk_cover *cover,
                      const uint32_t *candidate, size_t count, uint64_t *gain);

#endif
