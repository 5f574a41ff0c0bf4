/* The files under media/ that are built into the library: presets (yaml) and
 * tables (csv). cmake/built_in_files.cmake writes the source file with their
 * text. */
#ifndef MURK_PRESET_FILES_H
#define MURK_PRESET_FILES_H

#include <stddef.h>

typedef struct murk_media_file {
    const char *name; /* e.g. "fog/kruse.yaml" */
    const char *text; /* followed by '\0' */
    size_t size;      /* without the '\0' */
} murk_media_file;

/* All files, sorted by name. */
extern const murk_media_file murk_media_files[];
extern const size_t murk_media_files_count;

/* Returns the file with that name, or NULL. */
const murk_media_file *murk_media_file_find(const char *name);

#endif
