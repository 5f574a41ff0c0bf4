/* The bridge to OpenVDB: reads one grid of a file as a density or an albedo,
 * checks it and converts it to a NanoVDB float grid; and writes dense fields as
 * the bytes of a file. For use inside src/medium only; plain C, which
 * vdb_bridge.cpp and C files include.
 *
 * vdb_bridge.cpp is a module of its own (base/program.h), since OpenVDB takes
 * .06 s of processor time to load.
 *
 * Runs in a subprocess (base/subprocess.h), unless the host trusts its files,
 * since a hostile file may crash OpenVDB or make it ask for any amount of
 * memory.
 *
 * Source: Museth, ACM Trans. Graph. 32 (2013) 27,
 * doi:10.1145/2487228.2487235; Museth, NanoVDB, SIGGRAPH Talks 2021,
 * doi:10.1145/3450623.3464653. */
#ifndef MURK_MEDIUM_VDB_BRIDGE_H
#define MURK_MEDIUM_VDB_BRIDGE_H

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_vdb_facts {
    char name[128];
    uint64_t active;  /* active voxels; a tile counts as all voxels in it */
    uint64_t cleared; /* inactive voxels with a value other than 0, which was
                         set to 0 */
    uint64_t cleared_next; /* the same in the second grid of two */
    double minimum, maximum, sum, background; /* medium/grid.h */
    int64_t index_min[3], index_max[3];       /* inclusive */
    double index_to_world[12];                /* three rows of four */
} murk_vdb_facts;

/* A callback that receives the result; it is called at most once. bytes[size]
 * is the NanoVDB grid (size 0 if no voxel is active), valid during the call
 * only. */
typedef murk_status (*murk_vdb_sink)(void *context, const murk_vdb_facts *facts,
                                     const void *bytes, size_t size);

/* The value that marks the absence of an albedo in an albedo grid; it
 * replaces inactive values of the file. */
#define MURK_VDB_NO_ALBEDO (-1)

/* Receives the bytes of a .vdb file, once; valid during the call only. */
typedef murk_status (*murk_vdb_bytes_sink)(void *context, const void *bytes,
                                           size_t size);

/* One grid of a file to be written: medium/grid_write.h. */
typedef struct murk_vdb_field {
    const char *name;
    const float *value;
    const char *const *notes;
} murk_vdb_field;

/* The functions of the module. */
typedef struct murk_vdb {
    /* Reads the grid selected by `name` (medium/grid.h) from `path`, as a
     * density or an albedo, and calls `take`. Fails with MURK_BAD_FILE (also
     * without memory) or MURK_BAD_VALUE at `where`, or with the status of
     * `take`. */
    murk_status (*read)(const char *path, const char *name, int is_albedo,
                        murk_vdb_sink take, void *context, const char *where,
                        murk_error *err);

    /* Reads the grids selected by `name` from the files path[0] and path[1] as
     * densities a and b, and calls `take` with (1 - weight) * a + weight * b,
     * where 0 < weight < 1. A voxel is active if it is active in a or b;
     * inactive voxels count as 0. The values are computed in double precision
     * from the values in single precision of both grids, and rounded once.
     * Fails as read() does, for the file path[k] at where[k], and with
     * MURK_BAD_VALUE at where[1] if the transforms of the grids are not
     * equal. */
    murk_status (*read_between)(const char *const path[2], const char *name,
                                double weight, murk_vdb_sink take,
                                void *context, const char *const where[2],
                                murk_error *err);

    /* Makes the grid of dense samples, x fastest, starting with voxel (0,0,0),
     * and calls `take`. Blocks of one value become tiles if as_tiles is not 0.
     * Fails as read() does. */
    murk_status (*from_samples)(const size_t size[3], const float *density,
                                const double index_to_world[12], int as_tiles,
                                murk_vdb_sink take, void *context,
                                const char *where, murk_error *err);

    /* Makes the bytes of a file with the fields, which have been checked. */
    murk_status (*write)(const murk_vdb_field *fields, size_t n,
                         const size_t size[3], const double index_to_world[12],
                         murk_vdb_bytes_sink take, void *context,
                         const char *where, murk_error *err);
} murk_vdb;

/* The object of the module. */
extern const murk_vdb murk_vdb_functions;

/* Loads the module: the prepare() of the jobs that use it
 * (base/subprocess.h). Fails with MURK_RUN_FAILED at `where`. */
murk_status murk_vdb_prepare(const char *where, murk_error *err);

/* The functions, after murk_vdb_prepare(). */
const murk_vdb *murk_vdb_now(void);

#endif
