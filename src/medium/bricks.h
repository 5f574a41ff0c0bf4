/* Upper bounds (majorants) of a grid's density per brick, for delta tracking.
 *
 * A brick is a cube of voxels whose edge is a power of two, aligned to the
 * edge. Bricks exist only in those blocks of 128 voxels along an edge in which
 * the interpolation reads a value above 0 of a leaf, or of a tile of the size
 * of a leaf. Empty space has the bound 0, in cells that grow with the size of
 * the empty space, so that a ray crosses empty space in a few steps. A larger
 * tile (one value for a cell of the tree of 128 or 4096 voxels along an edge)
 * raises the bound of its whole cell, and of the whole neighbouring cells in
 * which the interpolation reads the tile. Memory is at most a few times that of
 * the tree.
 *
 * Space and ray parameter are those of medium/march.h for nearest-neighbour
 * interpolation, those of medium/linear.h for linear interpolation. Immutable
 * after creation.
 * For use inside src/medium only. */
#ifndef MURK_MEDIUM_BRICKS_H
#define MURK_MEDIUM_BRICKS_H

#include "medium/grid_ray.h"

#include <stddef.h>

/* The smallest and the largest edge of a brick in voxels: the edge of a leaf
 * and the edge of a block. */
#define MURK_BRICK_EDGE_MIN 8
#define MURK_BRICK_EDGE_MAX 128

typedef struct murk_bricks murk_bricks;

/* Computes the bounds. edge: a power of two, MURK_BRICK_EDGE_MIN..MAX. The
 * density at a point in voxel i depends on the values of voxels i - below to
 * i + above along each axis; below and above are 0 or 1 (0 and 0: nearest
 * neighbour). The caller owns *out and releases it with
 * murk_bricks_destroy(). Fails with MURK_NO_MEMORY at `where`. */
murk_status murk_bricks_create(murk_bricks **out, const murk_tree *tree,
                               int32_t edge, int below, int above,
                               const char *where, murk_error *err);
void murk_bricks_destroy(murk_bricks *bricks); /* NULL is fine */

/* A ray through the bricks: one segment of constant bound after the other. */
typedef struct murk_brick_walk {
    const murk_bricks *bricks;
    murk_grid_ray ray;
    double bound; /* on the current segment */

    /* The table of bounds of the block visited last (NULL: that block has no
     * bricks, or there is none yet), a lower limit of the bounds of its bricks,
     * and the lowest voxel of the block. */
    const float *block;
    float block_min;
    int32_t block_first[3];
} murk_brick_walk;

/* Starts a walk from t0 to t1, which lie in the interval of
 * murk_grid_clip(). */
void murk_brick_walk_begin(murk_brick_walk *walk, const murk_bricks *bricks,
                           murk_vec3 origin, murk_vec3 direction, double t0,
                           double t1);

/* Advances to the next segment; false at the end. Segments join without
 * gaps, and some may have length 0. */
bool murk_brick_walk_next(murk_brick_walk *walk);

#endif
