/* The integral of density along a line through a grid in index space, with
 * nearest-neighbour interpolation, by the march of the program. */
#ifndef MURK_TESTS_GRID_LINE_H
#define MURK_TESTS_GRID_LINE_H

#include "medium/grid_internal.h"
#include "medium/march.h"

#include <math.h>

/* Along origin + t direction, 0 <= t <= length [density * voxels]. */
static inline double grid_line_integral(const struct murk_grid *grid,
                                        murk_vec3 origin, murk_vec3 direction,
                                        double length)
{
    const murk_tree *tree = murk_grid_tree(grid);
    const murk_vec3 shifted = murk_add(origin, murk_vec(0.5, 0.5, 0.5));
    double from = 0, to = length, sum = 0;
    if (murk_grid_clip(tree, 0, shifted, direction, &from, &to)) {
        murk_march march;
        murk_march_begin(&march, tree, shifted, direction, from, to);
        murk_march_integrate(&march, 1, 0, INFINITY, &sum);
    }
    return sum;
}

#endif
