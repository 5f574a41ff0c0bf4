/* Checksums of the files that a scene names. They tell apart two scenes with
 * the same text but with files of different contents. The folder and name of a
 * file do not enter the checksum, so a scene has the same checksums in any
 * folder and on any machine. */
#ifndef MURK_WORLD_FILE_SUMS_H
#define MURK_WORLD_FILE_SUMS_H

#include "scene/scene.h"

#include <stdint.h>
#include <stdio.h>

/* The largest file that a checksum is made of: far above real meshes and grids,
 * but a sparse file of terabytes must not stall a run. */
#define MURK_SUM_BYTES_MAX (UINT64_C(8) << 30)

/* A cache of checksums by path, so that each file is read once. Begins as
 * zeros. murk_file_sums_release() frees the contents and sets them to zero
 * again. */
typedef struct murk_file_sums {
    size_t n;
    char **path, (*sum)[33];
} murk_file_sums;

void murk_file_sums_release(murk_file_sums *sums);

/* Prints one line with the checksum of a file to out. The line has "-" in place
 * of a checksum if path is NULL, or if the file cannot be read or is larger
 * than MURK_SUM_BYTES_MAX; no error is reported then. Returns false, and prints
 * nothing, when out of memory. */
bool murk_file_sums_put(FILE *out, murk_file_sums *sums, const char *path);

/* Prints a line of murk_file_sums_put() for each file that the scene names, and
 * two more lines for each medium: for the file of the density grid and for that
 * of the albedo grid, with "-" if the medium has no such grid. Lines for the
 * data files of an FDS run come after those of its medium. The lines of
 * each condition of the scene follow in the same way. Returns false when out of
 * memory. */
bool murk_file_sums_scene(FILE *out, murk_file_sums *sums,
                          const murk_scene_desc *scene);

/* The lines of murk_file_sums_scene() as a text, which the caller frees; NULL
 * when out of memory. */
char *murk_file_sums_print(const murk_scene_desc *scene);

#endif
