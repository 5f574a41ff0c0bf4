/* The files that Assimp may open: regular files, for reading only. Of the files
 * that a mesh names, only those in or below the mesh's own folder or a folder
 * that the user allows may be opened, whatever path or link leads there. A pipe
 * or device named in a mesh cannot make the reader wait. */
#ifndef MURK_GEOMETRY_IMPORT_FILES_H
#define MURK_GEOMETRY_IMPORT_FILES_H

#include <assimp/cfileio.h>

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

/* Paths after resolution of links. A path that cannot be resolved is empty
 * and allows nothing. */
typedef struct murk_import_access {
    char mesh[PATH_MAX], folder[PATH_MAX];
    char allowed[PATH_MAX]; /* empty: no further folder is allowed */
    char refused[PATH_MAX]; /* the first file outside of the allowed folders
                               that was requested */
} murk_import_access;

/* The mesh file itself, possibly rewritten in memory, and the access rules
 * for other files. */
typedef struct murk_import_source {
    const char *path;
    char *bytes; /* NULL: read from the disk */
    size_t size;
    bool
        names_others; /* another file was asked for, whether or not it exists */
    double shift[3];  /* subtracted from the vertices, in the file's units and
                       * axes */
    murk_import_access access;
} murk_import_source;

/* Prepares the mesh file at `path`, which must outlive *out. Vertices far from
 * the origin are shifted towards 0 if the format permits it, OBJ or PLY
 * (geometry/import_shift.h). `allow` is a further folder whose files may be
 * opened, besides the folder of the mesh, or NULL. out->bytes belongs to the
 * caller (free()). */
void murk_import_source_of(murk_import_source *out, const char *path,
                           const char *allow);

/* Assimp's file interface for a source. The source must outlive the
 * interface. */
struct aiFileIO murk_import_files(murk_import_source *source);

#endif
