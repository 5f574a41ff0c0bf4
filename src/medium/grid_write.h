/* Writes fields on a box of voxels as a .vdb file that Blender, Houdini and
 * OpenVDB read.
 *
 * Each field becomes one float grid of class fog volume; all have the same
 * transform. Values of 0 are left out (they are the background), so the size of
 * the file follows its content. The bytes of the file are built in the process
 * that the host chooses (base/subprocess.h); the calling process writes the
 * file. The file identifier of the format is derived from the contents, so
 * equal fields give equal bytes. */
#ifndef MURK_MEDIUM_GRID_WRITE_H
#define MURK_MEDIUM_GRID_WRITE_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>

/* More fields than any result has; bounds the request to the subprocess. */
#define MURK_GRID_FIELDS_MAX 64

typedef struct murk_grid_field {
    const char *name;   /* 1 to 127 bytes, unique in the file */
    const float *value; /* size[0] * size[1] * size[2], x fastest; finite */
    const char *const *notes; /* metadata: key, text, key, text, ..., NULL, for
                                 example "unit", "W/m2"; NULL: no metadata */
} murk_grid_field;

/* Writes n fields, 1..MURK_GRID_FIELDS_MAX, of size[] voxels, at most 2^31 in
 * all. index_to_world maps whole numbers to voxel centres: a box from p with
 * edges e has scale e / size and shift p + e / size / 2. The file appears whole
 * or not at all (base/file.h). Fails at `path` with MURK_BAD_VALUE if an
 * argument is out of the stated range, index_to_world cannot be inverted, or
 * the run has read the file, or with MURK_NO_MEMORY, MURK_INTERRUPTED or
 * MURK_RUN_FAILED. If the host imports by forks (base/subprocess.h), no other
 * thread of the process may run. */
murk_status murk_grid_write(const char *path, const murk_grid_field *fields,
                            size_t n, const size_t size[3],
                            const murk_affine *index_to_world, murk_error *err);

/* The creator as OpenVDB writes it near the beginning of such a file: a mark
 * by which a file of murk is recognised. */
#define MURK_GRID_MARK "creator\6\0\0\0string\4\0\0\0murk"

#endif
