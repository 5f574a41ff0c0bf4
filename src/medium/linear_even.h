/* The part of the trilinear walk (medium/linear.h) outside of leaves: the
 * largest box of cells whose corners belong to the same constant nodes is one
 * segment. Also finds the nodes of the tree for the rest of the walk.
 *
 * Inside this room only. */
#ifndef MURK_MEDIUM_LINEAR_EVEN_H
#define MURK_MEDIUM_LINEAR_EVEN_H

#include "medium/linear.h"
#include "medium/nodes.h"
#include "medium/steps.h"

#include <stdint.h>

/* A node: the 512 values of a leaf, or (leaf NULL) one value for a cell of
 * the tree with an edge of `size` voxels. */
typedef struct murk_linear_node {
    const float *leaf;
    float value;
    int32_t size;
} murk_linear_node;

/* The node that contains the voxel. */
static inline murk_linear_node murk_linear_node_at(murk_linear *m,
                                                   const int32_t voxel[3])
{
    const int32_t i = voxel[0], j = voxel[1], k = voxel[2];
    if (!(m->lower && murk_cell_contains(m->lower_first, voxel, 128))) {
        const murk_root_cell *root = murk_tree_root_cell(m->tree, voxel);
        if (!root || !root->node) {
            return (murk_linear_node){NULL, root ? root->value : 0,
                                      MURK_ROOT_CELL};
        }
        const murk_cell cell = murk_upper_cell(root->node, i, j, k);
        if (!cell.child) {
            return (murk_linear_node){NULL, cell.value, 128};
        }
        m->lower = cell.child;
        murk_cell_first(m->lower_first, voxel, 128);
    }
    const murk_cell cell = murk_lower_cell(m->lower, i, j, k);
    return cell.child ? (murk_linear_node){murk_leaf_values(cell.child), 0, 8}
                      : (murk_linear_node){NULL, cell.value, 8};
}

/* Crosses the segment that begins in the cell at[] and moves at[] beyond it.
 * False if a leaf takes part in that cell; then nothing changes. */
bool murk_linear_cross_even(murk_linear *linear);

#endif
