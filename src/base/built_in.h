/* Files whose bytes are built into the library or the program.
 *
 * cmake/built_in_files.cmake writes a source file that defines a list; the
 * header of the folder of src that the list belongs to declares it. */
#ifndef MURK_BASE_BUILT_IN_H
#define MURK_BASE_BUILT_IN_H

#include <stddef.h>

typedef struct murk_built_in_file {
    const char *name; /* below the folder of the list, "fog/kruse.yaml" */
    const char *text; /* followed by '\0' */
    size_t size;      /* without the '\0' */
} murk_built_in_file;

typedef struct murk_built_in {
    const murk_built_in_file *file; /* [n] sorted by name */
    size_t n;
} murk_built_in;

/* The file with that name; NULL: the list has none. */
const murk_built_in_file *murk_built_in_find(const murk_built_in *list,
                                             const char *name);

#endif
