/* Albedo from a grid, by the interpolation of the medium: the value of the
 * nearest voxel, or the trilinear mean of those surrounding voxels that have an
 * albedo. Voxels without an albedo do not take part, so an edge of the grid is
 * not darkened. The background of the grid applies if the nearest voxel, or
 * each surrounding voxel, has no albedo. For use inside src/medium only. */
#ifndef MURK_MEDIUM_ALBEDO_H
#define MURK_MEDIUM_ALBEDO_H

#include "base/vector.h"
#include "medium/media.h"
#include "medium/place.h"

/* Albedo at the world point p of a medium that has an albedo grid. */
double murk_albedo_by_grid(const murk_medium *medium, const murk_place *place,
                           murk_vec3 p);

/* Albedo of a placed medium at the world point p: from the albedo grid if the
 * medium has one, otherwise the constant of the band. */
static inline double murk_albedo_at(const murk_medium *medium,
                                    const murk_place *place, int band,
                                    murk_vec3 p)
{
    return medium->albedo_grid ? murk_albedo_by_grid(medium, place, p)
                               : medium->albedo.band[band];
}

#endif
