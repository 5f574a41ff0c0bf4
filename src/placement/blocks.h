/* Photons in blocks, one a condition (clear air, fog), and how much of each
 * block is covered.
 *
 * The blocks of a problem lie behind one another and share its rows; a view of
 * one block is the same layout with no weight elsewhere. Coverages of
 * different blocks are compared as shares of their own weight, in units of
 * 1 / MURK_SHARE_ONE, rounded down: whole numbers again, and what is rounded
 * away is less than 3e-16. */
#ifndef MURK_PLACEMENT_BLOCKS_H
#define MURK_PLACEMENT_BLOCKS_H

#include "placement/oracle.h"

#define MURK_BLOCKS_MAX 64
#define MURK_SHARE_ONE  (UINT64_C(1) << 52)

/* first[n + 1]: block c has the photons first[c] .. first[c + 1] - 1. Each has
 * weight. */
typedef struct murk_blocks {
    size_t n;
    size_t first[MURK_BLOCKS_MAX + 1];
} murk_blocks;

typedef struct murk_block_views {
    const murk_blocks *blocks;
    const murk_oracle *oracle;           /* over all of them */
    murk_layout layout[MURK_BLOCKS_MAX]; /* slots as the oracle's */
    uint64_t whole[MURK_BLOCKS_MAX];     /* weight times MURK_CLEAR */
    uint64_t *most; /* [candidates][n] no gain is more: value by itself, and
                       what rounding may add */
    uint64_t ceiling[MURK_BLOCKS_MAX]; /* all candidates chosen */
} murk_block_views;

/* Borrows both. Release also after a failure. */
murk_status murk_block_views_init(murk_block_views *out,
                                  const murk_oracle *oracle,
                                  const murk_blocks *blocks, murk_error *err);
void murk_block_views_release(murk_block_views *views);

/* part of whole, 0 .. MURK_SHARE_ONE. */
uint64_t murk_share_units(uint64_t part, uint64_t whole);

/* gain[k * n + c] = what candidate[k] would add to the cover in block c, over
 * all threads. */
void murk_block_gains(const murk_block_views *views, const murk_cover *cover,
                      const uint32_t *candidate, size_t count, uint64_t *gain);

#endif
