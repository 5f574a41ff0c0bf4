/* The files that Assimp may open: regular ones, for reading, and of those that
 * a mesh names only what lies in the mesh's folder or in one that the user
 * allows, by any path or link. A pipe or device named in a mesh cannot make the
 * reader wait. */
#ifndef MURK_GEOMETRY_IMPORT_FILES_H
#define MURK_GEOMETRY_IMPORT_FILES_H

#include <assimp/cfileio.h>

#include <limits.h>
#include <stddef.h>

/* Paths are without links; what cannot be resolved is empty, allows nothing. */
typedef struct murk_import_reach {
    char mesh[PATH_MAX], folder[PATH_MAX];
    char allowed[PATH_MAX]; /* empty: no other folder */
    char refused[PATH_MAX]; /* the first file outside that was asked for */
} murk_import_reach;

/* The mesh's own file, where it is read from memory instead, and where others
 * may be. */
typedef struct murk_import_source {
    const char *path;
    char *bytes; /* NULL: from the disk */
    size_t size;
    double shift[3]; /* subtracted from its vertices, in its own units */
    murk_import_reach reach;
} murk_import_source;

/* Its vertices are brought near 0 where they are far (import_shift.h). Nothing
 * is freed: a child process reads one mesh and ends. allow: a folder beside the
 * mesh's own that may be opened, or NULL. */
void murk_import_source_of(murk_import_source *out, const char *path,
                           const char *allow);

struct aiFileIO murk_import_files(murk_import_source *source);

#endif
