/* Makes the blocks of cells of a grid (medium/linear_blocks.h): finds the
 * leaves of the tree, enters the up to eight blocks in which each leaf takes
 * part, and copies their values. Functions that return bool fail only if there
 * is no memory. */
#include "medium/linear_blocks.h"

#include "medium/nodes.h"

#include <stdlib.h>
#include <string.h>

#define EDGE 8 /* cells of a block, and voxels of a leaf, along an axis */

#define FIRST_SHIFT 54 /* of the hash table: 1024 slots */

/* ---- the list of blocks ---- */

/* Doubles the hash table, or makes the first one. */
static bool grow_slots(murk_linear_blocks *b)
{
    murk_linear_blocks larger = *b;
    larger.shift = b->slot ? b->shift - 1 : FIRST_SHIFT;
    const size_t n_slots = (size_t)1 << (64 - larger.shift);
    larger.slot_mask = n_slots - 1;
    larger.slot = calloc(n_slots, sizeof *larger.slot);
    if (!larger.slot) {
        return false;
    }
    for (size_t i = 0; i < b->n; ++i) {
        *murk_linear_slot(&larger, b->block[i].first) = (uint32_t)i + 1;
    }
    free(b->slot);
    *b = larger;
    return true;
}

/* Enters the block around a cell. */
static bool add_block(murk_linear_blocks *b, const int32_t first[3],
                      size_t *capacity)
{
    if (2 * (b->n + 1) > b->slot_mask && !grow_slots(b)) {
        return false;
    }
    uint32_t *slot = murk_linear_slot(b, first);
    if (*slot > 0) {
        return true;
    }
    if (b->n == *capacity) {
        const size_t larger = *capacity + *capacity / 2 + 16;
        murk_linear_block *block =
            larger <= UINT32_MAX ? realloc(b->block, larger * sizeof *block)
                                 : NULL;
        if (!block) {
            return false;
        }
        b->block = block;
        *capacity = larger;
    }
    memcpy(b->block[b->n].first, first, sizeof b->block[b->n].first);
    *slot = (uint32_t)++b->n;
    return true;
}

/* Enters the blocks in which the leaf at first[] takes part: its own, and those
 * below it along each axis. */
static bool add_leaf(murk_linear_blocks *b, const int32_t first[3],
                     size_t *capacity)
{
    bool is_added = true;
    for (int which = 0; which < 8 && is_added; ++which) {
        const int32_t at[3] = {first[0] - (which >> 2) * EDGE,
                               first[1] - (which >> 1 & 1) * EDGE,
                               first[2] - (which & 1) * EDGE};
        is_added = add_block(b, at, capacity);
    }
    return is_added;
}

/* ---- the leaves of the tree ---- */

/* The lowest voxel of cell n of side^3 cells with the given edge. */
static void find_cell(const int32_t first[3], int n, int side, int32_t edge,
                      int32_t at[3])
{
    at[0] = first[0] + n / (side * side) * edge;
    at[1] = first[1] + n / side % side * edge;
    at[2] = first[2] + n % side * edge;
}

static bool add_lower(murk_linear_blocks *b, const unsigned char *node,
                      const int32_t first[3], size_t *capacity)
{
    bool is_added = true;
    for (int n = 0; n < 16 * 16 * 16 && is_added; ++n) {
        int32_t at[3];
        find_cell(first, n, 16, EDGE, at);
        is_added =
            !murk_lower_cell(node, at).child || add_leaf(b, at, capacity);
    }
    return is_added;
}

static bool add_upper(murk_linear_blocks *b, const unsigned char *node,
                      const int32_t first[3], size_t *capacity)
{
    bool is_added = true;
    for (int n = 0; n < 32 * 32 * 32 && is_added; ++n) {
        int32_t at[3];
        find_cell(first, n, 32, 16 * EDGE, at);
        const unsigned char *lower = murk_upper_cell(node, at).child;
        is_added = !lower || add_lower(b, lower, at, capacity);
    }
    return is_added;
}

static bool add_tree(murk_linear_blocks *b, const murk_tree *tree)
{
    size_t capacity = 0;
    bool is_added = grow_slots(b);
    for (size_t i = 0; i < tree->n_cells && is_added; ++i) {
        const murk_root_cell *cell = &tree->cells[i];
        is_added =
            !cell->node || add_upper(b, cell->node, cell->first, &capacity);
    }
    return is_added;
}

/* ---- values ---- */

/* Copies the part of a node that is in the block. `which` is the number of the
 * node, 4 x + 2 y + z, and the node begins 8 x, 8 y, 8 z voxels beyond the
 * lowest voxel of the block. */
static void copy_node(float *value, int which, const murk_tree_node *node)
{
    const int x0 = which >> 2, y0 = which >> 1 & 1, z0 = which & 1;
    const int nx = x0 ? 1 : EDGE, ny = y0 ? 1 : EDGE, nz = z0 ? 1 : EDGE;
    for (int x = 0; x < nx; ++x) {
        for (int y = 0; y < ny; ++y) {
            float *to =
                &value[MURK_CELL_AT(x + EDGE * x0, y + EDGE * y0, EDGE * z0)];
            for (int z = 0; z < nz; ++z) {
                to[z] =
                    node->leaf ? node->leaf[x << 6 | y << 3 | z] : node->value;
            }
        }
    }
}

/* True if a corner of the cell is not 0. */
static bool is_filled(const float *corner)
{
    bool is_above = false;
    for (int i = 0; i < 8; ++i) {
        is_above |= corner[MURK_CELL_AT(i >> 2, i >> 1 & 1, i & 1)] != 0;
    }
    return is_above;
}

static void fill_block(murk_linear_block *block, float *value,
                       murk_tree_cursor *cursor)
{
    /* The values, and whether the first node is a leaf. */
    for (int which = 0; which < 8; ++which) {
        const int32_t voxel[3] = {block->first[0] + (which >> 2) * EDGE,
                                  block->first[1] + (which >> 1 & 1) * EDGE,
                                  block->first[2] + (which & 1) * EDGE};
        const murk_tree_node node = murk_tree_node_at(cursor, voxel);
        copy_node(value, which, &node);
        block->has_leaf = which == 0 ? node.leaf != NULL : block->has_leaf;
    }
    /* The cells that are not 0. */
    memset(block->filled, 0, sizeof block->filled);
    for (int i = 0; i < EDGE * EDGE * EDGE; ++i) {
        const size_t at = (size_t)MURK_CELL_AT(i >> 6, i >> 3 & 7, i & 7);
        block->filled[at / 64] |= (uint64_t)is_filled(&value[at]) << (at % 64);
    }
}

murk_status murk_linear_blocks_make(murk_linear_blocks *blocks,
                                    const murk_tree *tree, const char *where,
                                    murk_error *err)
{
    murk_linear_blocks made = {.tree = tree};
    if (!murk_lane_set_chosen(&made.set)) {
        made.set = MURK_LANES_BASELINE;
    }
    /* The blocks, and memory for their values. */
    bool is_made = add_tree(&made, tree);
    if (is_made && made.n > 0) {
        made.value = calloc(made.n * MURK_BLOCK_VALUES, sizeof *made.value);
        is_made = made.value != NULL;
    }
    if (!is_made) {
        murk_linear_blocks_release(&made);
        return murk_no_memory(err, where,
                              "for the linear interpolation of a grid");
    }
    /* The values. */
    murk_tree_cursor cursor = {.tree = tree};
    for (size_t i = 0; i < made.n; ++i) {
        murk_linear_block *block = &made.block[i];
        fill_block(block, murk_linear_values(&made, block), &cursor);
    }
    *blocks = made;
    return MURK_OK;
}

void murk_linear_blocks_release(murk_linear_blocks *blocks)
{
    free(blocks->block);
    free(blocks->value);
    free(blocks->slot);
    *blocks = (murk_linear_blocks){0};
}
