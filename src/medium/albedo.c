/* Interpolation of albedo grids (medium/albedo.h).
 *
 * A voxel without an albedo has a negative value (MURK_VDB_NO_ALBEDO). The
 * interpolation is that of the medium's density grid. */
#include "medium/albedo.h"

#include "medium/grid_internal.h"
#include "medium/tree.h"

#include <math.h>

/* Albedo of the nearest voxel; negative if there is none. */
static double nearest(const murk_tree *tree, murk_vec3 p)
{
    int32_t voxel[3];
    double in[3];
    const murk_vec3 shifted = murk_add(p, murk_vec(0.5, 0.5, 0.5));
    return murk_tree_voxel_at(tree, 0, shifted, voxel, in)
               ? (double)murk_tree_value(tree, voxel)
               : -1;
}

/* Trilinear mean over those corners of the cell around p that have an albedo
 * and a weight above 0; negative if there are none. */
static double linear(const murk_tree *tree, murk_vec3 p)
{
    int32_t cell[3];
    double in[3], corner[8], sum = 0, weights = 0;
    if (!murk_tree_voxel_at(tree, 1, p, cell, in)) {
        return -1;
    }
    murk_tree_corners(tree, cell, corner);
    for (int which = 0; which < 8; ++which) {
        const double weight = (which & 4 ? in[0] : 1 - in[0]) *
                              (which & 2 ? in[1] : 1 - in[1]) *
                              (which & 1 ? in[2] : 1 - in[2]);
        sum += corner[which] >= 0 ? weight * corner[which] : 0;
        weights += corner[which] >= 0 ? weight : 0;
    }
    return weights > 0 ? fmin(1, sum / weights) : -1;
}

double murk_albedo_by_grid(const murk_medium *medium, const murk_place *place,
                           murk_vec3 p)
{
    const murk_tree *tree = murk_grid_tree(medium->albedo_grid);
    const murk_vec3 at = murk_affine_point(&place->to_albedo, p);
    /* Use the grid's background if no voxel around p has an albedo. */
    double albedo = -1;
    if (tree->n_cells > 0) {
        albedo = medium->interpolation == MURK_LINEAR ? linear(tree, at)
                                                      : nearest(tree, at);
    }
    return albedo >= 0 ? albedo
                       : murk_grid_describe(medium->albedo_grid)->background;
}
