/* Upper bounds of a grid's density, brick by brick: what delta tracking flies
 * by.
 *
 * A brick is a cube of voxels, aligned to its edge, a power of two. There are
 * bricks only where the tree holds something, in blocks of 128 voxels; all
 * else is bounded by 0, in cells that grow with the emptiness, so that a ray
 * crosses it in a few steps. What the tree holds as one value over a large
 * cell is bounded as a whole, with the cells beside it where values are seen
 * from there. Memory is at most a few times the tree's own.
 *
 * Space and ray parameter are those of march.h. Immutable after creation.
 * Inside this room only. */
#ifndef MURK_MEDIUM_BRICKS_H
#define MURK_MEDIUM_BRICKS_H

#include "base/status.h"
#include "base/vector.h"
#include "medium/tree.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_BRICK_EDGE_MIN 8
#define MURK_BRICK_EDGE_MAX 128

typedef struct murk_bricks murk_bricks;

/* edge: a power of two, MURK_BRICK_EDGE_MIN..MAX. At a point in voxel i count
 * the values of voxels i - below to i + above along each axis, below and above
 * 0 or 1 (0 and 0: nearest). *out is the caller's: murk_bricks_destroy().
 * Fails with MURK_NO_MEMORY at `where`. */
murk_status murk_bricks_create(murk_bricks **out, const murk_tree *tree,
                               int32_t edge, int below, int above,
                               const char *where, murk_error *err);
void murk_bricks_destroy(murk_bricks *bricks); /* NULL is fine */

/* The bound at a voxel. */
float murk_bricks_bound(const murk_bricks *bricks, const int32_t voxel[3]);

typedef struct murk_bricks_facts {
    double volume; /* that is not bounded by 0 [voxels] */
    double sum;    /* of bound times volume [density * voxels] */
    size_t memory_bytes;
} murk_bricks_facts;

murk_bricks_facts murk_bricks_describe(const murk_bricks *bricks);

/* A ray through the bricks: one segment of constant bound after the other. */
typedef struct murk_brick_walk {
    const murk_bricks *bricks;
    double origin[3], direction[3], inverse[3]; /* inverse 0: parallel */
    double end;

    /* The present segment [from, to) and its bound. */
    double from, to, bound;

    int32_t at[3]; /* the voxel where the next segment begins */

    /* The block last met; the least that its bounds are. */
    const float *block;
    float block_min;
    int32_t block_first[3];
} murk_brick_walk;

/* Sets out from t0 to t1, both from murk_march_clip() or between such. */
void murk_brick_walk_begin(murk_brick_walk *walk, const murk_bricks *bricks,
                           murk_vec3 origin, murk_vec3 direction, double t0,
                           double t1);

/* The next segment; false at the end. Segments join without gaps and some may
 * have no length. */
bool murk_brick_walk_next(murk_brick_walk *walk);

#endif
