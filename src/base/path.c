/* Joins and takes apart file paths as text; the files need not exist. */
#include "base/path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *murk_path_beside(const char *beside, const char *path)
{
    const char *slash = strrchr(beside, '/');
    if (path[0] == '/' || !slash) {
        return strdup(path);
    }
    const size_t folder = (size_t)(slash - beside) + 1;
    char *out = malloc(folder + strlen(path) + 1);
    if (out) {
        memcpy(out, beside, folder);
        strcpy(out + folder, path);
    }
    return out;
}

char *murk_path_join(const char *folder, const char *name)
{
    const size_t size = strlen(folder) + strlen(name) + 2;
    const size_t length = strlen(folder);
    const char *slash = length > 0 && folder[length - 1] == '/' ? "" : "/";
    char *path = malloc(size);
    if (path) {
        snprintf(path, size, "%s%s%s", folder, slash, name);
    }
    return path;
}

const char *murk_path_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}
