/* The values of a grid in blocks of 8 x 8 x 8 cells between voxel centres, each
 * with all 9 x 9 x 9 corners of the block, so that a walk with trilinear
 * interpolation (medium/linear.h) finds the corners of any cell in one array.
 * There is a block wherever a leaf of the tree takes part in one of the cells.
 * The layer that blocks share with their neighbours is stored several times: a
 * block takes 3040 bytes, a leaf of the tree 2144. Immutable after creation.
 *
 * For use inside src/medium only. */
#ifndef MURK_MEDIUM_LINEAR_BLOCKS_H
#define MURK_MEDIUM_LINEAR_BLOCKS_H

#include "base/lanes.h"
#include "medium/tree.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Distances of neighbours along x and y in the values of a block. */
#define MURK_CORNER_X 81
#define MURK_CORNER_Y 9

/* The values of a block, 9^3 and some that fill the last line of the cache. */
#define MURK_BLOCK_VALUES 736

/* The index of a cell in the values: that of the lowest corner of the cell. It
 * is at most 637. */
#define MURK_CELL_AT(x, y, z) ((x)*MURK_CORNER_X + (y)*MURK_CORNER_Y + (z))

/* The part of a block that a walk always reads, apart from the values, so that
 * it stays in the cache. */
typedef struct murk_linear_block {
    int32_t first[3];    /* the lowest cell, a multiple of 8 along each axis */
    bool has_leaf;       /* the lowest voxel is in a leaf */
    uint64_t filled[10]; /* bits by index of a cell: whether the value at one of
                            the corners is not 0 */
} murk_linear_block;

typedef struct murk_linear_blocks {
    const murk_tree *tree; /* NULL: no blocks */
    size_t n;
    murk_linear_block *block;
    float *value; /* [n][MURK_BLOCK_VALUES] */
    /* Hash table with open addressing: the number of a block plus 1; 0: free.
     * The number of slots is 2 to the power of (64 - shift). */
    uint32_t *slot;
    size_t slot_mask;
    unsigned shift;
    murk_lane_set set; /* the instructions that integrals use */
} murk_linear_blocks;

/* Makes the blocks of a tree, which must stay valid; integrals use the common
 * choice of instructions (base/lanes.h), or the baseline if that is `off`. The
 * caller releases them with murk_linear_blocks_release(). Fails with
 * MURK_NO_MEMORY at `where`. */
murk_status murk_linear_blocks_make(murk_linear_blocks *blocks,
                                    const murk_tree *tree, const char *where,
                                    murk_error *err);
void murk_linear_blocks_release(murk_linear_blocks *blocks);

/* 1 if the value at a corner of the cell with this index is not 0, else 0. */
static inline unsigned murk_linear_is_filled(const murk_linear_block *block,
                                             size_t index)
{
    return (unsigned)(block->filled[index / 64] >> (index % 64)) & 1;
}

/* The slot of the block whose lowest cell is first[], or the free slot in which
 * it would be. Hash: a sum of products with odd constants, high bits (Knuth,
 * The Art of Computer Programming 3, 2nd ed., 6.4). The constants are those of
 * splitmix64 (Steele, Lea and Flood, OOPSLA 2014,
 * doi:10.1145/2660193.2660195). */
static inline uint32_t *murk_linear_slot(const murk_linear_blocks *b,
                                         const int32_t first[3])
{
    const uint64_t hash =
        (uint64_t)(first[0] >> 3) * UINT64_C(0x9e3779b97f4a7c15) +
        (uint64_t)(first[1] >> 3) * UINT64_C(0xbf58476d1ce4e5b9) +
        (uint64_t)(first[2] >> 3) * UINT64_C(0x94d049bb133111eb);
    for (size_t i = hash >> b->shift;; i = (i + 1) & b->slot_mask) {
        uint32_t *slot = &b->slot[i];
        if (*slot == 0) {
            return slot;
        }
        const int32_t *at = b->block[*slot - 1].first;
        if (at[0] == first[0] && at[1] == first[1] && at[2] == first[2]) {
            return slot;
        }
    }
}

/* The block whose lowest cell is first[]; NULL if no leaf takes part in it. */
static inline const murk_linear_block *
murk_linear_block_at(const murk_linear_blocks *b, const int32_t first[3])
{
    const uint32_t number = *murk_linear_slot(b, first);
    return number > 0 ? &b->block[number - 1] : NULL;
}

/* The values of a block. */
static inline float *murk_linear_values(const murk_linear_blocks *b,
                                        const murk_linear_block *block)
{
    return &b->value[(size_t)(block - b->block) * MURK_BLOCK_VALUES];
}

#endif
