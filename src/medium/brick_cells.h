/* How the bounds of bricks.h are kept: cells of 128, 4096, ... voxels in one
 * hash table; a cell that has smaller ones in it is their parent. The bound of
 * a cell holds all over it, so the bound at a voxel is the largest on the way
 * down from the top: a large value can be noted at a parent without a look at
 * what lies below. Only bricks.c and brick_walk.c need to know. */
#ifndef MURK_MEDIUM_BRICK_CELLS_H
#define MURK_MEDIUM_BRICK_CELLS_H

#include "medium/bricks.h"

/* log2 of the edges of cells, smallest first: blocks, the tree's root cells,
 * and so on by 32 up to where a few cells span all indices. */
#define MURK_BRICK_LEVELS 5
static const int murk_level_shift[MURK_BRICK_LEVELS] = {7, 12, 17, 22, 27};

#define MURK_BLOCK    128
#define MURK_NO_TABLE UINT32_MAX

typedef struct murk_brick_cell {
    int32_t at[3];  /* its lowest voxel, in edges */
    uint16_t level; /* into murk_level_shift */
    bool is_taken, is_parent;
    float bound;    /* all over it */
    uint32_t table; /* of a block's bricks, or MURK_NO_TABLE */
} murk_brick_cell;

struct murk_bricks {
    int edge_shift; /* log2 of a brick's edge */
    int below, above;
    murk_brick_cell *slot; /* hash table, open addressing */
    size_t n_slots, n_taken;
    float *bound; /* tables of bricks, x slowest */
    size_t n_tables, tables_room;
};

static inline size_t murk_table_size(const murk_bricks *b)
{
    const size_t side = (size_t)MURK_BLOCK >> b->edge_shift;
    return side * side * side;
}

/* A brick's place in the table of its block. */
static inline size_t murk_brick_in_block(int shift, const int32_t voxel[3])
{
    const size_t x = (size_t)((voxel[0] & (MURK_BLOCK - 1)) >> shift);
    const size_t y = (size_t)((voxel[1] & (MURK_BLOCK - 1)) >> shift);
    const size_t z = (size_t)((voxel[2] & (MURK_BLOCK - 1)) >> shift);
    const int side = 7 - shift;
    return (x << (2 * side)) | (y << side) | z;
}

/* Multiplies by odd constants and takes the high bits (Knuth, The Art of
 * Computer Programming 3, 2nd ed., 6.4). */
static inline size_t murk_first_slot(const murk_bricks *b, int level,
                                     const int32_t at[3])
{
    uint64_t h = (uint32_t)at[0] * UINT64_C(0x9e3779b97f4a7c15);
    h = (h ^ (uint32_t)at[1]) * UINT64_C(0xbf58476d1ce4e5b9);
    h = (h ^ (uint32_t)at[2]) * UINT64_C(0x94d049bb133111eb);
    h = (h ^ (uint32_t)level) * UINT64_C(0x9e3779b97f4a7c15);
    return (size_t)(h >> 32) & (b->n_slots - 1);
}

/* The slot of the cell, or the free one where it belongs. */
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

/* What bounds the values around a voxel: a table of bricks (their bounds at
 * least `bound`), or (NULL) one bound in a cell of 1 << shift. */
typedef struct murk_brick_sight {
    const float *table;
    float bound;
    int shift;
} murk_brick_sight;

static inline murk_brick_sight murk_bricks_look(const murk_bricks *b,
                                                const int32_t voxel[3])
{
    float bound = 0;
    for (int l = MURK_BRICK_LEVELS - 1;; --l) {
        const murk_brick_cell *c = murk_slot_of(b, l, voxel);
        if (c->is_taken) {
            bound = bound < c->bound ? c->bound : bound;
            if (c->table != MURK_NO_TABLE) {
                return (murk_brick_sight){b->bound +
                                              c->table * murk_table_size(b),
                                          bound, b->edge_shift};
            }
        }
        if (!c->is_parent) {
            return (murk_brick_sight){NULL, bound, murk_level_shift[l]};
        }
    }
}

#endif
