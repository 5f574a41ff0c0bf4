/* Walk of a ray through a grid with trilinear interpolation.
 *
 * Coordinates are index space without a shift: voxel i is at the point i, cell
 * i lies between the voxels i and i + 1 along each axis, upper faces excluded.
 * The field falls to 0 in the cells around the box of active voxels. t is the
 * caller's ray parameter. Along a ray, the field in a cell is a cubic in t, so
 * the integral is exact: the length times the sum of the value in the middle
 * and 1/24 of the second derivative there. Cells whose corners belong to
 * constant nodes only are crossed in one segment of any size.
 *
 * Inside this room only.
 *
 * Source: the walk is that of march.h; the mean is the Taylor series about
 * the middle, which ends there for a cubic. */
#ifndef MURK_MEDIUM_LINEAR_H
#define MURK_MEDIUM_LINEAR_H

#include "base/vector.h"
#include "medium/cubic.h"
#include "medium/tree.h"

#include <stdbool.h>

/* The state of a walk. It contains pointers to itself: do not copy it after
 * it has begun. */
typedef struct murk_linear {
    const murk_tree *tree;
    double origin[3], direction[3], inverse[3]; /* inverse 0: parallel */
    double end;

    /* The current segment [from, to), the lowest point of the cell and the
     * values at the corners (medium/cubic.h). If the cell is larger than a
     * voxel along an axis, the field does not depend on that axis. */
    double from, to;
    double low[3], corner[8];
    double value; /* field at the collision of murk_linear_integrate() */

    /* Position of `to`: the cell at[], or, in a block, the cell in_block[]
     * of it. */
    int32_t at[3];

    /* A block: the 8 x 8 x 8 cells whose lowest voxel is in one leaf. leaf[4
     * x + 2 y + z] are the leaves that contain the corners, found when first
     * needed. For a tile, leaf points to its single value and offset_mask is
     * 0. */
    bool is_in_block;
    int32_t block_first[3];
    int in_block[3], step[3];
    double cross[3],
        stride[3]; /* t at which the ray leaves the cell, by axis; and the step
                      of t from face to face (0: parallel) */
    unsigned known;
    const float *leaf[8];
    int offset_mask[8];
    float tile[8];

    /* The node visited last, and the lowest voxel of it. */
    const unsigned char *lower;
    int32_t lower_first[3];
} murk_linear;

/* Clips [*t0, *t1] to the box outside of which the field is 0. False if
 * nothing is left, or if a number is NaN. */
bool murk_linear_clip(const murk_tree *tree, murk_vec3 origin,
                      murk_vec3 direction, double *t0, double *t1);

/* Starts a walk from t0 to t1, which lie in the interval of
 * murk_linear_clip(). */
void murk_linear_begin(murk_linear *linear, const murk_tree *tree,
                       murk_vec3 origin, murk_vec3 direction, double t0,
                       double t1);

/* Advances to the next segment; false at the end. Segments join without
 * gaps, and some have length 0. */
bool murk_linear_next(murk_linear *linear);

/* The field on the part [t0, t1] of the current segment. */
murk_cubic murk_linear_cubic(const murk_linear *linear, double t0, double t1);

/* Adds the integral of (scale * field + offset) over the rest of the ray to
 * *sum. True if *sum reaches the limit: then *sum is the limit, `to` the ray
 * parameter, and `value` the field there, which is above 0 if offset is 0. */
bool murk_linear_integrate(murk_linear *linear, double scale, double offset,
                           double limit, double *sum);

/* True if p is in the box of the field; *density is then the field there. */
bool murk_linear_density(const murk_tree *tree, murk_vec3 p, double *density);

#endif
