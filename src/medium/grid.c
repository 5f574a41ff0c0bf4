#include "medium/grid.h"

#include "medium/march.h"
#include "medium/tree.h"

#include <math.h>
#include <stdlib.h>

struct murk_grid {
    murk_grid_facts facts;
    unsigned char *buffer; /* the NanoVDB grid; NULL when it is empty */
    murk_tree tree;
};

void murk_grid_destroy(murk_grid *grid)
{
    if (grid) {
        murk_tree_close(&grid->tree);
        free(grid->buffer);
        free(grid);
    }
}

const murk_grid_facts *murk_grid_describe(const murk_grid *grid)
{
    return &grid->facts;
}

const murk_tree *murk_grid_tree(const murk_grid *grid)
{
    return &grid->tree;
}

double murk_grid_value(const murk_grid *grid, int64_t i, int64_t j, int64_t k)
{
    const int64_t at[3] = {i, j, k};
    int32_t voxel[3];
    for (int axis = 0; axis < 3; ++axis) {
        if (at[axis] < grid->tree.first[axis] ||
            at[axis] > grid->tree.last[axis]) {
            return 0;
        }
        voxel[axis] = (int32_t)at[axis];
    }
    return (double)murk_tree_value(&grid->tree, voxel);
}

double murk_grid_line_integral(const murk_grid *grid, murk_vec3 origin,
                               murk_vec3 direction, double length)
{
    const murk_vec3 shifted = murk_add(origin, murk_vec(0.5, 0.5, 0.5));
    double from = 0, to = length, sum = 0;
    if (murk_march_clip(&grid->tree, shifted, direction, &from, &to)) {
        murk_march march;
        murk_march_begin(&march, &grid->tree, shifted, direction, from, to);
        murk_march_integrate(&march, 1, 0, INFINITY, &sum);
    }
    return sum;
}
