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
#include "medium/linear_blocks.h"

/* The state of a walk. */
typedef struct murk_linear {
    const murk_linear_blocks *blocks;
    const murk_linear_block *block; /* of the ray, while the ray is in one */
    murk_tree_cursor cursor;
    murk_grid_ray ray;

    /* The lowest point of the cell of the current segment and the values at the
     * corners (medium/cubic.h). If the cell is larger than a voxel along an
     * axis, the field does not depend on that axis. */
    double low[3], corner[8];
    double value; /* field at the collision of murk_linear_integrate() */
} murk_linear;

/* Starts a walk from t0 to t1, which lie in the interval of murk_grid_clip()
 * with 1 voxel below. */
void murk_linear_begin(murk_linear *linear, const murk_linear_blocks *blocks,
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
bool murk_linear_density(const murk_linear_blocks *blocks, murk_vec3 p,
                         double *density);

/* Begins the segment in the cell at[]: crosses it outside of leaves (false), or
 * enters the block of the cell (true). */
bool murk_linear_enter(murk_linear *linear);

/* Reads the values at the corners of a cell in a block, from that at the lowest
 * corner on. */
static inline void murk_linear_load_corners(double corner[8],
                                            const float *lowest)
{
    for (int i = 0; i < 8; ++i) {
        corner[i] = (double)lowest[MURK_CELL_AT(i >> 2, i >> 1 & 1, i & 1)];
    }
}

/* The part of the walk outside of leaves (linear_even.c): crosses the segment
 * that begins in the cell at[] and moves at[] beyond it. A box of cells whose
 * corners belong to the same constant nodes is one segment, or in empty space
 * all cells up to the next root cell. False, without a change of at[], if a
 * leaf takes part in that cell. */
bool murk_linear_cross_even(murk_linear *linear);

#endif
