/* Crosses boxes of cells whose corners belong to constant nodes only, in one
 * segment, with trilinear interpolation between the nodes
 * (medium/linear_even.h). */
#include "medium/linear_even.h"

#include "medium/steps.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

typedef struct even_box {
    float value[8]; /* values of the nodes, by the axes along which they lie
                       behind the cell */
    int32_t size;   /* edge of the smallest node */
    unsigned
        behind; /* the axes at whose upper end the cell is: 4 x, 2 y, 1 z */
} even_box;

static unsigned axes_at_end(const int32_t at[3], int32_t size)
{
    unsigned axes = 0;
    for (int axis = 0; axis < 3; ++axis) {
        axes |= (at[axis] & (size - 1)) == size - 1 ? 4U >> axis : 0;
    }
    return axes;
}

/* Finds the box around the cell at[]; false if a leaf takes part. A smaller
 * node behind an end cuts the box, and the cell may then be at further ends.
 * This repeats at most once for each size of nodes. */
static bool find_even_box(murk_linear *m, even_box *box)
{
    const murk_linear_node own = murk_linear_node_at(m, m->at);
    if (own.leaf) {
        return false;
    }
    box->value[0] = own.value;
    box->size = own.size;
    for (;;) {
        int32_t min = box->size;
        box->behind = axes_at_end(m->at, box->size);
        /* The nodes behind the ends, and the smallest size among them. */
        for (unsigned which = 1; which < 8; ++which) {
            if (which & ~box->behind) {
                continue;
            }
            const int32_t voxel[3] = {m->at[0] + (int32_t)(which >> 2),
                                      m->at[1] + (int32_t)(which >> 1 & 1),
                                      m->at[2] + (int32_t)(which & 1)};
            const murk_linear_node other = murk_linear_node_at(m, voxel);
            if (other.leaf) {
                return false;
            }
            box->value[which] = other.value;
            min = other.size < min ? other.size : min;
        }
        /* Repeat with the smaller size until no node is smaller than the
         * box. */
        if (min == box->size) {
            return true;
        }
        box->size = min;
    }
}

static bool is_nothing(const even_box *box)
{
    bool is_zero = box->size == MURK_ROOT_CELL;
    for (unsigned which = 0; which < 8; ++which) {
        is_zero &= (which & ~box->behind) || box->value[which] == 0;
    }
    return is_zero;
}

/* Moves at[] to the position of the ray at t, clamped to the cells
 * first..last. */
static void place_between(murk_linear *m, const int32_t first[3],
                          const int32_t last[3], double t)
{
    for (int axis = 0; axis < 3; ++axis) {
        m->at[axis] = murk_voxel_at(m->origin[axis] + t * m->direction[axis],
                                    first[axis], last[axis]);
    }
}

/* Crosses the cells first..last in one segment. */
static void cross_between(murk_linear *m, const int32_t first[3],
                          const int32_t last[3])
{
    double leave[3], min = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        const double face =
            m->inverse[axis] > 0 ? (double)last[axis] + 1 : (double)first[axis];
        leave[axis] = m->inverse[axis] == 0
                          ? INFINITY
                          : (face - m->origin[axis]) * m->inverse[axis];
        min = murk_smaller(min, leave[axis]);
    }
    place_between(m, first, last, min);
    for (int axis = 0; axis < 3; ++axis) {
        if (leave[axis] <= min && m->inverse[axis] != 0) {
            m->at[axis] =
                m->inverse[axis] > 0 ? last[axis] + 1 : first[axis] - 1;
        }
    }
    m->to = murk_smaller(murk_larger(min, m->from), m->end);
}

static void cross_even_box(murk_linear *m, const even_box *box)
{
    int32_t first[3], last[3];
    for (int axis = 0; axis < 3; ++axis) {
        const int32_t end = m->at[axis] | (box->size - 1);
        first[axis] = m->at[axis] & ~(box->size - 1);
        last[axis] = end - 1;
        if (box->behind & (4U >> axis)) {
            first[axis] = last[axis] = m->at[axis];
        }
        m->low[axis] = m->at[axis];
    }
    for (unsigned which = 0; which < 8; ++which) {
        m->corner[which] = (double)box->value[which & box->behind];
    }
    cross_between(m, first, last);
}

/* Crosses empty space up to the nearest root cell ahead, including the cells
 * before it that interpolate with it. Root cells that the ray has left end
 * at or before `from`, by the same arithmetic, so they are not found again. */
static void skip_to_root_cell(murk_linear *m)
{
    const murk_root_cell *nearest = NULL;
    double min = m->end;
    /* Clip the ray to each root cell, enlarged by one voxel at the lower
     * side. */
    for (size_t i = 0; i < m->tree->n_cells; ++i) {
        const murk_root_cell *cell = &m->tree->cells[i];
        double t0 = m->from, t1 = m->end;
        bool is_met = true;
        for (int axis = 0; axis < 3 && is_met; ++axis) {
            const double low = (double)cell->first[axis] - 1;
            is_met =
                murk_clip_axis(low, low + MURK_ROOT_CELL + 1, m->origin[axis],
                               m->inverse[axis], &t0, &t1);
        }
        if (is_met && t0 < min) {
            min = t0;
            nearest = cell;
        }
    }
    /* An empty segment up to there. */
    m->to = min;
    for (int axis = 0; axis < 3; ++axis) {
        m->low[axis] = m->at[axis];
    }
    memset(m->corner, 0, sizeof m->corner);
    if (nearest) {
        const int32_t *f = nearest->first;
        const int32_t first[3] = {f[0] - 1, f[1] - 1, f[2] - 1};
        const int32_t last[3] = {f[0] + MURK_ROOT_CELL - 1,
                                 f[1] + MURK_ROOT_CELL - 1,
                                 f[2] + MURK_ROOT_CELL - 1};
        place_between(m, first, last, min);
    }
}

bool murk_linear_cross_even(murk_linear *linear)
{
    even_box box;
    if (!find_even_box(linear, &box)) {
        return false;
    }
    if (is_nothing(&box) && murk_root_scan_is_cheaper(linear->tree)) {
        skip_to_root_cell(linear);
    } else {
        cross_even_box(linear, &box);
    }
    return true;
}
