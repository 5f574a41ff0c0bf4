/* A NanoVDB float tree, opened for walks: cells with edges of 4096, 128, 8 and
 * 1 voxels. A cell that is larger than a voxel may have one constant value
 * instead of smaller cells.
 *
 * For use inside src/medium only. Values of inactive voxels are 0 here, or
 * MURK_VDB_NO_ALBEDO in a grid of albedos. */
#ifndef MURK_MEDIUM_TREE_H
#define MURK_MEDIUM_TREE_H

#include "base/status.h"
#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_ROOT_CELL 4096               /* voxels along an edge */
#define MURK_INDEX_MAX (INT32_C(1) << 30) /* keeps cell ends inside int32_t */

/* One cell of the root, 4096 voxels along an edge: a constant, or a node with
 * children. */
typedef struct murk_root_cell {
    int32_t first[3];          /* lowest voxel */
    float value;               /* value of the cell if node is NULL */
    const unsigned char *node; /* the NanoVDB upper node */
} murk_root_cell;

typedef struct murk_tree {
    murk_root_cell *cells; /* sorted by first[]; owned */
    size_t n_cells;
    int32_t first[3], last[3]; /* box of active voxels, inclusive */
    float elsewhere; /* value outside of all cells: 0, or MURK_VDB_NO_ALBEDO */
} murk_tree;

/* A position in the tree: the node with an edge of 128 voxels that was visited
 * last. */
typedef struct murk_tree_cursor {
    const murk_tree *tree;
    const unsigned char *lower; /* NULL: none yet */
    int32_t lower_first[3];
} murk_tree_cursor;

/* True if at[] is in the cell with an edge of `size` voxels whose lowest voxel
 * is first[]. */
static inline bool murk_cell_contains(const int32_t first[3],
                                      const int32_t at[3], int32_t size)
{
    return (((first[0] ^ at[0]) | (first[1] ^ at[1]) | (first[2] ^ at[2])) &
            ~(size - 1)) == 0;
}

/* The lowest voxel of the cell with an edge of `size` voxels that contains
 * at[]. */
static inline void murk_cell_first(int32_t first[3], const int32_t at[3],
                                   int32_t size)
{
    for (int axis = 0; axis < 3; ++axis) {
        first[axis] = at[axis] & ~(size - 1);
    }
}

/* Opens a NanoVDB float grid that this program has made (and that is therefore
 * trusted). `buffer` must stay valid; NULL is an empty tree. first[] and last[]
 * are the box of active voxels; elsewhere: 0, or MURK_VDB_NO_ALBEDO. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_tree_open(murk_tree *tree, const unsigned char *buffer,
                           const int64_t first[3], const int64_t last[3],
                           float elsewhere, const char *where, murk_error *err);
void murk_tree_close(murk_tree *tree);

/* The root cell that contains the voxel; NULL if there is none. */
const murk_root_cell *murk_tree_root_cell(const murk_tree *tree,
                                          const int32_t voxel[3]);

/* The smallest node around a voxel: the 512 values of a leaf, or (leaf NULL)
 * one value for a cell of the tree with an edge of `size` voxels. */
typedef struct murk_tree_node {
    const float *leaf;
    float value;
    int32_t size;
} murk_tree_node;

/* Descends to the node that contains the voxel: from the cursor's node if that
 * node contains the voxel, else from the root. */
murk_tree_node murk_tree_node_at(murk_tree_cursor *cursor,
                                 const int32_t voxel[3]);

/* The index of a voxel in the values of the leaf that contains it. */
static inline int murk_offset_in_leaf(const int32_t voxel[3])
{
    return (voxel[0] & 7) << 6 | (voxel[1] & 7) << 3 | (voxel[2] & 7);
}

/* The value of a voxel; `elsewhere` outside of the tree. */
float murk_tree_value(const murk_tree *tree, const int32_t voxel[3]);

/* The voxel that contains p, and the position of p in it. False if p is not in
 * the box of active voxels, enlarged by `below` voxels at the low end of each
 * axis. */
bool murk_tree_voxel_at(const murk_tree *tree, int32_t below, murk_vec3 p,
                        int32_t voxel[3], double in[3]);

/* True if the tree is not empty and p (in index space shifted by one half) is
 * in the box of active voxels; *density is then the value there. */
bool murk_tree_density(const murk_tree *tree, murk_vec3 p, double *density);

/* The values at the corners of the cell between voxel[] and the next ones:
 * corner[4 x + 2 y + z]. */
void murk_tree_corners(const murk_tree *tree, const int32_t voxel[3],
                       double corner[8]);

#endif
