/* Functions of density grids for use inside src/medium only. */
#ifndef MURK_MEDIUM_GRID_INTERNAL_H
#define MURK_MEDIUM_GRID_INTERNAL_H

#include "base/status.h"
#include "base/subprocess.h"
#include "base/vector.h"
#include "medium/rectilinear.h"
#include "medium/tree.h"

#include <stdbool.h>
#include <stddef.h>

struct murk_grid;

/* The tree of a grid; that of a rectilinear grid is empty. */
const murk_tree *murk_grid_tree(const struct murk_grid *grid);

/* The field of a rectilinear grid; NULL for a grid of voxels. */
const murk_rectilinear *murk_grid_rectilinear(const struct murk_grid *grid);

/* Makes a grid of a packed field with its head (base/field_blocks.h), and warns
 * as the head says, and if all values are 0. Fails as murk_rectilinear_open()
 * does. */
murk_status murk_grid_from_field(struct murk_grid **out,
                                 const unsigned char *packed, size_t size,
                                 const char *where, murk_error *err);

/* Lowers the memory limit of a subprocess to what files of that size can need,
 * so that a small hostile file cannot fill much memory. */
void murk_grid_limit_memory(murk_subprocess_limits *limits,
                            uint64_t file_bytes);

/* The limits of the reader of a NetCDF file, from the size of the file. Files
 * in the classic format are not compressed, so that no header can ask for
 * much memory there; clouds in others may be a thousandth of their values. */
murk_subprocess_limits murk_grid_netcdf_limits(const char *path);

/* Does a job of murk_subprocess_do() that answers with a packed field, and
 * makes a grid of it. */
murk_status murk_grid_read_field(struct murk_grid **out,
                                 const murk_subprocess_job *kind, void *context,
                                 const murk_subprocess_limits *limits,
                                 const char *where, murk_error *err);

/* 2^31 voxels are 8 GB of floats; indices in a grid have 32 bits. */
#define MURK_VOXELS_MAX ((size_t)1 << 31)

/* Checks the size of dense samples, at least 1 along each axis and at most
 * MURK_VOXELS_MAX in all, and computes the number of voxels. Fails with
 * MURK_BAD_VALUE at `where`. */
murk_status murk_grid_check_size(const size_t size[3], size_t *voxels,
                                 const char *where, murk_error *err);

/* The three rows of four numbers of a map, in the form of the bridge to OpenVDB
 * (medium/vdb_bridge.h). */
static inline void murk_affine_rows(const murk_affine *map, double rows[12])
{
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            rows[4 * row + column] = map->matrix[row][column];
        }
        rows[4 * row + 3] = murk_component(map->shift, row);
    }
}

/* murk_grid_from_samples() with a choice: blocks of one value are stored as
 * tiles, or voxel by voxel. */
murk_status murk_grid_make(struct murk_grid **out, const size_t size[3],
                           const float *density,
                           const murk_affine *index_to_world, bool as_tiles,
                           const char *where, murk_error *err);

#endif
