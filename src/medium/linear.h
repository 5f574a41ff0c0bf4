/* A ray through a grid's tree, trilinear between the voxels' centres.
 *
 * Everything is in index space as it is: voxel i sits at the point i, cell i
 * lies between the voxels i and i + 1 along each axis, upper faces excluded,
 * and the field falls to 0 over the cells around the box of active voxels; t
 * is the caller's own ray parameter. Along the ray a cell is a cubic in t, so
 * that its integral is exact: length times the value in the middle and 1/24 of
 * the second derivative there. What constant nodes alone span is crossed in
 * one segment, whatever its size.
 *
 * Inside this room only.
 *
 * Source: the walk as in march.h; the mean by Taylor about the middle, where a
 * cubic has no further terms. */
#ifndef MURK_MEDIUM_LINEAR_H
#define MURK_MEDIUM_LINEAR_H

#include "base/vector.h"
#include "medium/cubic.h"
#include "medium/tree.h"

#include <stdbool.h>

/* Points into itself: not to be copied once begun. */
typedef struct murk_linear {
    const murk_tree *tree;
    double origin[3], direction[3], inverse[3]; /* inverse 0: parallel */
    double end;

    /* The present segment [from, to), its cell's lowest point and the values
     * at the cell's corners (medium/cubic.h). Where the cell is larger than a
     * voxel along an axis, nothing depends on that axis. */
    double from, to;
    double low[3], corner[8];
    double value; /* where murk_linear_integrate() stopped */

    /* Where `to` lies: the cell at[], or, in a block, in_block[] of it. */
    int32_t at[3];

    /* A block: the 8 x 8 x 8 cells that begin in one leaf, with the leaves (or
     * the single values of tiles, then offset_mask is 0) that hold their
     * corners: leaf[4 x + 2 y + z], looked up when first needed. */
    bool is_in_block;
    int32_t block_first[3];
    int in_block[3], step[3];
    double cross[3], stride[3]; /* t at which the ray leaves its cell, by axis,
                                   and from face to face (0: parallel) */
    unsigned known;
    const float *leaf[8];
    int offset_mask[8];
    float tile[8];

    /* The node last met, and its lowest voxel. */
    const unsigned char *lower;
    int32_t lower_first[3];
} murk_linear;

/* Cuts [*t0, *t1] to where the field is not 0 for certain. False when nothing
 * is left, or when a number is NaN. */
bool murk_linear_clip(const murk_tree *tree, murk_vec3 origin,
                      murk_vec3 direction, double *t0, double *t1);

/* Sets out from t0 to t1, both from murk_linear_clip() or between such. */
void murk_linear_begin(murk_linear *linear, const murk_tree *tree,
                       murk_vec3 origin, murk_vec3 direction, double t0,
                       double t1);

/* The next segment; false at the end. Segments join without gaps and some may
 * have no length. */
bool murk_linear_next(murk_linear *linear);

/* The field over the part [t0, t1] of the present segment. */
murk_cubic murk_linear_cubic(const murk_linear *linear, double t0, double t1);

/* Adds the integral of (scale * field + offset) over what is left of the ray
 * to *sum. True when it reaches the limit on the way: then *sum is the limit,
 * `to` is where, and `value` the field there, above 0 where offset is 0. */
bool murk_linear_integrate(murk_linear *linear, double scale, double offset,
                           double limit, double *sum);

/* Whether p lies in the field's box, and the field there. */
bool murk_linear_density(const murk_tree *tree, murk_vec3 p, double *density);

#endif
