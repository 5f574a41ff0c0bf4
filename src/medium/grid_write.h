/* Fields on a box of voxels, written as a .vdb file that Blender, Houdini
 * and OpenVDB read.
 *
 * One float grid a field, of class fog volume, all with one transform. Values
 * of 0 are left out (they are the background), so a file costs by what it
 * holds. Built in a child process like everything of OpenVDB, from its
 * parent's memory; the parent writes the bytes. The format carries a file
 * identifier, which is derived from the contents: equal fields give equal
 * bytes. */
#ifndef MURK_MEDIUM_GRID_WRITE_H
#define MURK_MEDIUM_GRID_WRITE_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>

#define MURK_GRID_FIELDS_MAX 64

typedef struct murk_grid_field {
    const char *name;   /* 1 to 127 bytes, one field of a file alone has it */
    const float *value; /* size[0] * size[1] * size[2], x fastest; finite */
    const char *const *notes; /* metadata: key, text, key, text, ..., NULL, such
                                 as "unit", "W/m2"; may be NULL */
} murk_grid_field;

/* Writes n fields of size[] voxels. index_to_world takes whole numbers to
 * voxel centres: a box from p with edges e has scale e / size and shift
 * p + e / size / 2. The file appears whole or not at all (base/file.h). Fails
 * with MURK_BAD_VALUE for what is said here, MURK_NO_MEMORY, or
 * MURK_RUN_FAILED at `path`. Call it while no other thread of this process
 * runs (fork). */
murk_status murk_grid_write(const char *path, const murk_grid_field *fields,
                            size_t n, const size_t size[3],
                            const murk_affine *index_to_world, murk_error *err);

/* What the head of such a file holds: its creator, as OpenVDB writes it. */
#define MURK_GRID_MARK "creator\6\0\0\0string\4\0\0\0murk"

#endif
