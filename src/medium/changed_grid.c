/* Compares two trees from the root down to the values of the leaves. Buffers
 * of equal grids may differ in bytes that hold no value, so they are not
 * compared as a whole. A walk sums up cell by cell, so a constant cell differs
 * from a node whose cells all have its value. */
#include "medium/changed_grid.h"

#include "medium/leaf_table.h"
#include "medium/nodes.h"

#include <string.h>

/* Voxels along an edge of the cells of each level, from a cell of the root to a
 * leaf. */
static const int32_t EDGE[] = {MURK_ROOT_CELL, 128, MURK_LEAF_EDGE};
#define LEAF_LEVEL 2

/* The cell of a node of the level that contains the voxel. */
static murk_cell part_of(const murk_cell *cell, int level,
                         const int32_t voxel[3])
{
    return level == 0 ? murk_upper_cell(cell->child, voxel)
                      : murk_lower_cell(cell->child, voxel);
}

/* True if the values of two leaves are equal. */
static bool are_same_leaves(const murk_cell *a, const murk_cell *b)
{
    return memcmp(murk_leaf_values(a->child), murk_leaf_values(b->child),
                  MURK_LEAF_VOXELS * sizeof(float)) == 0;
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
    if (!a->child || !b->child) {
        if (a->child || b->child || a->value != b->value) {
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

void murk_changed_cells(murk_box_list *changed, const murk_tree *a,
                        const murk_tree *b)
{
    /* Walks count the cells of the root. */
    bool have_same_roots = a->n_cells == b->n_cells;
    for (size_t i = 0; i < a->n_cells && have_same_roots; ++i) {
        have_same_roots = memcmp(a->cells[i].first, b->cells[i].first,
                                 sizeof a->cells[i].first) == 0;
    }
    changed->are_all = changed->are_all || !have_same_roots;
    for (size_t i = 0; i < a->n_cells && have_same_roots; ++i) {
        const murk_cell p = {a->cells[i].node, a->cells[i].value},
                        q = {b->cells[i].node, b->cells[i].value};
        compare_cells(changed, &p, &q, 0, a->cells[i].first);
    }
}
