/* A tree of boxes over the blocks of a rectilinear grid (a bounding volume
 * hierarchy), so that a ray or a point looks at few of many blocks. A node
 * holds the boxes of all blocks below it, and the comparisons of a ray with a
 * box are monotonic in its faces, also in floating-point arithmetic; a node
 * that is passed over thus has no block that would be taken.
 *
 * For use inside src/medium only.
 *
 * Source: Kay & Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986,
 * doi:10.1145/15922.15916. */
#ifndef MURK_MEDIUM_BLOCK_TREE_H
#define MURK_MEDIUM_BLOCK_TREE_H

#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Blocks of a leaf: a choice. With 4, walks through 100 blocks take 1.8 times
 * as long, because more nodes are looked at. */
#define MURK_BLOCK_LEAF_MAX 8

/* Nodes that wait at once during a search: one for each level of the tree,
 * which halves up to 4096 blocks, and one more. */
#define MURK_BLOCK_STACK 16

typedef struct murk_block_node {
    murk_box box;
    uint32_t first; /* a leaf: of its blocks in `order`; otherwise the first of
                     * two nodes, which are neighbours */
    uint32_t n;     /* blocks of a leaf; 0: an inner node */
} murk_block_node;

typedef struct murk_block_tree {
    murk_block_node *node; /* [0] is the root */
    uint32_t *order;       /* [blocks]: numbers of blocks */
} murk_block_tree;

/* Builds the tree over n boxes, at least 1. box(context, i) is the i-th. The
 * caller releases *out with murk_block_tree_release(). False when out of
 * memory; nothing is to be released then. */
bool murk_block_tree_build(murk_block_tree *out, size_t n,
                           const murk_box *(*box)(const void *context,
                                                  size_t i),
                           const void *context);
void murk_block_tree_release(murk_block_tree *tree);

#endif
