/* Finds a built-in file by name. The files themselves are in a source file that
 * the build writes (cmake/built_in_files.cmake). */
#include "preset/files.h"

#include <string.h>

const murk_media_file *murk_media_file_find(const char *name)
{
    for (size_t i = 0; i < murk_media_files_count; ++i) {
        if (strcmp(murk_media_files[i].name, name) == 0) {
            return &murk_media_files[i];
        }
    }
    return NULL;
}
