/* The march's simple twin: every voxel is a box of its own, and a ray's chords
 * through all of them are added up. */
#ifndef MURK_TESTS_PLAIN_GRID_H
#define MURK_TESTS_PLAIN_GRID_H

#include "base/vector.h"

#include <stddef.h>

/* Dense samples, x fastest; voxel i covers [i - 1/2, i + 1/2]. */
typedef struct plain_grid {
    size_t size[3];
    const float *density;
} plain_grid;

static inline double plain_line_integral(const plain_grid *grid,
                                         murk_vec3 origin, murk_vec3 direction,
                                         double length)
{
    const float *value = grid->density;
    double sum = 0;
    for (size_t k = 0; k < grid->size[2]; ++k) {
        for (size_t j = 0; j < grid->size[1]; ++j) {
            for (size_t i = 0; i < grid->size[0]; ++i, ++value) {
                const double x = (double)i, y = (double)j, z = (double)k;
                const murk_box voxel = {{x - 0.5, y - 0.5, z - 0.5},
                                        {x + 0.5, y + 0.5, z + 0.5}};
                double t0 = 0, t1 = length;
                if (*value != 0 &&
                    murk_box_clip(&voxel, origin, direction, &t0, &t1)) {
                    sum += (double)*value * (t1 - t0);
                }
            }
        }
    }
    return sum;
}

#endif
