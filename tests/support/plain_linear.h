/* The linear walk's simple twin: the trilinear field of dense samples, value
 * by value, and its integral along a ray, cut at every plane of voxel centres
 * and summed by Gauss's rule (which is exact for a cubic, and not Simpson's).
 */
#ifndef MURK_TESTS_PLAIN_LINEAR_H
#define MURK_TESTS_PLAIN_LINEAR_H

#include "plain_grid.h"

#include <math.h>

static inline double plain_sample(const plain_grid *grid, double i, double j,
                                  double k)
{
    const double at[3] = {i, j, k};
    size_t index[3];
    for (int a = 0; a < 3; ++a) {
        if (!(at[a] >= 0 && at[a] < (double)grid->size[a])) {
            return 0;
        }
        index[a] = (size_t)at[a];
    }
    return (double)
        grid->density[index[0] +
                      grid->size[0] * (index[1] + grid->size[1] * index[2])];
}

/* Each of the eight voxels around p counts by how near it is. */
static inline double plain_linear_field(const plain_grid *grid, murk_vec3 p)
{
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const double i = floor(p.x) + (corner & 1);
        const double j = floor(p.y) + (corner >> 1 & 1);
        const double k = floor(p.z) + (corner >> 2);
        sum += plain_sample(grid, i, j, k) * (1 - fabs(p.x - i)) *
               (1 - fabs(p.y - j)) * (1 - fabs(p.z - k));
    }
    return sum;
}

/* The next t after `t` at which a coordinate is whole. */
static inline double plain_next_plane(double origin, double direction, double t)
{
    double next = INFINITY;
    if (direction != 0) {
        const double at = floor(origin + t * direction);
        for (int step = -2; step <= 2; ++step) {
            const double plane = (at + step - origin) / direction;
            if (plane > t && plane < next) {
                next = plane;
            }
        }
    }
    return next;
}

static inline double plain_linear_integral(const plain_grid *grid,
                                           murk_vec3 origin,
                                           murk_vec3 direction, double length)
{
    /* Densities fall to 0 one cell beyond the outermost samples. */
    const murk_box field = {
        {-1, -1, -1},
        {(double)grid->size[0], (double)grid->size[1], (double)grid->size[2]}};
    double t = 0, end = length, sum = 0;
    if (!murk_box_clip(&field, origin, direction, &t, &end)) {
        return 0;
    }
    /* Up to the next plane of samples the field is a cubic along the ray,
     * which two Gauss-Legendre points integrate exactly. */
    while (t < end) {
        double to = end;
        to = fmin(to, plain_next_plane(origin.x, direction.x, t));
        to = fmin(to, plain_next_plane(origin.y, direction.y, t));
        to = fmin(to, plain_next_plane(origin.z, direction.z, t));
        const double middle = (t + to) / 2, half = (to - t) / 2;
        for (int side = -1; side <= 1; side += 2) {
            const double at = middle + side * half / sqrt(3);
            sum += half *
                   plain_linear_field(grid, murk_along(origin, at, direction));
        }
        t = to;
    }
    return sum;
}

#endif
