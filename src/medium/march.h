/* A ray through a grid's tree: one segment of constant value after the other.
 *
 * Everything is in index space shifted by a half, so that voxel i covers
 * [i, i + 1), upper faces excluded; t is the caller's own ray parameter (say,
 * metres), since a direction may have any length. Cells that hold one value
 * are crossed in one segment, whatever their size.
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

    /* The present segment [from, to) and its value. */
    double from, to, value;

    /* Where `to` lies: a voxel of a leaf, or (leaf NULL) the voxel at[]. */
    const float *leaf;
    int32_t leaf_first[3];
    int mirror[3];    /* 7 where the ray goes down an axis, else 0 */
    int in_leaf[3];   /* voxel in the leaf, counted along the ray, 0..8 */
    double cross[3];  /* t at which the ray leaves that voxel, by axis */
    double stride[3]; /* t from face to face; 0: parallel */
    int32_t at[3];

    /* The nodes last met, and their lowest voxels. */
    const unsigned char *upper, *lower;
    int32_t upper_first[3], lower_first[3];
} murk_march;

/* Cuts [*t0, *t1] to the box of active voxels. False when nothing is left, or
 * when a number is NaN. */
bool murk_march_clip(const murk_tree *tree, murk_vec3 origin,
                     murk_vec3 direction, double *t0, double *t1);

/* Sets out from t0 to t1, both from murk_march_clip() or between such. */
void murk_march_begin(murk_march *march, const murk_tree *tree,
                      murk_vec3 origin, murk_vec3 direction, double t0,
                      double t1);

/* The next segment; false at the end. Segments join without gaps and some may
 * have no length. */
bool murk_march_next(murk_march *march);

/* Adds the integral of (scale * value + offset) over what is left of the march
 * to *sum. True when it reaches the limit on the way: then *sum is the limit
 * and the present segment [from, to] ends there. */
bool murk_march_integrate(murk_march *march, double scale, double offset,
                          double limit, double *sum);

#endif
