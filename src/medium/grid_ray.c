/* The start of a ray through a grid, and the search for the next root cell in
 * empty space (medium/grid_ray.h). */
#include "medium/grid_ray.h"

#include <float.h>
#include <stddef.h>

/* With up to 64 root cells (nearly every grid) the next one is found by testing
 * all of them. With more root cells, all of them are tested only if a walk cell
 * by cell through the box of active voxels would take more steps than there are
 * root cells. */
#define FEW_ROOT_CELLS 64

bool murk_grid_clip(const murk_tree *tree, int32_t below, murk_vec3 origin,
                    murk_vec3 direction, double *t0, double *t1)
{
    const double o[3] = {origin.x, origin.y, origin.z};
    const double d[3] = {direction.x, direction.y, direction.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (!murk_clip_axis((double)tree->first[axis] - below,
                            (double)tree->last[axis] + 1, o[axis],
                            murk_invert(d[axis]), t0, t1)) {
            return false;
        }
    }
    return tree->n_cells > 0;
}

void murk_grid_ray_begin(murk_grid_ray *ray, murk_vec3 origin,
                         murk_vec3 direction, double t0, double t1,
                         const int32_t first[3], const int32_t last[3])
{
    murk_grid_ray *r = ray;
    const double o[3] = {origin.x, origin.y, origin.z};
    const double d[3] = {direction.x, direction.y, direction.z};
    for (int axis = 0; axis < 3; ++axis) {
        r->origin[axis] = o[axis];
        r->direction[axis] = d[axis];
        r->inverse[axis] = murk_invert(d[axis]);
        r->stride[axis] = fabs(r->inverse[axis]);
        r->step[axis] = r->inverse[axis] < 0 ? -1 : 1;
    }
    r->end = murk_smaller(t1, DBL_MAX); /* finite, so that 0 * length is 0 */
    r->from = r->to = t0;
    r->is_in_block = false;
    murk_grid_ray_place(r, first, last, t0);
}

/* A root cell that the ray has left ends at or before `from`, by the same
 * arithmetic, so it is not found again. */
void murk_grid_ray_skip(murk_grid_ray *ray, const murk_tree *tree,
                        int32_t below)
{
    /* The root cell that the ray reaches first. */
    const murk_root_cell *nearest = NULL;
    double min = ray->end;
    for (size_t i = 0; i < tree->n_cells; ++i) {
        const murk_root_cell *cell = &tree->cells[i];
        double t0 = ray->from, t1 = ray->end;
        bool is_met = true;
        for (int axis = 0; axis < 3 && is_met; ++axis) {
            const double low = cell->first[axis];
            is_met =
                murk_clip_axis(low - below, low + MURK_ROOT_CELL,
                               ray->origin[axis], ray->inverse[axis], &t0, &t1);
        }
        if (is_met && t0 < min) {
            min = t0;
            nearest = cell;
        }
    }
    /* The segment ends there. */
    ray->to = min;
    if (nearest) {
        const int32_t *f = nearest->first, size = MURK_ROOT_CELL - 1;
        const int32_t first[3] = {f[0] - below, f[1] - below, f[2] - below};
        const int32_t last[3] = {f[0] + size, f[1] + size, f[2] + size};
        murk_grid_ray_place(ray, first, last, min);
    }
}

bool murk_root_scan_is_cheaper(const murk_tree *tree)
{
    double steps = 0;
    for (int axis = 0; axis < 3; ++axis) {
        steps +=
            ((double)tree->last[axis] - tree->first[axis]) / MURK_ROOT_CELL;
    }
    return tree->n_cells <= FEW_ROOT_CELLS || (double)tree->n_cells < steps;
}
