/* The leaves of a tree (medium/tree.h) by place: a table over the box of active
 * voxels and one leaf beyond it on each side, so that several rays find their
 * leaves at once. The table is left out if it would be large and have many more
 * entries than there are leaves. For use inside
 * src/medium only. */
#ifndef MURK_MEDIUM_LEAF_TABLE_H
#define MURK_MEDIUM_LEAF_TABLE_H

#include "medium/tree.h"

#include <stddef.h>
#include <stdint.h>

/* A leaf of NanoVDB has 8 voxels along an edge. */
#define MURK_LEAF_EDGE   8
#define MURK_LEAF_VOXELS 512 /* edge^3 */

typedef struct murk_leaf_table {
    const float **leaf;  /* [x][y][z]; NULL: no table */
    int32_t first[3];    /* the lowest voxel of the table */
    ptrdiff_t stride[3]; /* of the entries along each axis */
} murk_leaf_table;

/* The entry where a constant node, or nothing, is in place of a leaf. */
extern const float murk_no_leaf[MURK_LEAF_VOXELS];

/* Makes the table of a tree that was opened from the buffer. Without memory for
 * it the result is no table, and rays are followed one by one. */
murk_leaf_table murk_leaf_table_made(const murk_tree *tree,
                                     const unsigned char *buffer);
void murk_leaf_table_release(murk_leaf_table *table);

#endif
