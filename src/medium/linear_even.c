/* Crosses boxes of cells whose corners belong to constant nodes only, in one
 * segment, with trilinear interpolation between the nodes
 * (medium/linear.h). */
#include "medium/linear.h"

#include <stddef.h>
#include <string.h>

typedef struct even_box {
    float value[8]; /* value[axes]: the value of the node that lies behind the
                     * cell along these axes (a bit mask as `behind`); 0: the
                     * node of the cell */
    int32_t size;   /* edge of the smallest node */
    /* Bit mask of axes: 4 x, 2 y, 1 z. A bit is set if the cell is the last one
     * along that axis in the aligned cube of edge `size`, so that the upper
     * corners of the cell lie in the next node. */
    unsigned behind;
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
 * node behind an end of the box makes the box as small as that node, and the
 * cell may then be at further ends of the box. This repeats at most once for
 * each size of nodes. */
static bool find_even_box(murk_linear *m, even_box *box)
{
    const murk_tree_node own = murk_tree_node_at(&m->cursor, m->ray.at);
    if (own.leaf) {
        return false;
    }
    box->value[0] = own.value;
    box->size = own.size;
    for (;;) {
        int32_t min = box->size;
        box->behind = axes_at_end(m->ray.at, box->size);
        /* The nodes behind the ends, and the smallest size among them. */
        const unsigned behind = box->behind;
        for (unsigned which = behind; which > 0; which = (which - 1) & behind) {
            const int32_t voxel[3] = {m->ray.at[0] + (int32_t)(which >> 2),
                                      m->ray.at[1] + (int32_t)(which >> 1 & 1),
                                      m->ray.at[2] + (int32_t)(which & 1)};
            const murk_tree_node other = murk_tree_node_at(&m->cursor, voxel);
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
    if (box->size != MURK_ROOT_CELL) {
        return false;
    }
    bool is_zero = true;
    for (unsigned which = 0; which < 8; ++which) {
        is_zero &= box->value[which & box->behind] == 0;
    }
    return is_zero;
}

static void cross_even_box(murk_linear *m, const even_box *box)
{
    int32_t first[3], last[3];
    for (int axis = 0; axis < 3; ++axis) {
        const int32_t at = m->ray.at[axis], size = box->size;
        const bool is_at_end = box->behind & (4U >> axis);
        first[axis] = is_at_end ? at : at & ~(size - 1);
        last[axis] = is_at_end ? at : (at | (size - 1)) - 1;
        m->low[axis] = at;
    }
    for (unsigned which = 0; which < 8; ++which) {
        m->corner[which] = (double)box->value[which & box->behind];
    }
    murk_grid_ray_cross(&m->ray, first, last);
}

/* Crosses empty space up to the nearest root cell ahead, enlarged by one cell
 * at the low end of each axis: in these cells the interpolation reads values of
 * the root cell. */
static void skip_to_root_cell(murk_linear *m)
{
    for (int axis = 0; axis < 3; ++axis) {
        m->low[axis] = m->ray.at[axis];
    }
    memset(m->corner, 0, sizeof m->corner);
    murk_grid_ray_skip(&m->ray, m->cursor.tree, 1);
}

bool murk_linear_cross_even(murk_linear *linear)
{
    even_box box;
    if (!find_even_box(linear, &box)) {
        return false;
    }
    if (is_nothing(&box) && murk_root_scan_is_cheaper(linear->cursor.tree)) {
        skip_to_root_cell(linear);
    } else {
        cross_even_box(linear, &box);
    }
    return true;
}
