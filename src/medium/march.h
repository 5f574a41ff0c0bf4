/* Walk of a ray through the tree of a grid with nearest-neighbour
 * interpolation, one segment of constant value after the other: a hierarchical
 * digital differential analyser.
 *
 * Coordinates are index space shifted by one half, so voxel i covers [i, i +
 * 1), upper faces excluded. t is the caller's ray parameter (for example in
 * metres), since a direction may have any length. A node with one value is
 * crossed in one segment, whatever its size.
 *
 * Inside this room only.
 *
 * Source: Amanatides & Woo, "A fast voxel traversal algorithm", Eurographics
 * 1987; Museth, "Hierarchical digital differential analyzer", SIGGRAPH Talks
 * 2014, doi:10.1145/2614106.2614136. */
#ifndef MURK_MEDIUM_MARCH_H
#define MURK_MEDIUM_MARCH_H

#include "base/vector.h"
#include "medium/tree.h"

#include <stdbool.h>

typedef struct murk_march {
    const murk_tree *tree;
    double origin[3], direction[3], inverse[3]; /* inverse 0: parallel */
    double end;

    /* The current segment [from, to) and the value on it. */
    double from, to, value;

    /* Position of `to`: a voxel of a leaf, or (leaf NULL) the voxel at[]. */
    const float *leaf;
    int32_t leaf_first[3];
    int mirror[3];    /* 7 if the ray goes down the axis, else 0 */
    int in_leaf[3];   /* voxel in the leaf, counted along the ray, 0..8 */
    double cross[3];  /* t at which the ray leaves that voxel, by axis */
    double stride[3]; /* t from face to face; 0: parallel */
    int32_t at[3];

    /* The nodes visited last, and their lowest voxels. */
    const unsigned char *upper, *lower;
    int32_t upper_first[3], lower_first[3];
} murk_march;

/* Clips [*t0, *t1] to the box of active voxels. False if nothing is left, or
 * if a number is NaN. */
bool murk_march_clip(const murk_tree *tree, murk_vec3 origin,
                     murk_vec3 direction, double *t0, double *t1);

/* Starts a walk from t0 to t1, which lie in the interval of
 * murk_march_clip(). */
void murk_march_begin(murk_march *march, const murk_tree *tree,
                      murk_vec3 origin, murk_vec3 direction, double t0,
                      double t1);

/* Advances to the next segment; false at the end. Segments join without
 * gaps, and some have length 0. */
bool murk_march_next(murk_march *march);

/* Adds the integral of (scale * value + offset) over the rest of the ray to
 * *sum. True if *sum reaches the limit: then *sum is the limit and the
 * current segment [from, to] ends there. */
bool murk_march_integrate(murk_march *march, double scale, double offset,
                          double limit, double *sum);

#endif
