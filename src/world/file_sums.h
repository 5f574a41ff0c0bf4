/* Checksums of the files that a scene names: what tells two scenes apart that
 * read alike. Files count by their contents alone, so that a scene gives the
 * same checksums in any folder and on any machine. */
#ifndef MURK_WORLD_FILE_SUMS_H
#define MURK_WORLD_FILE_SUMS_H

#include "scene/scene.h"

#include <stdio.h>

/* The files met so far, each of which is read once. Begins as zeros. */
typedef struct murk_file_sums {
    size_t n;
    char **path, (*sum)[33];
} murk_file_sums;

void murk_file_sums_release(murk_file_sums *sums);

/* Prints a line with the checksum of one file: "-" for NULL, and for a file
 * that cannot be read, which its reader will refuse. False when out of memory.
 */
bool murk_file_sums_put(FILE *out, murk_file_sums *sums, const char *path);

/* Such a line for each file that the scene and its conditions name. */
bool murk_file_sums_scene(FILE *out, murk_file_sums *sums,
                          const murk_scene_desc *scene);

#endif
