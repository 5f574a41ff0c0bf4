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

/* Two values side by side along z in one register (a vector extension of gcc
 * and clang). */
typedef double pair __attribute__((vector_size(16)));

static double clamp01(double x)
{
    return murk_smaller(murk_larger(x, 0), 1);
}

/* ---- blocks ---- */

static void load_node(murk_linear *m, unsigned which)
{
    const int32_t voxel[3] = {m->ray.block_first[0] + (int32_t)(which >> 2) * 8,
                              m->ray.block_first[1] +
                                  (int32_t)(which >> 1 & 1) * 8,
                              m->ray.block_first[2] + (int32_t)(which & 1) * 8};
    const murk_tree_node found = murk_tree_node_at(&m->cursor, voxel);
    m->tile[which] = found.value;
    m->leaf[which] = found.leaf ? found.leaf : &m->tile[which];
    m->offset_mask[which] = found.leaf ? -1 : 0;
    m->known |= 1U << which;
}

/* The value of a voxel of the block or, at index 8, of the node behind it. */
static inline double far_corner(murk_linear *m, int x, int y, int z)
{
    const unsigned which = (unsigned)((x >> 3) << 2 | (y >> 3) << 1 | (z >> 3));
    if (!(m->known & (1U << which))) {
        load_node(m, which);
    }
    const int offset = (x & 7) << 6 | (y & 7) << 3 | (z & 7);
    return (double)m->leaf[which][offset & m->offset_mask[which]];
}

static void load_far_corners(murk_linear *m, int x, int y, int z,
                             pair corner[4])
{
    for (int i = 0; i < 4; ++i) {
        const int cx = x + (i >> 1), cy = y + (i & 1);
        corner[i] =
            (pair){far_corner(m, cx, cy, z), far_corner(m, cx, cy, z + 1)};
    }
}

/* The corners of a cell, in pairs along z: [2 x + y]. `leaf` contains all
 * voxels of the block, or is NULL. */
static inline void load_corners(murk_linear *m, const float *leaf, int x, int y,
                                int z, pair corner[4])
{
    if (!leaf || (((x + 1) | (y + 1) | (z + 1)) & 8)) {
        load_far_corners(m, x, y, z, corner);
        return;
    }
    const float *v = leaf + (x << 6 | y << 3 | z);
    corner[0] = (pair){(double)v[0], (double)v[1]};
    corner[1] = (pair){(double)v[8], (double)v[9]};
    corner[2] = (pair){(double)v[64], (double)v[65]};
    corner[3] = (pair){(double)v[72], (double)v[73]};
}

/* Mean of the field on a segment through a cell, at least 0. The middle of the
 * segment is at (x, y, z) in the cell, and (dx, dy, dz) leads from one end of
 * the segment to the other. The field on the segment is a cubic, so the mean is
 * the value in the middle plus 1/24 of the second derivative, which follows
 * from the mixed derivatives of the field. */
static inline double mean_in_cell(const pair corner[4], double x, double y,
                                  double z, double dx, double dy, double dz)
{
    const pair fx = {x, x}, fy = {y, y};
    const pair low_x = corner[2] - corner[0], high_x = corner[3] - corner[1];
    const pair low = corner[0] + fx * low_x, high = corner[1] + fx * high_x;
    const pair by_y = high - low, by_xy = high_x - low_x;
    const pair value = low + fy * by_y, by_x = low_x + fy * by_xy;
    const double xy = by_xy[0] + z * (by_xy[1] - by_xy[0]);
    const double xz = by_x[1] - by_x[0], yz = by_y[1] - by_y[0];
    const double bend = xy * dx * dy + (xz * dx + yz * dy) * dz;
    return murk_larger(value[0] + z * (value[1] - value[0]) + bend * (1.0 / 12),
                       0);
}

static void load_cell(murk_linear *m)
{
    const int *in = m->ray.in_block;
    pair corner[4];
    load_far_corners(m, in[0], in[1], in[2], corner);
    for (int i = 0; i < 4; ++i) {
        m->corner[2 * i] = corner[i][0];
        m->corner[2 * i + 1] = corner[i][1];
    }
    for (int axis = 0; axis < 3; ++axis) {
        m->low[axis] = (double)m->ray.block_first[axis] + in[axis];
    }
}

/* The segment in the current cell of the block. */
static void cross_cell(murk_linear *m)
{
    load_cell(m);
    murk_grid_ray_cross_in_block(&m->ray);
}

/* ---- segments ---- */

/* Crosses the segment that begins in the cell at[]; returns true if a block
 * was entered instead. */
static bool cross_at(murk_linear *m)
{
    if (murk_linear_cross_even(m)) {
        return false;
    }
    murk_grid_ray_enter_block(&m->ray);
    m->known = 0;
    return true;
}

void murk_linear_begin(murk_linear *linear, const murk_tree *tree,
                       murk_vec3 origin, murk_vec3 direction, double t0,
                       double t1)
{
    const int32_t first[3] = {tree->first[0] - 1, tree->first[1] - 1,
                              tree->first[2] - 1};
    linear->cursor = (murk_tree_cursor){.tree = tree};
    murk_grid_ray_begin(&linear->ray, origin, direction, t0, t1, first,
                        tree->last);
}

bool murk_linear_next(murk_linear *linear)
{
    if (!murk_grid_ray_next(&linear->ray)) {
        return false;
    }
    if (linear->ray.is_in_block || cross_at(linear)) {
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

/* The state of an integration. */
typedef struct tally {
    double scale, offset, limit, reached;
} tally;

/* The limit is reached in the current segment, in which the field has the given
 * mean: moves m->ray.to back. If rounding makes the field 0 at the new
 * m->ray.to (at an end of the segment), m->value is the mean, so that a
 * collision has a medium. */
static void stop_in_segment(murk_linear *m, tally *sum, double mean)
{
    const double length = m->ray.to - m->ray.from;
    const double density = sum->scale * mean + sum->offset;
    const murk_cubic field = murk_linear_cubic(m, m->ray.from, m->ray.to);
    murk_cubic whole = {{sum->offset, 0, 0, 0}};
    murk_cubic_add(&whole, sum->scale, &field);
    const double s = murk_cubic_reach(&whole, (sum->limit - sum->reached) /
                                                  (density * length));
    m->ray.to = murk_smaller(m->ray.to, m->ray.from + s * length);
    m->value = murk_cubic_value(&field, s);
    m->value = m->value > 0 ? m->value : mean;
    sum->reached = sum->limit;
}

/* Adds the integral over a segment with the given mean of the field. True, and
 * nothing is added, if the limit is reached in the segment. */
static inline bool add_segment(tally *sum, double length, double mean)
{
    const double density = sum->scale * mean + sum->offset;
    const double more = sum->reached + density * length;
    if (more >= sum->limit && density > 0) {
        return true;
    }
    sum->reached = more;
    return false;
}

static bool integrate_segment(murk_linear *m, tally *sum)
{
    const murk_cubic field = murk_linear_cubic(m, m->ray.from, m->ray.to);
    const double mean = murk_larger(murk_cubic_integral(&field, 1), 0);
    if (add_segment(sum, m->ray.to - m->ray.from, mean)) {
        stop_in_segment(m, sum, mean);
        return true;
    }
    return false;
}

/* Integrates over the rest of a block: murk_grid_ray_cross_in_block() and
 * murk_grid_ray_step_in_block() in one loop, with the integral of each segment.
 * True if the limit is reached. */
static bool integrate_block(murk_linear *m, tally *sum)
{
    const double end = m->ray.end;
    const double dx = m->ray.direction[0], dy = m->ray.direction[1];
    const double dz = m->ray.direction[2];
    const double stride_x = m->ray.stride[0], stride_y = m->ray.stride[1];
    const double stride_z = m->ray.stride[2];
    const int step_x = m->ray.step[0], step_y = m->ray.step[1],
              step_z = m->ray.step[2];
    double from = m->ray.from, to, mean;
    double tx = murk_larger(m->ray.cross[0], from);
    double ty = murk_larger(m->ray.cross[1], from);
    double tz = murk_larger(m->ray.cross[2], from);
    int x = m->ray.in_block[0], y = m->ray.in_block[1], z = m->ray.in_block[2];
    /* The lowest point of the cell relative to the origin of the ray. */
    double ox = m->ray.block_first[0] + x - m->ray.origin[0];
    double oy = m->ray.block_first[1] + y - m->ray.origin[1];
    double oz = m->ray.block_first[2] + z - m->ray.origin[2];
    /* The longest possible segment in a cell, with a margin of 1e-3 for
     * rounding. Origins so far away that rounding exceeds the margin lose
     * the second-order term only. */
    const double longest =
        1.001 / murk_larger(murk_larger(fabs(dx), fabs(dy)), fabs(dz));
    tally t = *sum;
    bool stops;
    if (!(m->known & 1)) {
        load_node(m, 0);
    }
    const float *leaf = m->offset_mask[0] ? m->leaf[0] : NULL;
    for (;;) {
        pair corner[4];
        load_corners(m, leaf, x, y, z, corner);
        /* Mean of the field up to the nearest face. */
        const double face = murk_smaller(murk_smaller(tx, ty), tz);
        to = murk_smaller(face, end);
        const double length = to - from, middle = from + length / 2;
        const double bend = length <= longest ? length : 0;
        mean = mean_in_cell(
            corner, clamp01(middle * dx - ox), clamp01(middle * dy - oy),
            clamp01(middle * dz - oz), bend * dx, bend * dy, bend * dz);
        stops = add_segment(&t, length, mean);
        if (stops || face >= end) {
            break;
        }
        /* Advance to the next cell along every axis whose face was reached. */
        from = to;
        const bool bx = tx <= face, by = ty <= face, bz = tz <= face;
        tx += bx ? stride_x : 0;
        ty += by ? stride_y : 0;
        tz += bz ? stride_z : 0;
        const int sx = bx ? step_x : 0, sy = by ? step_y : 0;
        const int sz = bz ? step_z : 0;
        x += sx;
        y += sy;
        z += sz;
        ox += sx;
        oy += sy;
        oz += sz;
        if ((x | y | z) & ~7) {
            break;
        }
    }
    /* Store the state; at the limit find the exact position. */
    m->ray.from = from;
    m->ray.to = to;
    m->ray.in_block[0] = x;
    m->ray.in_block[1] = y;
    m->ray.in_block[2] = z;
    if (stops) {
        load_cell(m);
        stop_in_segment(m, &t, mean);
    }
    *sum = t;
    return stops;
}

bool murk_linear_integrate(murk_linear *linear, double scale, double offset,
                           double limit, double *sum)
{
    murk_linear *m = linear;
    tally t = {scale, offset, limit, *sum};
    bool stops = false;
    while (!stops && m->ray.to < m->ray.end) {
        m->ray.from = m->ray.to;
        if (cross_at(m)) {
            stops = integrate_block(m, &t);
            murk_grid_ray_leave_block(&m->ray);
        } else {
            stops = integrate_segment(m, &t);
        }
    }
    *sum = t.reached;
    return stops;
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
