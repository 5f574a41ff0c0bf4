/* The regions of a scene in which each region has one density, for the tracer,
 * which follows several photons through them at once. */
#ifndef MURK_MEDIUM_EVEN_REGIONS_H
#define MURK_MEDIUM_EVEN_REGIONS_H

#include "medium/media.h"

/* In scenes with more regions flights are computed photon by photon. Eight
 * regions keep the arrays of the tracer within a cache of 32 kB. */
#define MURK_EVEN_REGIONS_MAX 8

typedef enum murk_even_shape {
    MURK_EVEN_EVERYWHERE, /* or a box around the domain */
    MURK_EVEN_BELOW,
    MURK_EVEN_BOX,
    MURK_EVEN_SPHERE
} murk_even_shape;

typedef struct murk_even_region {
    murk_even_shape shape;
    murk_box box;
    murk_vec3 center;
    double radius_m;
    double level_m; /* height of a half space */
    bool replaces;
    size_t medium;
} murk_even_region;

/* Lists the regions in the order of the scene and returns their number; 0 if
 * there are more than MURK_EVEN_REGIONS_MAX, or if a region is a grid, a mesh,
 * a profile or moved, or has a grid of albedos. */
size_t murk_media_even_regions(const murk_media *media,
                               murk_even_region region[MURK_EVEN_REGIONS_MAX]);

/* A collision in a medium of these regions, with distance_m 0, and the
 * extinction of that medium. */
murk_collision murk_media_even_collision(const murk_media *media, size_t medium,
                                         int band, double *extinction_per_m);

#endif
