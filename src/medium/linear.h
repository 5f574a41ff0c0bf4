/* Walk of a ray through a grid with trilinear interpolation.
 *
 * Coordinates are index space without a shift: voxel i is at the point i, cell
 * i lies between the voxels i and i + 1 along each axis, upper faces excluded.
 * The field falls to 0 in the cells around the box of active voxels. t is the
 * caller's ray parameter. Along a ray, the field in a cell is a cubic in t, so
 * the integral is exact: the length times the sum of the value in the middle
 * and 1/24 of the second derivative there, with respect to a parameter that
 * runs from 0 to 1 over the segment. A box of cells of any size, all corners of
 * which belong to the same constant nodes (tiles or empty cells of the tree),
 * is crossed in one segment.
 *
 * For use inside src/medium only.
 *
 * Source: the walk is that of march.h; the mean follows from the Taylor series
 * about the middle, of which a cubic has no terms that change the mean beyond
 * the second derivative. */
#ifndef MURK_MEDIUM_LINEAR_H
#define MURK_MEDIUM_LINEAR_H

#include "medium/cubic.h"
#include "medium/grid_ray.h"

/* The state of a walk. It contains pointers to itself: do not copy it after
 * it has begun. */
typedef struct murk_linear {
    murk_tree_cursor cursor;
    murk_grid_ray ray;

    /* The lowest point of the cell of the current segment and the values at the
     * corners (medium/cubic.h). If the cell is larger than a voxel along an
     * axis, the field does not depend on that axis. */
    double low[3], corner[8];
    double value; /* field at the collision of murk_linear_integrate() */

    /* In a block of 8 x 8 x 8 cells the corners are in up to eight nodes of the
     * tree: node 4 x + 2 y + z begins 8 x, 8 y, 8 z voxels beyond the lowest
     * voxel of the block. Each node is looked up when first needed, and the bit
     * of that number in `known` is then set. Node i is in the slot i ^ own,
     * which depends on the position of the node in the tree alone: so nodes
     * that the next block needs, too, stay in their slots. If a tile is there
     * instead of a leaf, values[] points to the single value in `tile`, and
     * offset_mask is 0, else all ones. */
    unsigned known, own;
    const float *values[8];
    unsigned offset_mask[8];
    float tile[8];
} murk_linear;

/* Starts a walk from t0 to t1, which lie in the interval of murk_grid_clip()
 * with 1 voxel below. */
void murk_linear_begin(murk_linear *linear, const murk_tree *tree,
                       murk_vec3 origin, murk_vec3 direction, double t0,
                       double t1);

/* Advances to the next segment; false at the end. Segments join without
 * gaps, and some have length 0. */
bool murk_linear_next(murk_linear *linear);

/* The field on the part [t0, t1] of the current segment. */
murk_cubic murk_linear_cubic(const murk_linear *linear, double t0, double t1);

/* Adds the integral of (scale * field + offset) over the whole walk to *sum. To
 * be called once, in place of murk_linear_next(). True if *sum reaches the
 * limit: then *sum is the limit, linear->ray.to the ray parameter at which it
 * is reached, and linear->value the field there, which is above 0 if offset is
 * 0. */
bool murk_linear_integrate(murk_linear *linear, double scale, double offset,
                           double limit, double *sum);

/* True if the tree is not empty and p is in the box of the field; *density is
 * then the field there. */
bool murk_linear_density(const murk_tree *tree, murk_vec3 p, double *density);

/* Begins the segment in the cell at[]: crosses it outside of leaves (false), or
 * enters the block of the cell (true). */
bool murk_linear_enter(murk_linear *linear);

/* Looks up the nodes of the block in `missing`, a bit mask as `known`. */
void murk_linear_find_nodes(murk_linear *linear, unsigned missing);

/* The corners of a cell, in the order of corner[]: `node` is the number of the
 * node of each corner, `step` leads from the offset of the lowest corner to
 * that of the corner in a leaf, and `nodes` lists the nodes, a bit mask as
 * `known`. */
typedef struct murk_linear_corners {
    unsigned nodes, node[8], step[8];
} murk_linear_corners;

/* By the axes along which the cell is the last one of the block, 4 x + 2 y + z.
 * Behind it is the first voxel of the next node. */
extern const murk_linear_corners murk_linear_corners_of[8];

/* The corners of the cell at this offset in the leaf of the block, after a
 * look-up of nodes that are not known. */
static inline const murk_linear_corners *
murk_linear_know_corners(murk_linear *m, unsigned offset)
{
    const unsigned ends = offset & offset >> 1 & offset >> 2; /* bits 0, 3, 6 */
    const murk_linear_corners *corners =
        &murk_linear_corners_of[(ends & 1) | (ends >> 2 & 2) | (ends >> 4 & 4)];
    if (corners->nodes & ~m->known) {
        murk_linear_find_nodes(m, corners->nodes & ~m->known);
    }
    return corners;
}

/* The value at corner i of the cell at this offset. */
static inline float murk_linear_corner(const murk_linear *m,
                                       const murk_linear_corners *corners,
                                       unsigned offset, int i)
{
    const unsigned slot = corners->node[i] ^ m->own;
    return m->values[slot][(offset + corners->step[i]) & m->offset_mask[slot]];
}

/* The values of the leaf of the block, whose node is known; NULL if it is a
 * tile. */
static inline const float *murk_linear_leaf(const murk_linear *m)
{
    return m->offset_mask[m->own] ? m->values[m->own] : NULL;
}

/* The part of the walk outside of leaves (linear_even.c): crosses the segment
 * that begins in the cell at[] and moves at[] beyond it. A box of cells whose
 * corners belong to the same constant nodes is one segment, or in empty space
 * all cells up to the next root cell. False, without a change of at[], if a
 * leaf takes part in that cell. */
bool murk_linear_cross_even(murk_linear *linear);

#endif
