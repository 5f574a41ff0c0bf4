/* Lists the data files beside a .smv file by their endings. The .smv file
 * itself is read in a subprocess alone. */
#include "fds/data_files.h"

#include "base/path.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

static bool ends_with(const char *name, const char *ending)
{
    const size_t n = strlen(name), m = strlen(ending);
    return n > m && strcmp(name + n - m, ending) == 0;
}

typedef struct list {
    char **name;
    size_t n, capacity;
} list;

static bool append(list *to, const char *name)
{
    if (to->n == to->capacity) {
        const size_t more = to->capacity ? 2 * to->capacity : 64;
        char **larger = realloc(to->name, more * sizeof *larger);
        if (!larger) {
            return false;
        }
        to->name = larger;
        to->capacity = more;
    }
    to->name[to->n] = strdup(name);
    return to->name[to->n++] != NULL;
}

static int by_name(const void *a, const void *b)
{
    const char *const *p = a, *const *q = b;
    return strcmp(*p, *q);
}

/* Lists the names of data files in a folder. */
static bool list_names(list *to, DIR *folder, bool of_walls)
{
    bool is_whole = true;
    for (const struct dirent *entry = readdir(folder); entry && is_whole;
         entry = readdir(folder)) {
        const char *name = entry->d_name;
        if (of_walls ? ends_with(name, ".ge")
                     : ends_with(name, ".s3d") || ends_with(name, ".sf")) {
            is_whole = append(to, name);
        }
    }
    return is_whole;
}

bool murk_fds_data_files(const char *path, bool of_walls,
                         bool (*add)(void *context, const char *file),
                         void *context)
{
    char *here = murk_path_beside(path, ".");
    DIR *folder = here ? opendir(here) : NULL;
    list names = {0};
    bool is_whole = here && (!folder || list_names(&names, folder, of_walls));
    if (folder) {
        closedir(folder);
    }
    /* Sorted, as the order in a folder is that of chance. */
    if (is_whole && names.n > 0) {
        qsort(names.name, names.n, sizeof *names.name, by_name);
    }
    for (size_t i = 0; i < names.n && is_whole; ++i) {
        char *file = murk_path_beside(path, names.name[i]);
        is_whole = file && add(context, file);
        free(file);
    }
    for (size_t i = 0; i < names.n; ++i) {
        free(names.name[i]);
    }
    free(names.name);
    free(here);
    return is_whole;
}
