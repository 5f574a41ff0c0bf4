/* Finds a built-in file of scenes/ by name. The files themselves are in a
 * source file that the build writes (cmake/built_in_files.cmake). */
#include "app/scene_files.h"

#include <string.h>

const murk_scene_file *murk_scene_file_find(const char *name)
{
    for (size_t i = 0; i < murk_scene_files_count; ++i) {
        if (strcmp(murk_scene_files[i].name, name) == 0) {
            return &murk_scene_files[i];
        }
    }
    return NULL;
}
