/* Density grids: voxels from OpenVDB files, stored as NanoVDB buffers, and
 * rectilinear grids with cells of any length from simulations
 * (medium/rectilinear.h).
 *
 * The file is parsed in a subprocess with limits (base/subprocess.h), checked
 * (float, half or double; not a level set; finite; not negative; indices within
 * 2^30) and handed over as one NanoVDB float grid. Sparse grids are never made
 * dense. The functions that read or make a grid may fork, as the host chooses
 * (base/subprocess.h); then no other thread and no Embree device may exist.
 *
 * Source: Museth, ACM Trans. Graph. 32 (2013) 27,
 * doi:10.1145/2487228.2487235; Museth, NanoVDB, SIGGRAPH Talks 2021,
 * doi:10.1145/3450623.3464653. */
#ifndef MURK_MEDIUM_GRID_H
#define MURK_MEDIUM_GRID_H

#include "base/status.h"
#include "base/vector.h"
#include "fds/extinction.h"
#include "medium/netcdf_request.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_grid murk_grid;

typedef struct murk_grid_facts {
    char name[128];
    uint64_t active; /* active voxels; a tile counts as all voxels in it */
    double minimum, maximum, sum; /* over the box of active voxels of a
                                     density, in which inactive voxels count
                                     as 0; over the active voxels of an
                                     albedo; 0 if there are none */
    double background;            /* the value elsewhere; 0 for densities */
    int64_t index_min[3], index_max[3]; /* inclusive box of active voxels */
    double voxel_m[3]; /* edge lengths before the scene moves the grid */
    murk_affine index_to_world; /* voxel i covers [i - 1/2, i + 1/2] */
    size_t memory_bytes;
    /* Rectilinear grids: active counts values, voxel_m has the smallest cell
     * along each axis, and index_to_world is the identity. */
    size_t blocks;              /* 0: a grid of voxels */
    bool has_nodes;             /* a block has values at nodes */
    murk_box box;               /* of all blocks [m] */
    uint64_t checksum[2];       /* of all edges and values */
    char note[256];             /* how the values were obtained */
    double effective_radius_um; /* of droplets, the mean by extinction; 0: no
                                 * droplets */
} murk_grid_facts;

/* Dense samples in memory: the data of a file "memory:NAME"
 * (base/memory_files.h). */
typedef struct murk_grid_samples {
    size_t size[3];
    const float *value; /* [size[2]][size[1]][size[0]]: x fastest */
    murk_affine index_to_world;
    void (*release)(void *user); /* NULL: `user` is freed by free() */
    void *user;
} murk_grid_samples;

/* Reads a grid. `name` selects the grid of a file: NULL for the only density
 * (or for `density` if there are several), "density[1]" for the second of that
 * name. A path "memory:NAME" names samples in memory (base/memory_files.h), for
 * which `name` is ignored. The caller owns *out and releases it with
 * murk_grid_destroy(). Warns of empty grids, of grids that are 0 everywhere and
 * of inactive voxels with a value.
 * Fails with MURK_BAD_FILE or MURK_BAD_VALUE at `where` (the message lists the
 * grids if the choice is not clear, and counts bad values and gives the first),
 * with MURK_NO_MEMORY, or as murk_subprocess_run() does. */
murk_status murk_grid_read(murk_grid **out, const char *path, const char *name,
                           const char *where, murk_error *err);

/* Reads the density at a time between two frames: the grids of the files
 * path[0] and path[1], selected by `name` in each, become (1 - weight) times
 * the first plus weight times the second, where 0 < weight < 1. A voxel that is
 * missing or inactive in one file is 0 there; a voxel is active if it is active
 * in either. The values are computed in double precision and rounded once to
 * single precision. Both files are read in one subprocess. Warns and fails as
 * murk_grid_read() does, with the file in `where` that is to blame, with
 * MURK_BAD_VALUE if the transforms of the grids are not equal, and with
 * MURK_UNSUPPORTED for samples in memory. */
murk_status murk_grid_read_between(murk_grid **out, const char *const path[2],
                                   double weight, const char *name,
                                   const char *where, murk_error *err);

/* Reads a grid of albedos: values and background 0..1. The background applies
 * outside of the active voxels. Only for murk_medium.albedo_grid. Samples in
 * memory are refused with MURK_UNSUPPORTED. */
murk_status murk_grid_read_albedo(murk_grid **out, const char *path,
                                  const char *name, const char *where,
                                  murk_error *err);

/* Reads the extinction coefficients [1/m] of an FDS run at one time as a
 * rectilinear grid (fds/extinction.h), which no other function of this header
 * can make an albedo of. Warns of capped values and of a grid that is 0
 * everywhere. Fails as murk_fds_field_read() and murk_subprocess_do() do. */
murk_status murk_grid_read_fds(murk_grid **out, const char *path,
                               const murk_fds_asked *asked, const char *where,
                               murk_error *err);

/* Reads the extinction coefficients [1/m] of a NetCDF file at one time as a
 * rectilinear grid. The values follow from liquid water content L and effective
 * radius r of droplets, 3 L / (2 r) in units of water (extinction efficiency 2;
 * Stephens, J. Atmos. Sci. 35 (1978) 2123), or from any variable by a factor.
 * Fails with MURK_UNSUPPORTED if the program murk-netcdf is not installed, and
 * otherwise as murk_subprocess_do(). */
murk_status murk_grid_read_netcdf(murk_grid **out, const char *path,
                                  const murk_netcdf_asked *asked,
                                  const char *where, murk_error *err);

/* Makes a grid of dense samples, x fastest: size[0] * size[1] * size[2] values,
 * starting with voxel (0,0,0). Voxels of value 0 are not stored. Fails at
 * `where` with MURK_BAD_VALUE if there are no samples, more than 2^31, or
 * samples that are negative or not finite, with MURK_BAD_FILE if index_to_world
 * is singular or not finite, with MURK_NO_MEMORY, or as murk_subprocess_run()
 * does. */
murk_status murk_grid_from_samples(murk_grid **out, const size_t size[3],
                                   const float *density,
                                   const murk_affine *index_to_world,
                                   const char *where, murk_error *err);
/* Releases the grid, and destroys it if no owner is left; NULL is fine. */
void murk_grid_destroy(murk_grid *grid);

/* Adds an owner, who also calls murk_grid_destroy(), and returns the grid; NULL
 * is fine. Not for owners that several threads release at once. */
murk_grid *murk_grid_share(murk_grid *grid);

const murk_grid_facts *murk_grid_describe(const murk_grid *grid);

/* The NanoVDB float grid, for code that reads this format: memory_bytes
 * bytes, 64-byte aligned, owned by the grid; NULL if the grid is empty or
 * rectilinear. */
const void *murk_grid_nanovdb(const murk_grid *grid);

/* Value of a density grid of voxels at an index; 0 outside of the active
 * voxels. */
double murk_grid_value(const murk_grid *grid, int64_t i, int64_t j, int64_t k);

#endif
