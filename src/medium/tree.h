/* A NanoVDB float tree, opened for marching: cells of 4096, 128, 8 and 1
 * voxels, of which all but the last may be one constant value.
 *
 * Inside this room only. Values that are not active are 0 here. */
#ifndef MURK_MEDIUM_TREE_H
#define MURK_MEDIUM_TREE_H

#include "base/status.h"
#include "base/vector.h"
#include "medium/grid.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_ROOT_CELL 4096               /* voxels along an edge */
#define MURK_INDEX_MAX (INT32_C(1) << 30) /* keeps cell ends inside int32_t */

/* One 4096-voxel cell of the root: a constant, or a node with children. */
typedef struct murk_root_cell {
    int32_t first[3];          /* its lowest voxel */
    float value;               /* where node is NULL */
    const unsigned char *node; /* the NanoVDB upper node */
} murk_root_cell;

typedef struct murk_tree {
    murk_root_cell *cells; /* sorted by first[]; owned */
    size_t n_cells;
    int32_t first[3], last[3]; /* box of active voxels, inclusive */
    float elsewhere;           /* where no cell is: 0, or no albedo */
} murk_tree;

/* Opens a NanoVDB float grid of our own making (so: trusted) in `buffer`,
 * which must stay. NULL buffer: an empty tree. */
murk_status murk_tree_open(murk_tree *tree, const unsigned char *buffer,
                           const int64_t first[3], const int64_t last[3],
                           const char *where, murk_error *err);
void murk_tree_close(murk_tree *tree);

/* The root cell that holds the voxel; NULL where there is none. */
const murk_root_cell *murk_tree_root_cell(const murk_tree *tree,
                                          const int32_t voxel[3]);

/* The value of a voxel; `elsewhere` where nothing is. */
float murk_tree_value(const murk_tree *tree, const int32_t voxel[3]);

/* Whether p (in index space shifted by a half) lies in the box of active
 * voxels, and the value there. */
bool murk_tree_density(const murk_tree *tree, murk_vec3 p, double *density);

/* The values at the corners of the cell between voxel[] and the next ones:
 * corner[4 x + 2 y + z]. */
void murk_tree_corners(const murk_tree *tree, const int32_t voxel[3],
                       double corner[8]);

/* A grid's tree. */
const murk_tree *murk_grid_tree(const murk_grid *grid);

#define MURK_VOXELS_MAX ((size_t)1 << 31)

/* Refuses an empty side and more than MURK_VOXELS_MAX; counts the voxels. */
murk_status murk_grid_check_size(const size_t size[3], size_t *voxels,
                                 const char *where, murk_error *err);

/* As murk_grid_from_samples(), which stores blocks of one value as tiles; here
 * voxel by voxel, too. */
murk_status murk_grid_make(murk_grid **out, const size_t size[3],
                           const float *density,
                           const murk_affine *index_to_world, bool as_tiles,
                           const char *where, murk_error *err);

#endif
