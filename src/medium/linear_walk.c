/* Walk of a ray through the cells between voxel centres (medium/linear.h).
 *
 * The corners of a cell belong to up to eight nodes of the tree. Two methods
 * cover all cases: if only constant nodes take part, a whole box of cells is
 * one segment (linear_even.c); if a leaf takes part, the ray visits, cell by
 * cell, the aligned block of 8 x 8 x 8 cells in which it is
 * (linear_blocks.h). As in march.c the
 * cell beyond a face is known as whole numbers, so rounding can shift a
 * crossing by the last digits but never skip a cell, visit one twice, or
 * stall. */
#include "medium/linear.h"

#include <assert.h>
#include <math.h>

static double clamp01(double x)
{
    return murk_smaller(murk_larger(x, 0), 1);
}

/* ---- blocks ---- */

bool murk_linear_enter(murk_linear *linear)
{
    murk_linear *m = linear;
    const int32_t first[3] = {m->ray.at[0] & ~7, m->ray.at[1] & ~7,
                              m->ray.at[2] & ~7};
    m->block = murk_linear_block_at(m->blocks, first);
    const bool has_leaf = m->block && m->block->has_leaf;
    if (!has_leaf && murk_linear_cross_even(m)) {
        return false;
    }
    assert(m->block);
    murk_grid_ray_enter_block(&m->ray);
    return true;
}

/* The segment in the current cell of the block. */
static void cross_cell(murk_linear *m)
{
    const int *in = m->ray.in_block;
    const float *value = murk_linear_values(m->blocks, m->block);
    murk_linear_load_corners(m->corner,
                             &value[MURK_CELL_AT(in[0], in[1], in[2])]);
    for (int axis = 0; axis < 3; ++axis) {
        m->low[axis] = (double)m->ray.block_first[axis] + in[axis];
    }
    murk_grid_ray_cross_in_block(&m->ray);
}

/* ---- segments ---- */

void murk_linear_begin(murk_linear *linear, const murk_linear_blocks *blocks,
                       murk_vec3 origin, murk_vec3 direction, double t0,
                       double t1)
{
    const murk_tree *tree = blocks->tree;
    const int32_t first[3] = {tree->first[0] - 1, tree->first[1] - 1,
                              tree->first[2] - 1};
    linear->blocks = blocks;
    linear->cursor = (murk_tree_cursor){.tree = tree};
    murk_grid_ray_begin(&linear->ray, origin, direction, t0, t1, first,
                        tree->last);
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

bool murk_linear_density(const murk_linear_blocks *blocks, murk_vec3 p,
                         double *density)
{
    const murk_tree *tree = blocks->tree;
    int32_t cell[3];
    double in[3], corner[8];
    if (!murk_tree_voxel_at(tree, 1, p, cell, in)) {
        return false;
    }
    /* The corners from the block of the cell, or of constant nodes. */
    const int32_t first[3] = {cell[0] & ~7, cell[1] & ~7, cell[2] & ~7};
    const murk_linear_block *block = murk_linear_block_at(blocks, first);
    if (block) {
        murk_linear_load_corners(
            corner, murk_linear_values(blocks, block) +
                        MURK_CELL_AT(cell[0] & 7, cell[1] & 7, cell[2] & 7));
    } else {
        murk_tree_corners(tree, cell, corner);
    }
    const murk_cubic there = murk_cubic_in_cell(corner, in, in);
    *density = murk_cubic_value(&there, 0);
    return tree->n_cells > 0;
}
