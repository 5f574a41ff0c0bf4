/* The table of the leaves of a tree (medium/leaf_table.h). */
#include "medium/leaf_table.h"

#include <stdlib.h>

#include "medium/nodes.h"

/* Entries for each leaf: the table takes at most a 32nd of the memory of the
 * leaves, and a small one is made for any grid. */
#define ENTRIES_PER_LEAF 8
#define FEW_ENTRIES      4096

const float murk_no_leaf[MURK_LEAF_VOXELS];

static int32_t leaf_first(int32_t voxel)
{
    return voxel & ~(MURK_LEAF_EDGE - 1);
}

/* The number of leaves of a tree. */
static size_t count_leaves(const unsigned char *buffer)
{
    const pnanovdb_buf_t words = murk_node_buffer(buffer);
    const pnanovdb_grid_handle_t grid = {{0}};
    return pnanovdb_tree_get_node_count_leaf(
        words, pnanovdb_grid_get_tree(words, grid));
}

murk_leaf_table murk_leaf_table_made(const murk_tree *tree,
                                     const unsigned char *buffer)
{
    murk_leaf_table table = {0};
    size_t count[3], entries = 1;
    if (tree->n_cells == 0) {
        return table;
    }
    /* The size of the table. */
    const size_t maximum =
        ENTRIES_PER_LEAF * count_leaves(buffer) + FEW_ENTRIES;
    for (int axis = 0; axis < 3; ++axis) {
        const int32_t first = leaf_first(tree->first[axis]) - MURK_LEAF_EDGE;
        const int32_t last = leaf_first(tree->last[axis]) + MURK_LEAF_EDGE;
        count[axis] = (size_t)((int64_t)last - first) / MURK_LEAF_EDGE + 1;
        table.first[axis] = first;
        if (count[axis] > maximum / entries) {
            return table;
        }
        entries *= count[axis];
    }
    table.stride[0] = (ptrdiff_t)(count[1] * count[2]);
    table.stride[1] = (ptrdiff_t)count[2];
    table.stride[2] = 1;
    table.leaf = calloc(entries, sizeof *table.leaf);
    if (!table.leaf) {
        return table;
    }
    /* Look up each leaf. */
    murk_tree_cursor cursor = {.tree = tree};
    for (size_t i = 0; i < entries; ++i) {
        const size_t cell[3] = {i / (count[1] * count[2]),
                                i / count[2] % count[1], i % count[2]};
        int32_t voxel[3];
        for (int axis = 0; axis < 3; ++axis) {
            voxel[axis] =
                table.first[axis] + (int32_t)cell[axis] * MURK_LEAF_EDGE;
        }
        const murk_tree_node node = murk_tree_node_at(&cursor, voxel);
        table.leaf[i] = node.leaf ? node.leaf : murk_no_leaf;
    }
    return table;
}

void murk_leaf_table_release(murk_leaf_table *table)
{
    free(table->leaf);
    *table = (murk_leaf_table){0};
}
