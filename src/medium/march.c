/* The hierarchical walk through the tree of a grid (medium/march.h).
 *
 * A ray leaves a cell through the face that it reaches first. The voxel
 * beyond that face is known as a whole number; along the other axes the
 * position is computed and clamped to the cell. Rounding can therefore shift
 * a crossing by the last digits but never skip a cell, visit one twice, or
 * stall: every step advances along at least one axis. Crossings are computed
 * anew as (face - origin) / direction for each cell and each leaf, so that
 * errors do not grow with the number of cells. */
#include "medium/march.h"

#include "medium/nodes.h"
#include "medium/steps.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

static bool clip_root_cell(const murk_march *m, const murk_root_cell *cell,
                           double *t0, double *t1)
{
    for (int axis = 0; axis < 3; ++axis) {
        const double low = cell->first[axis];
        if (!murk_clip_axis(low, low + MURK_ROOT_CELL, m->origin[axis],
                            m->inverse[axis], t0, t1)) {
            return false;
        }
    }
    return true;
}

/* Moves at[] to the position of the ray at t, clamped to a cell of `size`
 * voxels. */
static void place_in_cell(murk_march *m, const int32_t first[3], int32_t size,
                          double t)
{
    for (int axis = 0; axis < 3; ++axis) {
        m->at[axis] = murk_voxel_at(m->origin[axis] + t * m->direction[axis],
                                    first[axis], first[axis] + size - 1);
    }
}

/* Crosses empty space up to the nearest root cell ahead. A cell that the ray
 * has left ends at or before `from`, by the same arithmetic, so it is not
 * found again. */
static void skip_to_root_cell(murk_march *m)
{
    const murk_root_cell *nearest = NULL;
    double min = m->end;
    for (size_t i = 0; i < m->tree->n_cells; ++i) {
        double t0 = m->from, t1 = m->end;
        if (clip_root_cell(m, &m->tree->cells[i], &t0, &t1) && t0 < min) {
            min = t0;
            nearest = &m->tree->cells[i];
        }
    }
    m->to = min;
    m->value = 0;
    if (nearest) {
        place_in_cell(m, nearest->first, MURK_ROOT_CELL, min);
    }
}

/* Crosses a cell of one value in one segment. */
static void cross_cell(murk_march *m, int32_t size, double value)
{
    double leave[3], min = INFINITY;
    int32_t first[3];
    for (int axis = 0; axis < 3; ++axis) {
        first[axis] = m->at[axis] & ~(size - 1);
        const double face = m->inverse[axis] > 0 ? (double)first[axis] + size
                                                 : (double)first[axis];
        leave[axis] = m->inverse[axis] == 0
                          ? INFINITY
                          : (face - m->origin[axis]) * m->inverse[axis];
        min = murk_smaller(min, leave[axis]);
    }
    place_in_cell(m, first, size, min);
    for (int axis = 0; axis < 3; ++axis) {
        if (leave[axis] <= min && m->inverse[axis] != 0) {
            m->at[axis] =
                m->inverse[axis] > 0 ? first[axis] + size : first[axis] - 1;
        }
    }
    m->to = murk_smaller(murk_larger(min, m->from), m->end);
    m->value = value;
}

/* The segment in the current voxel of the leaf. */
static inline void cross_voxel(murk_march *m)
{
    const int *in = m->in_leaf, *mirror = m->mirror;
    m->value = m->leaf[((in[0] ^ mirror[0]) << 6) | ((in[1] ^ mirror[1]) << 3) |
                       (in[2] ^ mirror[2])];
    const double min =
        murk_smaller(murk_smaller(m->cross[0], m->cross[1]), m->cross[2]);
    m->to = murk_smaller(murk_larger(min, m->from), m->end);
}

static void enter_leaf(murk_march *m, const unsigned char *node)
{
    m->leaf = murk_leaf_values(node);
    for (int axis = 0; axis < 3; ++axis) {
        m->leaf_first[axis] = m->at[axis] & ~7;
        m->in_leaf[axis] = (m->at[axis] & 7) ^ m->mirror[axis];
        const double face =
            (double)m->at[axis] + (m->inverse[axis] > 0 ? 1 : 0);
        m->cross[axis] = m->inverse[axis] == 0
                             ? INFINITY
                             : (face - m->origin[axis]) * m->inverse[axis];
    }
    cross_voxel(m);
}

/* Advances to the next voxel of the leaf; false if that is outside of the
 * leaf. */
static inline bool step_in_leaf(murk_march *m)
{
    for (int axis = 0; axis < 3; ++axis) {
        const bool leaves = m->cross[axis] <= m->from;
        m->in_leaf[axis] += leaves;
        m->cross[axis] += leaves ? m->stride[axis] : 0;
    }
    return !((m->in_leaf[0] | m->in_leaf[1] | m->in_leaf[2]) & 8);
}

static void leave_leaf(murk_march *m)
{
    for (int axis = 0; axis < 3; ++axis) {
        const int in = m->in_leaf[axis];
        m->at[axis] = m->leaf_first[axis] + (m->mirror[axis] ? 7 - in : in);
    }
    m->leaf = NULL;
}

/* Sets `upper` to the node around at[]. False if there is none; then the
 * segment has been crossed. */
static bool find_upper(murk_march *m)
{
    const murk_root_cell *cell = murk_tree_root_cell(m->tree, m->at);
    if (cell && cell->node) {
        m->upper = cell->node;
        murk_cell_first(m->upper_first, m->at, MURK_ROOT_CELL);
        return true;
    }
    if (cell) {
        cross_cell(m, MURK_ROOT_CELL, cell->value);
    } else if (murk_root_scan_is_cheaper(m->tree)) {
        skip_to_root_cell(m);
    } else {
        cross_cell(m, MURK_ROOT_CELL, 0);
    }
    return false;
}

static bool find_lower(murk_march *m)
{
    if (!(m->upper &&
          murk_cell_contains(m->upper_first, m->at, MURK_ROOT_CELL)) &&
        !find_upper(m)) {
        return false;
    }
    const murk_cell cell =
        murk_upper_cell(m->upper, m->at[0], m->at[1], m->at[2]);
    if (!cell.child) {
        cross_cell(m, 128, cell.value);
        return false;
    }
    m->lower = cell.child;
    murk_cell_first(m->lower_first, m->at, 128);
    return true;
}

/* Crosses the segment that begins in the voxel at[]. */
static void cross_at(murk_march *m)
{
    if (!(m->lower && murk_cell_contains(m->lower_first, m->at, 128)) &&
        !find_lower(m)) {
        return;
    }
    const murk_cell cell =
        murk_lower_cell(m->lower, m->at[0], m->at[1], m->at[2]);
    if (cell.child) {
        enter_leaf(m, cell.child);
    } else {
        cross_cell(m, 8, cell.value);
    }
}

static inline bool next(murk_march *m)
{
    m->from = m->to;
    if (!(m->from < m->end)) {
        return false;
    }
    if (m->leaf) {
        if (step_in_leaf(m)) {
            cross_voxel(m);
            return true;
        }
        leave_leaf(m);
    }
    cross_at(m);
    return true;
}

bool murk_march_clip(const murk_tree *tree, murk_vec3 origin,
                     murk_vec3 direction, double *t0, double *t1)
{
    const double o[3] = {origin.x, origin.y, origin.z};
    const double d[3] = {direction.x, direction.y, direction.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (!murk_clip_axis(tree->first[axis], (double)tree->last[axis] + 1,
                            o[axis], murk_invert(d[axis]), t0, t1)) {
            return false;
        }
    }
    return tree->n_cells > 0;
}

void murk_march_begin(murk_march *march, const murk_tree *tree,
                      murk_vec3 origin, murk_vec3 direction, double t0,
                      double t1)
{
    murk_march *m = march;
    *m = (murk_march){
        .tree = tree,
        .origin = {origin.x, origin.y, origin.z},
        .direction = {direction.x, direction.y, direction.z},
        .end = fmin(t1, DBL_MAX), /* finite, so that 0 * length is 0 */
        .from = t0,
        .to = t0};
    for (int axis = 0; axis < 3; ++axis) {
        m->inverse[axis] = murk_invert(m->direction[axis]);
        m->stride[axis] = fabs(m->inverse[axis]);
        m->mirror[axis] = m->inverse[axis] < 0 ? 7 : 0;
        m->at[axis] = murk_voxel_at(m->origin[axis] + t0 * m->direction[axis],
                                    tree->first[axis], tree->last[axis]);
    }
}

bool murk_march_next(murk_march *march)
{
    return next(march);
}

/* The state of an integration. */
typedef struct tally {
    double scale, offset, limit, reached;
} tally;

/* Adds a segment of constant value; true if the limit is reached in it, and
 * then *to is moved back. */
static inline bool add_segment(tally *sum, double from, double *to,
                               double value)
{
    const double density = sum->scale * value + sum->offset;
    const double more = sum->reached + density * (*to - from);
    if (more >= sum->limit && density > 0) {
        *to = murk_smaller(*to, from + (sum->limit - sum->reached) / density);
        sum->reached = sum->limit;
        return true;
    }
    sum->reached = more;
    return false;
}

/* Integrates over the rest of a leaf: cross_voxel() and step_in_leaf() in
 * one loop, without a branch that depends on which face is nearest. */
static bool integrate_leaf(murk_march *m, tally *sum)
{
    const float *leaf = m->leaf;
    const double end = m->end;
    const double dx = m->stride[0], dy = m->stride[1], dz = m->stride[2];
    const int mx = m->mirror[0], my = m->mirror[1], mz = m->mirror[2];
    double from = m->from, to, value;
    double tx = murk_larger(m->cross[0], from),
           ty = murk_larger(m->cross[1], from);
    double tz = murk_larger(m->cross[2], from);
    int x = m->in_leaf[0], y = m->in_leaf[1], z = m->in_leaf[2];
    tally t = *sum;
    bool stops;
    for (;;) {
        /* The value up to the nearest face. */
        value = (double)leaf[((x ^ mx) << 6) | ((y ^ my) << 3) | (z ^ mz)];
        const double face = murk_smaller(murk_smaller(tx, ty), tz);
        to = murk_smaller(face, end);
        stops = add_segment(&t, from, &to, value);
        if (stops || face >= end) {
            break;
        }
        /* Advance to the next voxel along every axis whose face was reached. */
        from = to;
        const bool bx = tx <= face, by = ty <= face, bz = tz <= face;
        tx += bx ? dx : 0;
        ty += by ? dy : 0;
        tz += bz ? dz : 0;
        x += bx;
        y += by;
        z += bz;
        if ((x | y | z) & 8) {
            break;
        }
    }
    /* Store the state. */
    *sum = t;
    m->from = from;
    m->to = to;
    m->value = value;
    m->in_leaf[0] = x;
    m->in_leaf[1] = y;
    m->in_leaf[2] = z;
    return stops;
}

bool murk_march_integrate(murk_march *march, double scale, double offset,
                          double limit, double *sum)
{
    murk_march *m = march;
    tally t = {scale, offset, limit, *sum};
    bool stops = false;
    while (!stops && m->to < m->end) {
        m->from = m->to;
        cross_at(m);
        if (m->leaf) {
            stops = integrate_leaf(m, &t);
            leave_leaf(m);
        } else {
            stops = add_segment(&t, m->from, &m->to, m->value);
        }
    }
    *sum = t.reached;
    return stops;
}
