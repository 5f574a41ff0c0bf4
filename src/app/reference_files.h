/* The pages of the reference of scene keys (doc/reference) that are built into
 * the program. cmake/built_in_files.cmake writes the source file with their
 * text. */
#ifndef MURK_APP_REFERENCE_FILES_H
#define MURK_APP_REFERENCE_FILES_H

#include <stddef.h>

typedef struct murk_reference_file {
    const char *name; /* "sensors.md" */
    const char *text; /* followed by '\0' */
    size_t size;      /* without the '\0' */
} murk_reference_file;

/* All pages, sorted by name. */
extern const murk_reference_file murk_reference_files[];
extern const size_t murk_reference_files_count;

#endif
