/* A ray through the index space of a grid, from cell to cell. All walks through
 * a grid use this arithmetic (march.c, linear_walk.c, brick_walk.c).
 *
 * A ray leaves a cell through the face that it reaches first. The cell beyond
 * that face is known as a whole number; along the other axes the position is
 * computed and clamped to the cell. Rounding can therefore shift a crossing by
 * the last digits but never skip a cell, visit one twice, or stall: every step
 * advances along at least one axis. Crossings are computed anew from the origin
 * of the ray wherever the ray enters a cell that it crosses in one segment, or
 * a block of 8 x 8 x 8 cells; only inside of a block strides are added. Errors
 * therefore do not grow with the number of cells.
 *
 * Cell i covers [i, i + 1), upper faces excluded. For use inside src/medium
 * only. */
#ifndef MURK_MEDIUM_GRID_RAY_H
#define MURK_MEDIUM_GRID_RAY_H

#include "medium/tree.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct murk_grid_ray {
    double origin[3], direction[3], inverse[3]; /* inverse 0: parallel */
    double stride[3]; /* ray parameter from face to face; 0: parallel */
    double end;

    /* The current segment [from, to), and the cell that the ray enters at `to`.
     * While the ray is in a block, at[] is the cell in which the ray entered
     * the block. */
    double from, to;
    int32_t at[3];

    /* A block of 8 x 8 x 8 cells that the ray visits one by one: the lowest
     * cell; by axis the number 0..7 of the current cell in the block, the step
     * of this number, +1 or -1, and the ray parameter at which the ray reaches
     * the face ahead. */
    bool is_in_block;
    int32_t block_first[3];
    int in_block[3], step[3];
    double cross[3];
} murk_grid_ray;

/* One instruction each, while fmin() and fmax() are function calls. */
static inline double murk_smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double murk_larger(double a, double b)
{
    return a > b ? a : b;
}

/* 1 / d; 0 if 1 / d is not finite, for a ray that counts as parallel to the
 * faces across this axis. */
static inline double murk_invert(double d)
{
    const double inverse = 1 / d;
    return isfinite(inverse) ? inverse : 0;
}

/* Clips [*t0, *t1] to the part in which one coordinate is in [low, high). False
 * if nothing is left. */
static inline bool murk_clip_axis(double low, double high, double origin,
                                  double inverse, double *t0, double *t1)
{
    if (inverse == 0) {
        return origin >= low && origin < high;
    }
    const double a = (low - origin) * inverse;
    const double b = (high - origin) * inverse;
    *t0 = murk_larger(*t0, murk_smaller(a, b));
    *t1 = murk_smaller(*t1, murk_larger(a, b));
    return *t0 < *t1;
}

static inline int32_t murk_voxel_at(double place, int32_t first, int32_t last)
{
    if (!(place > first)) {
        return first;
    }
    return place >= last ? last : (int32_t)floor(place);
}

/* Clips [*t0, *t1] to the box of active voxels, enlarged by `below` voxels at
 * the low end of each axis. False if nothing is left, if the tree is empty, or
 * if a coordinate of the origin is NaN. */
bool murk_grid_clip(const murk_tree *tree, int32_t below, murk_vec3 origin,
                    murk_vec3 direction, double *t0, double *t1);

/* Starts a ray from t0 to t1. The first cell is that at t0, clamped to the
 * cells from first[] to last[]. */
void murk_grid_ray_begin(murk_grid_ray *ray, murk_vec3 origin,
                         murk_vec3 direction, double t0, double t1,
                         const int32_t first[3], const int32_t last[3]);

/* The ray parameter at which the ray reaches a face; INFINITY if the ray is
 * parallel to the face. */
static inline double murk_grid_ray_reach(const murk_grid_ray *r, int axis,
                                         double face)
{
    return r->inverse[axis] == 0 ? INFINITY
                                 : (face - r->origin[axis]) * r->inverse[axis];
}

/* Sets at[] to the cell in which the ray is at t, clamped to the cells first to
 * last. */
static inline void murk_grid_ray_place(murk_grid_ray *r, const int32_t first[3],
                                       const int32_t last[3], double t)
{
    for (int axis = 0; axis < 3; ++axis) {
        r->at[axis] = murk_voxel_at(r->origin[axis] + t * r->direction[axis],
                                    first[axis], last[axis]);
    }
}

/* Crosses the cells first to last in one segment: sets `to` to the end of the
 * segment and at[] to the cell beyond. */
static inline void murk_grid_ray_cross(murk_grid_ray *r, const int32_t first[3],
                                       const int32_t last[3])
{
    double leave[3], min = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        leave[axis] =
            murk_grid_ray_reach(r, axis,
                                r->inverse[axis] > 0 ? (double)last[axis] + 1
                                                     : (double)first[axis]);
        min = murk_smaller(min, leave[axis]);
    }
    murk_grid_ray_place(r, first, last, min);
    for (int axis = 0; axis < 3; ++axis) {
        if (leave[axis] <= min && r->inverse[axis] != 0) {
            r->at[axis] =
                r->inverse[axis] > 0 ? last[axis] + 1 : first[axis] - 1;
        }
    }
    r->to = murk_smaller(murk_larger(min, r->from), r->end);
}

/* Crosses the cell of `size` cells along an edge, a power of two, around at[]
 * in one segment. */
static inline void murk_grid_ray_cross_cell(murk_grid_ray *r, int32_t size)
{
    int32_t first[3], last[3];
    for (int axis = 0; axis < 3; ++axis) {
        first[axis] = r->at[axis] & ~(size - 1);
        last[axis] = first[axis] + (size - 1);
    }
    murk_grid_ray_cross(r, first, last);
}

/* Crosses empty space up to the nearest root cell ahead, enlarged by `below`
 * voxels at the low end of each axis, or to the end of the ray. */
void murk_grid_ray_skip(murk_grid_ray *ray, const murk_tree *tree,
                        int32_t below);

/* True if a search of all root cells is cheaper than a walk through empty cells
 * of the size of root cells. */
bool murk_root_scan_is_cheaper(const murk_tree *tree);

/* ---- blocks ---- */

/* Enters the block around at[]. */
static inline void murk_grid_ray_enter_block(murk_grid_ray *r)
{
    r->is_in_block = true;
    for (int axis = 0; axis < 3; ++axis) {
        r->block_first[axis] = r->at[axis] & ~7;
        r->in_block[axis] = r->at[axis] & 7;
        /* At the end of the cell if the ray goes up. */
        const double face = (double)(r->at[axis] + (r->step[axis] > 0));
        r->cross[axis] = murk_grid_ray_reach(r, axis, face);
    }
}

/* Sets at[] to the cell beyond the block. */
static inline void murk_grid_ray_leave_block(murk_grid_ray *r)
{
    for (int axis = 0; axis < 3; ++axis) {
        r->at[axis] = r->block_first[axis] + r->in_block[axis];
    }
    r->is_in_block = false;
}

/* Sets `to` to the end of the segment in the current cell of the block. */
static inline void murk_grid_ray_cross_in_block(murk_grid_ray *r)
{
    const double min =
        murk_smaller(murk_smaller(r->cross[0], r->cross[1]), r->cross[2]);
    r->to = murk_smaller(murk_larger(min, r->from), r->end);
}

/* Advances to the next cell of the block; false if that is outside of the
 * block. */
static inline bool murk_grid_ray_step_in_block(murk_grid_ray *r)
{
    for (int axis = 0; axis < 3; ++axis) {
        const bool leaves = r->cross[axis] <= r->from;
        r->in_block[axis] += leaves ? r->step[axis] : 0;
        r->cross[axis] += leaves ? r->stride[axis] : 0;
    }
    return !((r->in_block[0] | r->in_block[1] | r->in_block[2]) & ~7);
}

/* Begins the next segment: in a block with the next cell of the block. The
 * block is left if that cell is outside. False at the end of the ray. */
static inline bool murk_grid_ray_next(murk_grid_ray *r)
{
    r->from = r->to;
    if (!(r->from < r->end)) {
        return false;
    }
    if (r->is_in_block && !murk_grid_ray_step_in_block(r)) {
        murk_grid_ray_leave_block(r);
    }
    return true;
}

#endif
