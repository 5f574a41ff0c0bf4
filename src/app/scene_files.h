/* The files under scenes/ that are built into the program: the scenes to start
 * from (start/NAME.yaml). cmake/built_in_files.cmake writes the source file
 * with their text. */
#ifndef MURK_APP_SCENE_FILES_H
#define MURK_APP_SCENE_FILES_H

#include <stddef.h>

typedef struct murk_scene_file {
    const char *name; /* "start/room.yaml" */
    const char *text; /* followed by '\0' */
    size_t size;      /* without the '\0' */
} murk_scene_file;

/* All files, sorted by name. */
extern const murk_scene_file murk_scene_files[];
extern const size_t murk_scene_files_count;

/* Returns the file with that name, or NULL. */
const murk_scene_file *murk_scene_file_find(const char *name);

#endif
