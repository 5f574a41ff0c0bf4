/* The regions of a scene in a form that several rays are followed through at
 * once: a few simple shapes, each with one density, but one of them may be
 * filled by a grid without interpolation. */
#ifndef MURK_MEDIUM_LANE_REGIONS_H
#define MURK_MEDIUM_LANE_REGIONS_H

#include "medium/grid_lanes.h"
#include "medium/media.h"

/* In scenes with more regions flights are computed photon by photon. Eight
 * regions keep the arrays of the tracer within a cache of 32 kB. */
#define MURK_LANE_REGIONS_MAX 8

typedef enum murk_lane_shape {
    MURK_LANE_EVERYWHERE, /* or a box around the domain, or a grid's own box */
    MURK_LANE_BELOW,
    MURK_LANE_BOX,
    MURK_LANE_SPHERE
} murk_lane_shape;

typedef struct murk_lane_region {
    murk_lane_shape shape;
    murk_box box;
    murk_vec3 center;
    double radius_m;
    double level_m; /* height of a half space */
    bool replaces;
    bool is_grid; /* filled by the grid, else by one density */
    size_t medium;
} murk_lane_region;

typedef struct murk_lane_regions {
    size_t n;
    murk_lane_region region[MURK_LANE_REGIONS_MAX];
    bool has_grid;
    murk_lane_grid grid; /* of the region that is filled by a grid */
} murk_lane_regions;

/* Lists the regions in the order of the scene. False, and none is listed, if
 * there are none or more than MURK_LANE_REGIONS_MAX; or if a region is a mesh,
 * a profile or a second grid, is moved, has a grid of albedos, is a grid with
 * linear interpolation or without a table of leaves (medium/leaf_table.h), or
 * replaces others in more than the box of its grid. */
bool murk_media_lane_regions(const murk_media *media,
                             murk_lane_regions *regions);

/* A collision in a medium of these regions, at the density 1, with distance_m
 * 0, and the extinction of that medium. */
murk_collision murk_media_even_collision(const murk_media *media, size_t medium,
                                         int band, double *extinction_per_m);

#endif
