/* Density grids from OpenVDB files, as NanoVDB buffers.
 *
 * The file is parsed in a child process with limits (base/subprocess.h),
 * checked (float, half or double, not a level set, finite, not negative, sane
 * size) and handed over as one NanoVDB float grid; huge sparse boxes are never
 * densified. Call before any thread or ray device exists.
 *
 * Source: Museth, ACM Trans. Graph. 32 (2013) 27, doi:10.1145/2487228.2487235;
 * Museth, NanoVDB, SIGGRAPH Talks 2021, doi:10.1145/3450623.3464653. */
#ifndef MURK_MEDIUM_GRID_H
#define MURK_MEDIUM_GRID_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_grid murk_grid;

typedef struct murk_grid_facts {
    char name[128];
    uint64_t active; /* voxels, tiles counted by their voxels */
    double minimum, maximum,
        sum;           /* over active voxels; 0 when there are none */
    double background; /* what holds elsewhere: 0 of densities */
    int64_t index_min[3], index_max[3]; /* inclusive box of active voxels */
    double voxel_m[3]; /* edge lengths before the scene places the grid */
    murk_affine index_to_world; /* voxel i covers [i - 1/2, i + 1/2] */
    size_t memory_bytes;
} murk_grid_facts;

/* `name` chooses the grid: NULL for the only one (or for `density` where there
 * are several), "density[1]" for the second of that name. *out is the
 * caller's: murk_grid_destroy(). Warns of empty and all-zero grids. Fails with
 * MURK_BAD_FILE or MURK_BAD_VALUE at `where`, with the list of grids where the
 * choice is not clear, with count and first place of bad values. */
murk_status murk_grid_read(murk_grid **out, const char *path, const char *name,
                           const char *where, murk_error *err);

/* The same of a grid of albedos: values and background 0..1. Where it has no
 * active voxel its background holds. Only for murk_medium.albedo_grid. */
murk_status murk_grid_read_albedo(murk_grid **out, const char *path,
                                  const char *name, const char *where,
                                  murk_error *err);

/* From dense samples, x fastest: size[0] * size[1] * size[2] values, voxel
 * (0,0,0) first; zero voxels are left out. For tests and tools. */
murk_status murk_grid_from_samples(murk_grid **out, const size_t size[3],
                                   const float *density,
                                   const murk_affine *index_to_world,
                                   const char *where, murk_error *err);
void murk_grid_destroy(murk_grid *grid); /* NULL is fine */

const murk_grid_facts *murk_grid_describe(const murk_grid *grid);

/* The NanoVDB float grid itself, for readers of that format: memory_bytes of
 * it, 64-byte aligned, the grid's own; NULL when the grid is empty. */
const void *murk_grid_nanovdb(const murk_grid *grid);

/* Value at an index [density unit]; the background (0) where nothing is. */
double murk_grid_value(const murk_grid *grid, int64_t i, int64_t j, int64_t k);

/* Integral of density along origin + t direction, 0 <= t <= length, in index
 * space [density * voxels], nearest-voxel (piecewise constant), exact up to
 * rounding: hierarchical DDA, empty space skipped. */
double murk_grid_line_integral(const murk_grid *grid, murk_vec3 origin,
                               murk_vec3 direction, double length);

#endif
