/* Storage of the bounds of medium/bricks.h: cells with edges of 128, 4096, ...
 * voxels in one hash table. A cell that contains smaller ones is their parent.
 * The bound of a cell applies to all of it, so the bound at a voxel is the
 * largest on the path from the top cell down. The value of a tile can therefore
 * be stored at one cell, whether or not that cell contains smaller ones. For
 * bricks_build.c and brick_walk.c only. */
#ifndef MURK_MEDIUM_BRICK_CELLS_H
#define MURK_MEDIUM_BRICK_CELLS_H

#include "medium/bricks.h"

/* log2 of the edges of cells, smallest first: blocks (128 voxels), the root
 * cells of the tree (4096), and further levels by a factor of 32 until 16 cells
 * along each axis cover all indices (MURK_INDEX_MAX of medium/tree.h). */
#define MURK_BRICK_LEVELS 5
static const int murk_level_shift[MURK_BRICK_LEVELS] = {7, 12, 17, 22, 27};

/* Edge of a block in voxels, which is that of a lower node of the tree
 * (medium/nodes.h), and the mark of a block that has no table of bricks. */
#define MURK_BLOCK    128
#define MURK_NO_TABLE UINT32_MAX

typedef struct murk_brick_cell {
    int32_t at[3];  /* lowest voxel, in units of the edge */
    uint16_t level; /* into murk_level_shift */
    bool is_taken, is_parent;
    float bound; /* bound of the whole cell */
    uint32_t
        table; /* number of the table of a block's bricks, or MURK_NO_TABLE */
} murk_brick_cell;

struct murk_bricks {
    int edge_shift; /* log2 of the edge of a brick */
    int below, above;
    murk_brick_cell *slot; /* hash table, open addressing */
    size_t n_slots, n_taken;
    float *bound; /* tables of bricks, x slowest */
    size_t n_tables, tables_capacity;
};

static inline size_t murk_table_size(const murk_bricks *b)
{
    const size_t side = (size_t)MURK_BLOCK >> b->edge_shift;
    return side * side * side;
}

/* Index of a brick in the table of the block. */
static inline size_t murk_brick_in_block(int shift, const int32_t voxel[3])
{
    const size_t x = (size_t)((voxel[0] & (MURK_BLOCK - 1)) >> shift);
    const size_t y = (size_t)((voxel[1] & (MURK_BLOCK - 1)) >> shift);
    const size_t z = (size_t)((voxel[2] & (MURK_BLOCK - 1)) >> shift);
    const int side = 7 - shift;
    return (x << (2 * side)) | (y << side) | z;
}

/* Hash of a cell: multiplication by odd constants, high bits (Knuth, The Art
 * of Computer Programming 3, 2nd ed., 6.4). The constants are those of
 * splitmix64 (Steele, Lea and Flood, OOPSLA 2014,
 * doi:10.1145/2660193.2660195). */
static inline size_t murk_first_slot(const murk_bricks *b, int level,
                                     const int32_t at[3])
{
    uint64_t h = (uint32_t)at[0] * UINT64_C(0x9e3779b97f4a7c15);
    h = (h ^ (uint32_t)at[1]) * UINT64_C(0xbf58476d1ce4e5b9);
    h = (h ^ (uint32_t)at[2]) * UINT64_C(0x94d049bb133111eb);
    h = (h ^ (uint32_t)level) * UINT64_C(0x9e3779b97f4a7c15);
    return (size_t)(h >> 32) & (b->n_slots - 1);
}

/* The slot of the cell that contains the voxel at this level, or the free slot
 * in which that cell would be stored. */
static inline murk_brick_cell *murk_slot_of(const murk_bricks *b, int level,
                                            const int32_t voxel[3])
{
    const int32_t at[3] = {voxel[0] >> murk_level_shift[level],
                           voxel[1] >> murk_level_shift[level],
                           voxel[2] >> murk_level_shift[level]};
    size_t i = murk_first_slot(b, level, at);
    for (;; i = (i + 1) & (b->n_slots - 1)) {
        murk_brick_cell *c = &b->slot[i];
        if (!c->is_taken || (c->at[0] == at[0] && c->at[1] == at[1] &&
                             c->at[2] == at[2] && c->level == level)) {
            return c;
        }
    }
}

/* The bound around a voxel: either a table of the bricks of a block, where the
 * bound of a brick is the larger of the entry and `bound`, or (table NULL) one
 * bound for a cell with an edge of 1 << shift voxels. With a table `shift` is
 * that of a brick. */
typedef struct murk_brick_bound {
    const float *table;
    float bound;
    int shift;
} murk_brick_bound;

static inline murk_brick_bound murk_bricks_lookup(const murk_bricks *b,
                                                  const int32_t voxel[3])
{
    float bound = 0;
    for (int l = MURK_BRICK_LEVELS - 1;; --l) {
        const murk_brick_cell *c = murk_slot_of(b, l, voxel);
        if (c->is_taken) {
            bound = bound < c->bound ? c->bound : bound;
            if (c->table != MURK_NO_TABLE) {
                return (murk_brick_bound){b->bound +
                                              c->table * murk_table_size(b),
                                          bound, b->edge_shift};
            }
        }
        if (!c->is_parent) {
            return (murk_brick_bound){NULL, bound, murk_level_shift[l]};
        }
    }
}

#endif
