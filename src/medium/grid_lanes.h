/* Walks of several rays at once through one grid without interpolation, as
 * medium/march.h makes them one by one, with the same bits.
 *
 * Each ray has a lane (base/lanes.h). The lanes step from voxel to voxel
 * together until each of them has reached its limit or its end, or leaves its
 * leaf. A ray that meets a constant node of the tree in place of a leaf is
 * followed to its end alone, by medium/march.h. */
#ifndef MURK_MEDIUM_GRID_LANES_H
#define MURK_MEDIUM_GRID_LANES_H

#include "base/lanes.h"
#include "base/vector.h"
#include "medium/leaf_table.h"

/* A grid that is placed in the world: cell i of the index space is voxel i
 * (medium/place.h). */
typedef struct murk_lane_grid {
    const murk_tree *tree;
    const murk_leaf_table *leaves; /* not empty */
    murk_affine to_index;
} murk_lane_grid;

typedef struct murk_grid_lanes {
    /* The ray in index space; inverse 0: parallel (medium/grid_ray.h). */
    murk_lane_number x, y, z, dx, dy, dz;
    murk_lane_number inverse_x, inverse_y, inverse_z;

    /* A walk: which lanes walk, over which part of their rays, the factor of
     * the density, a constant extinction beside the grid, the sum at which the
     * walk stops and the sum reached. The sum reached at the beginning is given
     * by the caller, who reads the results: stops, the ray parameter at which
     * the walk has stopped, and the density there. */
    murk_lane_number walks, from, end, scale, offset, limit, sum;
    murk_lane_number stops, to, value;

    /* The beginning of a walk: which lanes have a part of their ray to walk;
     * the lowest voxel and the entry (medium/leaf_table.h) of the leaf there;
     * the voxels up to the end of the leaf by axis; the number of the voxel in
     * the leaf. */
    murk_lane_number starts, leaf_x, leaf_y, leaf_z, entry;
    murk_lane_number left_x, left_y, left_z, number;
} murk_grid_lanes;

typedef struct murk_grid_lane_steps {
    /* Computes the rays in index space from rays in the world, and clips the
     * parts [from, to] of them to the box of the grid; nothing is left unless
     * from < to. */
    void (*clip)(murk_grid_lanes *lanes, const murk_lane_grid *grid,
                 const double *const ray[6], double *from, double *to,
                 size_t n);
    /* Walks. */
    void (*walk)(murk_grid_lanes *lanes, const murk_lane_grid *grid, size_t n);
} murk_grid_lane_steps;

/* The steps for a set of vector instructions. */
const murk_grid_lane_steps *murk_grid_lane_steps_for(murk_lane_set set);

#endif
