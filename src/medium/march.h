/* Walk of a ray through the tree of a grid with nearest-neighbour
 * interpolation, one segment of constant value after the other: a hierarchical
 * digital differential analyser.
 *
 * Coordinates are index space shifted by one half, so voxel i covers [i, i +
 * 1), upper faces excluded. t is the caller's ray parameter (for example in
 * metres), since a direction may have any length. A node with one value is
 * crossed in one segment, whatever its size.
 *
 * For use inside src/medium only.
 *
 * Source: Amanatides & Woo, "A fast voxel traversal algorithm", Eurographics
 * 1987; Museth, "Hierarchical digital differential analyzer", SIGGRAPH Talks
 * 2014, doi:10.1145/2614106.2614136. */
#ifndef MURK_MEDIUM_MARCH_H
#define MURK_MEDIUM_MARCH_H

#include "medium/grid_ray.h"

typedef struct murk_march {
    murk_tree_cursor cursor;
    murk_grid_ray ray;
    double value;      /* on the current segment */
    const float *leaf; /* of the block that the ray visits */
} murk_march;

/* Starts a walk from t0 to t1, which lie in the interval of murk_grid_clip()
 * with 0 voxels below. */
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
