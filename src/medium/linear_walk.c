/* Walk of a ray through the cells between voxel centres (medium/linear.h).
 *
 * The corners of a cell belong to up to eight nodes of the tree. Two methods
 * cover all cases: if only constant nodes take part, a whole box of cells is
 * one segment (linear_even.c); if a leaf takes part, the ray visits, cell by
 * cell, the aligned block of 8 x 8 x 8 cells in which it is. As in march.c the
 * cell beyond a face is known as whole numbers, so rounding can shift a
 * crossing by the last digits but never skip a cell, visit one twice, or
 * stall. */
#include "medium/linear.h"

#include <math.h>
#include <stddef.h>

static double clamp01(double x)
{
    return murk_smaller(murk_larger(x, 0), 1);
}

/* ---- blocks ---- */

/* The step along an axis to the next corner, if the step in a leaf is `by`. */
#define STEP(is_end, by) ((is_end) ? 0U - 7 * (by) : (by))

#define CORNERS(x, y, z)                                                     \
    {                                                                        \
        (x ? 0x11 : 1) * (y ? 5 : 1) * (z ? 3 : 1),                          \
            {0,     z,         2 * y,         2 * y + z,                     \
             4 * x, 4 * x + z, 4 * x + 2 * y, 4 * x + 2 * y + z},            \
        {                                                                    \
            0, STEP(z, 1), STEP(y, 8), STEP(y, 8) + STEP(z, 1), STEP(x, 64), \
                STEP(x, 64) + STEP(z, 1), STEP(x, 64) + STEP(y, 8),          \
                STEP(x, 64) + STEP(y, 8) + STEP(z, 1)                        \
        }                                                                    \
    }

const murk_linear_corners murk_linear_corners_of[8] = {
    CORNERS(0, 0, 0), CORNERS(0, 0, 1), CORNERS(0, 1, 0), CORNERS(0, 1, 1),
    CORNERS(1, 0, 0), CORNERS(1, 0, 1), CORNERS(1, 1, 0), CORNERS(1, 1, 1)};

void murk_linear_find_nodes(murk_linear *linear, unsigned missing)
{
    murk_linear *m = linear;
    m->known |= missing;
    for (; missing; missing &= missing - 1) {
        const unsigned node = (unsigned)__builtin_ctz(missing);
        const int32_t *first = m->ray.block_first;
        const int32_t voxel[3] = {first[0] + (int32_t)(node & 4) * 2,
                                  first[1] + (int32_t)(node & 2) * 4,
                                  first[2] + (int32_t)(node & 1) * 8};
        const murk_tree_node found = murk_tree_node_at(&m->cursor, voxel);
        const unsigned slot = node ^ m->own;
        m->tile[slot] = found.value;
        m->values[slot] = found.leaf ? found.leaf : &m->tile[slot];
        m->offset_mask[slot] = found.leaf ? ~0U : 0;
    }
}

/* The nodes of `known` that the block beyond a step along an axis has, too,
 * with their numbers in that block. `bit` is the axis in numbers of nodes, and
 * `lower` the nodes without it. */
static inline unsigned shared_nodes(unsigned known, uint32_t step, unsigned bit,
                                    unsigned lower)
{
    return step == 0        ? known
           : step == 8      ? known >> bit & lower
           : step == 0U - 8 ? (known & lower) << bit
                            : 0;
}

/* Makes the block around at[] the current one. */
static inline void move_block(murk_linear *m)
{
    const int32_t *at = m->ray.at;
    int32_t *first = m->ray.block_first;
    const int32_t x = at[0] & ~7, y = at[1] & ~7, z = at[2] & ~7;
    unsigned known = m->known;
    known = shared_nodes(known, (uint32_t)x - (uint32_t)first[0], 4, 0x0f);
    known = shared_nodes(known, (uint32_t)y - (uint32_t)first[1], 2, 0x33);
    known = shared_nodes(known, (uint32_t)z - (uint32_t)first[2], 1, 0x55);
    m->known = known;
    m->own = (unsigned)((x & 8) >> 1 | (y & 8) >> 2 | (z & 8) >> 3);
    first[0] = x;
    first[1] = y;
    first[2] = z;
}

bool murk_linear_enter(murk_linear *linear)
{
    murk_linear *m = linear;
    move_block(m);
    if (!(m->known & 1)) {
        murk_linear_find_nodes(m, 1);
    }
    if (!murk_linear_leaf(m) && murk_linear_cross_even(m)) {
        return false;
    }
    murk_grid_ray_enter_block(&m->ray);
    return true;
}

/* The segment in the current cell of the block. */
static void cross_cell(murk_linear *m)
{
    const unsigned offset = (unsigned)murk_offset_in_leaf(m->ray.in_block);
    const murk_linear_corners *corners = murk_linear_know_corners(m, offset);
    for (int i = 0; i < 8; ++i) {
        m->corner[i] = (double)murk_linear_corner(m, corners, offset, i);
    }
    for (int axis = 0; axis < 3; ++axis) {
        m->low[axis] = (double)m->ray.block_first[axis] + m->ray.in_block[axis];
    }
    murk_grid_ray_cross_in_block(&m->ray);
}

/* ---- segments ---- */

void murk_linear_begin(murk_linear *linear, const murk_tree *tree,
                       murk_vec3 origin, murk_vec3 direction, double t0,
                       double t1)
{
    const int32_t first[3] = {tree->first[0] - 1, tree->first[1] - 1,
                              tree->first[2] - 1};
    linear->cursor = (murk_tree_cursor){.tree = tree};
    linear->known = 0;
    murk_grid_ray_begin(&linear->ray, origin, direction, t0, t1, first,
                        tree->last);
    for (int axis = 0; axis < 3; ++axis) {
        linear->ray.block_first[axis] = 0;
    }
}

bool murk_linear_next(murk_linear *linear)
{
    if (!murk_grid_ray_next(&linear->ray)) {
        return false;
    }
    if (linear->ray.is_in_block || murk_linear_enter(linear)) {
        cross_cell(linear);
    }
    return true;
}

/* Position of the ray at t in the current cell. */
static void place_in_cell(const murk_linear *m, double t, double in[3])
{
    for (int axis = 0; axis < 3; ++axis) {
        in[axis] = clamp01(m->ray.origin[axis] + t * m->ray.direction[axis] -
                           m->low[axis]);
    }
}

murk_cubic murk_linear_cubic(const murk_linear *linear, double t0, double t1)
{
    double a[3], b[3];
    place_in_cell(linear, t0, a);
    place_in_cell(linear, t1, b);
    return murk_cubic_in_cell(linear->corner, a, b);
}

bool murk_linear_density(const murk_tree *tree, murk_vec3 p, double *density)
{
    int32_t cell[3];
    double in[3], corner[8];
    if (!murk_tree_voxel_at(tree, 1, p, cell, in)) {
        return false;
    }
    murk_tree_corners(tree, cell, corner);
    const murk_cubic there = murk_cubic_in_cell(corner, in, in);
    *density = murk_cubic_value(&there, 0);
    return tree->n_cells > 0;
}
