/* Compares two trees from the root down to the values of the leaves. Buffers
 * of equal grids may differ in bytes that hold no value, so they are not
 * compared as a whole. */
#include "medium/changed_grid.h"

#include "medium/leaf_table.h"
#include "medium/nodes.h"

#include <string.h>

/* Voxels along an edge of the cells of each level, from a cell of the root to a
 * leaf. */
static const int32_t EDGE[] = {MURK_ROOT_CELL, 128, MURK_LEAF_EDGE};
#define LEAF_LEVEL 2

/* The cell of a node of the level that contains the voxel; a constant cell
 * consists of constant cells. */
static murk_cell part_of(const murk_cell *cell, int level,
                         const int32_t voxel[3])
{
    return !cell->child ? *cell
           : level == 0 ? murk_upper_cell(cell->child, voxel)
                        : murk_lower_cell(cell->child, voxel);
}

/* True if the values of two leaves, one of which may be constant, are equal. */
static bool are_same_leaves(const murk_cell *a, const murk_cell *b)
{
    const float *p = a->child ? murk_leaf_values(a->child) : NULL,
                *q = b->child ? murk_leaf_values(b->child) : NULL;
    if (p && q) {
        return memcmp(p, q, MURK_LEAF_VOXELS * sizeof *p) == 0;
    }
    const float *values = p ? p : q, other = p ? b->value : a->value;
    bool are_same = true;
    for (int i = 0; i < MURK_LEAF_VOXELS && are_same; ++i) {
        are_same = values[i] == other;
    }
    return are_same;
}

static void add_cell(murk_box_list *changed, const int32_t first[3],
                     int32_t edge)
{
    const murk_vec3 min = {first[0], first[1], first[2]};
    murk_box_list_add(
        changed, (murk_box){min, murk_add(min, murk_vec(edge, edge, edge))});
}

static void compare_cells(murk_box_list *changed, const murk_cell *a,
                          const murk_cell *b, int level, const int32_t first[3])
{
    const int32_t edge = EDGE[level];
    if (!a->child && !b->child) {
        if (a->value != b->value) {
            add_cell(changed, first, edge);
        }
        return;
    }
    if (level == LEAF_LEVEL) {
        if (!are_same_leaves(a, b)) {
            add_cell(changed, first, edge);
        }
        return;
    }
    /* Compare the cells of which both consist. */
    const int32_t step = EDGE[level + 1];
    int32_t at[3];
    for (at[0] = first[0]; at[0] < first[0] + edge; at[0] += step) {
        for (at[1] = first[1]; at[1] < first[1] + edge; at[1] += step) {
            for (at[2] = first[2]; at[2] < first[2] + edge; at[2] += step) {
                const murk_cell p = part_of(a, level, at),
                                q = part_of(b, level, at);
                compare_cells(changed, &p, &q, level + 1, at);
            }
        }
    }
}

/* The cell of the root that begins at a voxel. */
static murk_cell root_cell(const murk_tree *tree, const int32_t first[3])
{
    const murk_root_cell *cell = murk_tree_root_cell(tree, first);
    return cell ? (murk_cell){cell->node, cell->value}
                : (murk_cell){NULL, tree->elsewhere};
}

void murk_changed_cells(murk_box_list *changed, const murk_tree *a,
                        const murk_tree *b)
{
    for (size_t i = 0; i < a->n_cells; ++i) {
        const int32_t *first = a->cells[i].first;
        const murk_cell p = root_cell(a, first), q = root_cell(b, first);
        compare_cells(changed, &p, &q, 0, first);
    }
    /* The cells that only the second tree has. */
    for (size_t i = 0; i < b->n_cells; ++i) {
        const int32_t *first = b->cells[i].first;
        if (!murk_tree_root_cell(a, first)) {
            const murk_cell p = root_cell(a, first), q = root_cell(b, first);
            compare_cells(changed, &p, &q, 0, first);
        }
    }
}
