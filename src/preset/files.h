/* The files under media/ that are built into the library: presets (yaml) and
 * their tables (csv). Written by cmake/built_in_files.cmake. */
#ifndef MURK_PRESET_FILES_H
#define MURK_PRESET_FILES_H

#include <stddef.h>

typedef struct murk_media_file {
    const char *name; /* "fog/kruse.yaml" */
    const char *text; /* with a '\0' behind it */
    size_t size;      /* without it */
} murk_media_file;

/* In the order of their names. */
extern const murk_media_file murk_media_files[];
extern const size_t murk_media_files_count;

/* The file of that name, or NULL. */
const murk_media_file *murk_media_file_find(const char *name);

#endif
