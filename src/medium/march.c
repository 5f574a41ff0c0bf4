/* The hierarchical walk through the tree of a grid (medium/march.h). The
 * arithmetic of the crossings is that of medium/grid_ray.h. */
#include "medium/march.h"

#include <stddef.h>

/* Crosses the segment that begins in the voxel at[]; returns true if the ray
 * entered a leaf instead. */
static bool cross_at(murk_march *m)
{
    const murk_tree *tree = m->cursor.tree;
    const murk_tree_node node = murk_tree_node_at(&m->cursor, m->ray.at);
    if (node.leaf) {
        m->leaf = node.leaf;
        murk_grid_ray_enter_block(&m->ray);
        return true;
    }
    m->value = (double)node.value;
    if (node.size == MURK_ROOT_CELL && node.value == 0 &&
        murk_root_scan_is_cheaper(tree)) {
        murk_grid_ray_skip(&m->ray, tree, 0);
    } else {
        murk_grid_ray_cross_cell(&m->ray, node.size);
    }
    return false;
}

/* The segment in the current voxel of the leaf. */
static inline void cross_voxel(murk_march *m)
{
    const int *in = m->ray.in_block;
    m->value = (double)m->leaf[in[0] << 6 | in[1] << 3 | in[2]];
    murk_grid_ray_cross_in_block(&m->ray);
}

void murk_march_begin(murk_march *march, const murk_tree *tree,
                      murk_vec3 origin, murk_vec3 direction, double t0,
                      double t1)
{
    march->cursor = (murk_tree_cursor){.tree = tree};
    murk_grid_ray_begin(&march->ray, origin, direction, t0, t1, tree->first,
                        tree->last);
}

bool murk_march_next(murk_march *march)
{
    if (!murk_grid_ray_next(&march->ray)) {
        return false;
    }
    if (march->ray.is_in_block || cross_at(march)) {
        cross_voxel(march);
    }
    return true;
}

/* The state of an integration. */
typedef struct tally {
    double scale, offset, limit, reached;
} tally;

/* Adds the integral over a segment of constant value. True if the limit is
 * reached in the segment: then *to is moved back to that place. */
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

/* Integrates over the rest of a leaf: cross_voxel() and the step to the next
 * voxel in one loop, without a branch that depends on which face is nearest. */
static bool integrate_leaf(murk_march *m, tally *sum)
{
    murk_grid_ray *r = &m->ray;
    const float *leaf = m->leaf;
    const double end = r->end;
    const double dx = r->stride[0], dy = r->stride[1], dz = r->stride[2];
    const int sx = r->step[0], sy = r->step[1], sz = r->step[2];
    double from = r->from, to, value;
    double tx = murk_larger(r->cross[0], from);
    double ty = murk_larger(r->cross[1], from);
    double tz = murk_larger(r->cross[2], from);
    int x = r->in_block[0], y = r->in_block[1], z = r->in_block[2];
    tally t = *sum;
    bool stops;
    for (;;) {
        /* The value up to the nearest face. */
        value = (double)leaf[x << 6 | y << 3 | z];
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
        x += bx ? sx : 0;
        y += by ? sy : 0;
        z += bz ? sz : 0;
        if ((x | y | z) & ~7) {
            break;
        }
    }
    /* Store the state. */
    *sum = t;
    r->from = from;
    r->to = to;
    m->value = value;
    r->in_block[0] = x;
    r->in_block[1] = y;
    r->in_block[2] = z;
    return stops;
}

bool murk_march_integrate(murk_march *march, double scale, double offset,
                          double limit, double *sum)
{
    murk_grid_ray *r = &march->ray;
    tally t = {scale, offset, limit, *sum};
    bool stops = false;
    while (!stops && r->to < r->end) {
        r->from = r->to;
        if (cross_at(march)) {
            stops = integrate_leaf(march, &t);
            murk_grid_ray_leave_block(r);
        } else {
            stops = add_segment(&t, r->from, &r->to, march->value);
        }
    }
    *sum = t.reached;
    return stops;
}
