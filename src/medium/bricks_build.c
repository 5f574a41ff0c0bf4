/* Computes the bounds of bricks from the tree of a grid (medium/bricks.h):
 * every leaf and tile raises the bounds of the bricks, or larger cells, in
 * which the interpolation reads values of that leaf or tile. Functions that
 * return bool or a pointer fail only if there is no memory. */
#include "medium/bricks.h"

#include "medium/brick_cells.h"
#include "medium/nodes.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_SLOTS 64 /* initial size of the hash table; a power of two */

/* Doubles the hash table. */
static bool grow(murk_bricks *b)
{
    murk_bricks larger = *b;
    larger.n_slots = b->n_slots ? 2 * b->n_slots : FIRST_SLOTS;
    larger.slot = calloc(larger.n_slots, sizeof *larger.slot);
    if (!larger.slot) {
        return false;
    }
    for (size_t i = 0; i < b->n_slots; ++i) {
        const murk_brick_cell *c = &b->slot[i];
        if (c->is_taken) {
            const int shift = murk_level_shift[c->level];
            const int32_t voxel[3] = {c->at[0] * (1 << shift),
                                      c->at[1] * (1 << shift),
                                      c->at[2] * (1 << shift)};
            *murk_slot_of(&larger, c->level, voxel) = *c;
        }
    }
    free(b->slot);
    *b = larger;
    return true;
}

/* The cell at a level that contains a voxel; creates the cell and all parents
 * of it if needed. NULL without memory. The pointer is valid until the next
 * call. */
static murk_brick_cell *cell_at(murk_bricks *b, int level,
                                const int32_t voxel[3])
{
    for (int l = MURK_BRICK_LEVELS - 1;; --l) {
        if (2 * (b->n_taken + 1) > b->n_slots && !grow(b)) {
            return NULL;
        }
        murk_brick_cell *c = murk_slot_of(b, l, voxel);
        if (!c->is_taken) {
            *c = (murk_brick_cell){.at = {voxel[0] >> murk_level_shift[l],
                                          voxel[1] >> murk_level_shift[l],
                                          voxel[2] >> murk_level_shift[l]},
                                   .level = (uint16_t)l,
                                   .is_taken = true,
                                   .table = MURK_NO_TABLE};
            ++b->n_taken;
        }
        if (l == level) {
            return c;
        }
        c->is_parent = true;
    }
}

/* The table of bricks of the block around a voxel; creates it if needed.
 * NULL without memory. The pointer is valid until the next call. */
static float *table_at(murk_bricks *b, const int32_t voxel[3])
{
    murk_brick_cell *block = cell_at(b, 0, voxel);
    if (!block) {
        return NULL;
    }
    const size_t size = murk_table_size(b);
    if (block->table == MURK_NO_TABLE) {
        if (b->n_tables == b->tables_capacity) {
            const size_t capacity =
                b->tables_capacity + b->tables_capacity / 2 + 8;
            float *bound = realloc(b->bound, capacity * size * sizeof *bound);
            if (!bound) {
                return NULL;
            }
            b->bound = bound;
            b->tables_capacity = capacity;
        }
        block->table = (uint32_t)b->n_tables++;
        memset(b->bound + block->table * size, 0, size * sizeof *b->bound);
    }
    return b->bound + block->table * size;
}

static void raise(float *bound, float value)
{
    *bound = *bound < value ? value : *bound;
}

/* Raises the bounds of all bricks that overlap the inclusive box of voxels,
 * which spans at most two bricks along an axis. */
static bool raise_bricks(murk_bricks *b, const int32_t first[3],
                         const int32_t last[3], float value)
{
    const int s = b->edge_shift;
    for (int corner = 0; corner < 8; ++corner) {
        int32_t voxel[3];
        bool is_new = true;
        for (int axis = 0; axis < 3; ++axis) {
            const bool far = corner >> axis & 1;
            voxel[axis] = far ? last[axis] : first[axis];
            is_new &= !far || last[axis] >> s != first[axis] >> s;
        }
        if (is_new) {
            float *table = table_at(b, voxel);
            if (!table) {
                return false;
            }
            raise(&table[murk_brick_in_block(s, voxel)], value);
        }
    }
    return true;
}

/* 0 for the first, 1 for a middle, 2 for the last of the eight layers of a
 * leaf. */
static inline int part_of_leaf(int layer)
{
    return layer == 0 ? 0 : layer == 7 ? 2 : 1;
}

/* Adds a leaf of 8 x 8 x 8 voxels. Interpolation reads values at most one voxel
 * away, so of the values of a leaf only the outer layers count outside of it.
 * The maximum is therefore taken separately for 27 parts of the leaf: corners,
 * edges, faces and the inside. */
static bool add_leaf(murk_bricks *b, const int32_t at[3], const float *value)
{
    static const int part_first[3] = {0, 1, 7}, part_last[3] = {0, 6, 7};
    float max[3][3][3] = {{{0}}};
    /* The maximum of each part. */
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            float *row = max[part_of_leaf(i)][part_of_leaf(j)];
            for (int k = 0; k < 8; ++k, ++value) {
                raise(&row[part_of_leaf(k)], *value);
            }
        }
    }
    /* Each part raises the bricks that it touches, enlarged by the reach of
     * the interpolation. */
    for (int n = 0; n < 27; ++n) {
        const int part[3] = {n / 9, n / 3 % 3, n % 3};
        const float value_here = max[part[0]][part[1]][part[2]];
        int32_t first[3], last[3];
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = at[axis] + part_first[part[axis]] - b->above;
            last[axis] = at[axis] + part_last[part[axis]] + b->below;
        }
        if (value_here > 0 && !raise_bricks(b, first, last, value_here)) {
            return false;
        }
    }
    return true;
}

static bool add_small_tile(murk_bricks *b, const int32_t at[3], float value)
{
    float leaf[512];
    for (int i = 0; i < 512; ++i) {
        leaf[i] = value;
    }
    return add_leaf(b, at, leaf);
}

/* Adds a tile of the size of a block or a root cell: raises the bound of its
 * cell, and of those neighbouring cells of the same size in which the
 * interpolation reads the tile. A tile of value 0 changes nothing. */
static bool add_large_tile(murk_bricks *b, int level, const int32_t at[3],
                           float value)
{
    const int32_t size = 1 << murk_level_shift[level];
    for (int n = 0; value > 0 && n < 27; ++n) {
        const int32_t step[3] = {n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
        int32_t voxel[3];
        bool sees = true;
        for (int axis = 0; axis < 3; ++axis) {
            voxel[axis] = at[axis] + step[axis] * size;
            sees &=
                step[axis] == 0 || (step[axis] < 0 ? b->above : b->below) > 0;
        }
        if (sees) {
            murk_brick_cell *c = cell_at(b, level, voxel);
            if (!c) {
                return false;
            }
            raise(&c->bound, value);
        }
    }
    return true;
}

/* The lowest voxel of the n-th (n = 0, 1, ...) of side^3 cells of the given
 * edge, the first of which has the lowest voxel `first`. */
static void nth_cell(const int32_t first[3], int n, int side, int32_t edge,
                     int32_t at[3])
{
    at[0] = first[0] + n / (side * side) * edge;
    at[1] = first[1] + n / side % side * edge;
    at[2] = first[2] + n % side * edge;
}

static bool add_lower(murk_bricks *b, const unsigned char *node,
                      const int32_t first[3])
{
    for (int n = 0; n < 16 * 16 * 16; ++n) {
        int32_t at[3];
        nth_cell(first, n, 16, 8, at);
        const murk_cell c = murk_lower_cell(node, at);
        const bool added = c.child ? add_leaf(b, at, murk_leaf_values(c.child))
                           : c.value > 0 ? add_small_tile(b, at, c.value)
                                         : true;
        if (!added) {
            return false;
        }
    }
    return true;
}

static bool add_upper(murk_bricks *b, const unsigned char *node,
                      const int32_t first[3])
{
    for (int n = 0; n < 32 * 32 * 32; ++n) {
        int32_t at[3];
        nth_cell(first, n, 32, MURK_BLOCK, at);
        const murk_cell c = murk_upper_cell(node, at);
        if (!(c.child ? add_lower(b, c.child, at)
                      : add_large_tile(b, 0, at, c.value))) {
            return false;
        }
    }
    return true;
}

static bool add_tree(murk_bricks *b, const murk_tree *tree)
{
    for (size_t i = 0; i < tree->n_cells; ++i) {
        const murk_root_cell *c = &tree->cells[i];
        if (!(c->node ? add_upper(b, c->node, c->first)
                      : add_large_tile(b, 1, c->first, c->value))) {
            return false;
        }
    }
    return true;
}

murk_status murk_bricks_create(murk_bricks **out, const murk_tree *tree,
                               int32_t edge, int below, int above,
                               const char *where, murk_error *err)
{
    assert(edge >= MURK_BRICK_EDGE_MIN && edge <= MURK_BRICK_EDGE_MAX);
    assert((edge & (edge - 1)) == 0);
    assert(below >= 0 && below <= 1 && above >= 0 && above <= 1);
    murk_bricks *b = calloc(1, sizeof *b);
    if (b) {
        b->below = below;
        b->above = above;
        while (1 << b->edge_shift < edge) {
            ++b->edge_shift;
        }
    }
    if (!b || !grow(b) || !add_tree(b, tree)) {
        murk_bricks_destroy(b);
        return murk_no_memory(err, where, "for the bounds of a grid's bricks");
    }
    *out = b;
    return MURK_OK;
}

void murk_bricks_destroy(murk_bricks *bricks)
{
    if (bricks) {
        free(bricks->slot);
        free(bricks->bound);
        free(bricks);
    }
}
