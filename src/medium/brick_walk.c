/* Walk of a ray through the bricks of a grid, one segment of constant bound
 * after the other (medium/bricks.h).
 *
 * Like march.c a hierarchical digital differential analyser (Museth,
 * SIGGRAPH Talks 2014, doi:10.1145/2614106.2614136). */
#include "medium/bricks.h"

#include "medium/brick_cells.h"
#include "medium/steps.h"

#include <float.h>
#include <math.h>

/* Crosses one cell. As in march.c, the ray leaves through the face that it
 * reaches first, and along the other axes the position is clamped to the
 * cell, so that rounding can neither skip a cell nor stall. */
static inline void cross(murk_brick_walk *w, int shift)
{
    double leave[3];
    int32_t first[3], last[3];
    for (int axis = 0; axis < 3; ++axis) {
        first[axis] = w->at[axis] & ~((1 << shift) - 1);
        last[axis] = first[axis] + (1 << shift) - 1;
        const double face = (double)first[axis] +
                            (w->inverse[axis] > 0 ? (double)(1 << shift) : 0);
        leave[axis] = w->inverse[axis] == 0
                          ? INFINITY
                          : (face - w->origin[axis]) * w->inverse[axis];
    }
    const double min = murk_smaller(murk_smaller(leave[0], leave[1]), leave[2]);
    for (int axis = 0; axis < 3; ++axis) {
        const double place = w->origin[axis] + min * w->direction[axis];
        w->at[axis] = leave[axis] > min || w->inverse[axis] == 0
                          ? murk_voxel_at(place, first[axis], last[axis])
                      : w->inverse[axis] > 0 ? last[axis] + 1
                                             : first[axis] - 1;
    }
    w->to = murk_smaller(murk_larger(min, w->from), w->end);
}

void murk_brick_walk_begin(murk_brick_walk *walk, const murk_bricks *bricks,
                           murk_vec3 origin, murk_vec3 direction, double t0,
                           double t1)
{
    murk_brick_walk *w = walk;
    const double o[3] = {origin.x, origin.y, origin.z};
    const double d[3] = {direction.x, direction.y, direction.z};
    w->bricks = bricks;
    w->end = murk_smaller(t1, DBL_MAX); /* finite, so that 0 * length is 0 */
    w->from = w->to = t0;
    w->block = NULL;
    for (int axis = 0; axis < 3; ++axis) {
        w->origin[axis] = o[axis];
        w->direction[axis] = d[axis];
        w->inverse[axis] = murk_invert(d[axis]);
        w->at[axis] = murk_voxel_at(o[axis] + t0 * d[axis], -MURK_INDEX_MAX - 2,
                                    MURK_INDEX_MAX + 2);
    }
}

bool murk_brick_walk_next(murk_brick_walk *walk)
{
    murk_brick_walk *w = walk;
    const murk_bricks *b = w->bricks;
    w->from = w->to;
    if (!(w->from < w->end)) {
        return false;
    }
    if (!w->block || !murk_cell_contains(w->block_first, w->at, MURK_BLOCK)) {
        const murk_brick_bound s = murk_bricks_lookup(b, w->at);
        w->block = s.table;
        w->block_min = s.bound;
        murk_cell_first(w->block_first, w->at, MURK_BLOCK);
        if (!s.table) {
            w->bound = (double)s.bound;
            cross(w, s.shift);
            return true;
        }
    }
    const float bound = w->block[murk_brick_in_block(b->edge_shift, w->at)];
    w->bound = (double)(bound < w->block_min ? w->block_min : bound);
    cross(w, b->edge_shift);
    return true;
}
