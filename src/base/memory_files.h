/* Files in memory: meshes, grids and tables that the caller of the library
 * gives as arrays. A path "memory:NAME" names one of them wherever a scene
 * takes a file.
 *
 * The host of the calling thread (base/host.h) has the set that such paths are
 * looked up in; code that reads the files of a scene asks here first. A file is
 * shared by the sets that contain the file, and is destroyed with the last of
 * these sets. */
#ifndef MURK_BASE_MEMORY_FILES_H
#define MURK_BASE_MEMORY_FILES_H

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

#define MURK_MEMORY_PREFIX    "memory:"
#define MURK_MEMORY_NAME_SIZE 64 /* of a name with the '\0' */

/* The kinds of files, by the type of murk_memory_file.data. */
typedef enum murk_memory_kind {
    MURK_MEMORY_MESH, /* murk_mesh (geometry/mesh.h): triangles */
    MURK_MEMORY_GRID, /* murk_grid_samples (medium/grid.h): dense samples */
    MURK_MEMORY_TABLE /* char[]: the text of a table, ended by '\0' */
} murk_memory_kind;

typedef struct murk_memory_file {
    murk_memory_kind kind;
    size_t sets; /* number of sets that contain the file */
    uint64_t checksum[2];
    void *data; /* of the type that the kind states */
    void (*release)(void *data);
} murk_memory_file;

typedef struct murk_memory_files {
    size_t n;
    char (*name)[MURK_MEMORY_NAME_SIZE]; /* [n] */
    murk_memory_file **file;             /* [n] */
} murk_memory_files;

/* Adds a file, or replaces the file of that name; file.sets is ignored. Takes
 * ownership of file.data, which file.release() releases, also on failure. Fails
 * with MURK_BAD_VALUE if the name is empty, too long, or contains characters
 * other than ASCII letters, digits, '.', '_' and '-', or with MURK_NO_MEMORY.
 */
murk_status murk_memory_add(murk_memory_files *set, const char *name,
                            murk_memory_file file, murk_error *err);

/* Makes *out, whose old content is ignored, a set of the same files. Returns
 * false and makes *out empty when out of memory. murk_memory_release() empties
 * a set. */
bool murk_memory_copy(murk_memory_files *out, const murk_memory_files *set);
void murk_memory_release(murk_memory_files *set);

/* True if the path begins with "memory:". */
bool murk_memory_is(const char *path);

/* The file of a path in the set of the host. Fails with MURK_BAD_FILE at
 * `where` if there is none of that name and kind. */
murk_status murk_memory_find(const murk_memory_file **out, const char *path,
                             murk_memory_kind kind, const char *where,
                             murk_error *err);

/* The file of a path, of any kind, in the set of the host; NULL if there is
 * none. The set owns the file. */
const murk_memory_file *murk_memory_at(const char *path);

#endif
