/* Albedo by a grid: nearest, or linear between the voxels around that hold
 * one, so that an edge between albedo and none is not darkened. Where none
 * holds one: the grid's background. Inside this room only. */
#ifndef MURK_MEDIUM_ALBEDO_H
#define MURK_MEDIUM_ALBEDO_H

#include "base/vector.h"
#include "medium/media.h"
#include "medium/place.h"

/* By the grid, at p of the world. */
double murk_albedo_by_grid(const murk_medium *medium, const murk_place *place,
                           murk_vec3 p);

/* Of the medium in its place at p of the world. */
static inline double murk_albedo_at(const murk_medium *medium,
                                    const murk_place *place, int band,
                                    murk_vec3 p)
{
    return medium->albedo_grid ? murk_albedo_by_grid(medium, place, p)
                               : medium->albedo.band[band];
}

#endif
