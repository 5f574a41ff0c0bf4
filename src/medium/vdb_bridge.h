/* The one door to OpenVDB: one grid of a file, a density or an albedo,
 * checked, as a NanoVDB float grid; and dense fields as the bytes of a file.
 * Inside this room only; plain C for both sides.
 *
 * Runs in a child process (base/subprocess.h): a hostile file may crash it or
 * make it ask for any memory.
 *
 * Source: Museth, ACM Trans. Graph. 32 (2013) 27, doi:10.1145/2487228.2487235;
 * Museth, NanoVDB, SIGGRAPH Talks 2021, doi:10.1145/3450623.3464653. */
#ifndef MURK_MEDIUM_VDB_BRIDGE_H
#define MURK_MEDIUM_VDB_BRIDGE_H

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_vdb_facts {
    char name[128];
    uint64_t active;  /* voxels, tiles by their voxels */
    uint64_t cleared; /* voxels that were not active and not 0:
                         now 0 */
    double minimum, maximum, sum, background; /* medium/grid.h */
    int64_t index_min[3], index_max[3];       /* inclusive */
    double index_to_world[12];                /* three rows of four */
} murk_vdb_facts;

/* Receives the result, once: bytes[size] hold the NanoVDB grid (size 0 where
 * no voxel is active) and are lent for the call. */
typedef murk_status (*murk_vdb_taker)(void *context,
                                      const murk_vdb_facts *facts,
                                      const void *bytes, size_t size);

/* What an albedo grid holds where it has no active value, in place of what the
 * file has there. */
#define MURK_VDB_NO_ALBEDO (-1)

/* Reads the grid that `name` chooses (medium/grid.h) from `path`, as a density
 * or an albedo, and calls `take`. Fails with MURK_BAD_FILE or MURK_BAD_VALUE
 * at `where`. */
murk_status murk_vdb_read(const char *path, const char *name, int is_albedo,
                          murk_vdb_taker take, void *context, const char *where,
                          murk_error *err);

/* The same from dense samples, x fastest, voxel (0,0,0) first. Blocks of one
 * value become tiles where as_tiles is not 0. */
murk_status murk_vdb_from_samples(const size_t size[3], const float *density,
                                  const double index_to_world[12], int as_tiles,
                                  murk_vdb_taker take, void *context,
                                  const char *where, murk_error *err);

/* Receives the bytes of a .vdb file, once; lent for the call. */
typedef murk_status (*murk_vdb_bytes_taker)(void *context, const void *bytes,
                                            size_t size);

/* One grid of a file to be: medium/grid_write.h. */
typedef struct murk_vdb_field {
    const char *name;
    const float *value;
    const char *const *notes;
} murk_vdb_field;

/* The fields, checked, as one file. */
murk_status murk_vdb_write(const murk_vdb_field *fields, size_t n,
                           const size_t size[3],
                           const double index_to_world[12],
                           murk_vdb_bytes_taker take, void *context,
                           const char *where, murk_error *err);

#endif
