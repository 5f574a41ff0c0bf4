/* Arithmetic shared by the walks through the tree of a grid, which all of
 * them must do in the same way. Inside this room only. */
#ifndef MURK_MEDIUM_STEPS_H
#define MURK_MEDIUM_STEPS_H

#include "medium/tree.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* With up to 64 root cells (nearly every grid) the next one is found by
 * testing all of them; with more, only if a walk cell by cell would take
 * more steps. */
#define MURK_FEW_ROOT_CELLS 64

/* One instruction each, while fmin() and fmax() are function calls. */
static inline double murk_smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double murk_larger(double a, double b)
{
    return a > b ? a : b;
}

/* 1 / d, or 0 for a ray parallel to the faces of this axis. */
static inline double murk_invert(double d)
{
    const double inverse = 1 / d;
    return isfinite(inverse) ? inverse : 0;
}

/* Clips [*t0, *t1] to the part in which one coordinate is in [low, high). */
static inline bool murk_clip_axis(double low, double high, double origin,
                                  double inverse, double *t0, double *t1)
{
    if (inverse == 0) {
        return origin >= low && origin < high;
    }
    const double a = (low - origin) * inverse;
    const double b = (high - origin) * inverse;
    const double enter = inverse > 0 ? a : b;
    const double leave = inverse > 0 ? b : a;
    *t0 = *t0 > enter ? *t0 : enter;
    *t1 = *t1 < leave ? *t1 : leave;
    return *t0 < *t1;
}

static inline int32_t murk_voxel_at(double place, int32_t first, int32_t last)
{
    if (!(place > first)) {
        return first;
    }
    return place >= last ? last : (int32_t)floor(place);
}

/* True if at[] is in the cell of `size` voxels that begins at first[]. */
static inline bool murk_cell_contains(const int32_t first[3],
                                      const int32_t at[3], int32_t size)
{
    return (((first[0] ^ at[0]) | (first[1] ^ at[1]) | (first[2] ^ at[2])) &
            ~(size - 1)) == 0;
}

/* The lowest voxel of the cell of `size` voxels around at[]. */
static inline void murk_cell_first(int32_t first[3], const int32_t at[3],
                                   int32_t size)
{
    for (int axis = 0; axis < 3; ++axis) {
        first[axis] = at[axis] & ~(size - 1);
    }
}

static inline bool murk_root_scan_is_cheaper(const murk_tree *tree)
{
    double steps = 0;
    for (int axis = 0; axis < 3; ++axis) {
        steps +=
            ((double)tree->last[axis] - tree->first[axis]) / MURK_ROOT_CELL;
    }
    return tree->n_cells <= MURK_FEW_ROOT_CELLS ||
           (double)tree->n_cells < steps;
}

#endif
