/* Finds a built-in file by comparing the name with each name of the list in
 * turn, because a list has a few dozen names only. */
#include "base/built_in.h"

#include <string.h>

const murk_built_in_file *murk_built_in_find(const murk_built_in *list,
                                             const char *name)
{
    for (size_t i = 0; i < list->n; ++i) {
        if (strcmp(list->file[i].name, name) == 0) {
            return &list->file[i];
        }
    }
    return NULL;
}
