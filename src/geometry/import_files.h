/* The files that Assimp may open: regular ones, for reading. A pipe or device
 * named in a mesh cannot make the reader wait. */
#ifndef MURK_GEOMETRY_IMPORT_FILES_H
#define MURK_GEOMETRY_IMPORT_FILES_H

#include <assimp/cfileio.h>

#include <stddef.h>

/* The mesh's own file, where it is read from memory instead. */
typedef struct murk_import_source {
    const char *path;
    char *bytes; /* NULL: from the disk */
    size_t size;
    double shift[3]; /* subtracted from its vertices, in its own units */
} murk_import_source;

/* Its vertices are brought near 0 where they are far (import_shift.h). Nothing
 * is freed: a child process reads one mesh and ends. */
murk_import_source murk_import_source_of(const char *path);

struct aiFileIO murk_import_files(murk_import_source *source);

#endif
