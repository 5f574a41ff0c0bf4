/* Sets of files in memory: lists of names and of files that count the sets that
 * contain them. */
#include "base/memory_files.h"

#include "base/host.h"

#include <stdlib.h>
#include <string.h>

static void drop(murk_memory_file *file)
{
    if (--file->sets == 0) {
        file->release(file->data);
        free(file);
    }
}

static size_t index_of(const murk_memory_files *set, const char *name)
{
    size_t i = 0;
    while (i < set->n && strcmp(set->name[i], name) != 0) {
        ++i;
    }
    return i;
}

static bool is_name(const char *name)
{
    const size_t length = strlen(name);
    return length > 0 && length < MURK_MEMORY_NAME_SIZE &&
           strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                        "0123456789._-") == length;
}

/* Makes space for one more file; false when out of memory. */
static bool grow(murk_memory_files *set)
{
    void *name = realloc(set->name, (set->n + 1) * sizeof *set->name);
    if (!name) {
        return false;
    }
    set->name = name;
    void *file = realloc(set->file, (set->n + 1) * sizeof(murk_memory_file *));
    if (!file) {
        return false;
    }
    set->file = file;
    return true;
}

murk_status murk_memory_add(murk_memory_files *set, const char *name,
                            murk_memory_file file, murk_error *err)
{
    if (!is_name(name)) {
        file.release(file.data);
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "must be 1 to %d letters, digits, '.', '_' and '-'",
                         MURK_MEMORY_NAME_SIZE - 1);
    }
    const size_t i = index_of(set, name);
    murk_memory_file *added = malloc(sizeof *added);
    if (!added || (i == set->n && !grow(set))) {
        file.release(file.data);
        free(added);
        return murk_no_memory(err, name, "for the array");
    }
    /* Replace the file of that name, or append one. */
    *added = file;
    added->sets = 1;
    if (i < set->n) {
        drop(set->file[i]);
    } else {
        memcpy(set->name[i], name, strlen(name) + 1);
        ++set->n;
    }
    set->file[i] = added;
    return MURK_OK;
}

bool murk_memory_copy(murk_memory_files *out, const murk_memory_files *set)
{
    *out = (murk_memory_files){0};
    for (size_t i = 0; i < set->n; ++i) {
        if (!grow(out)) {
            murk_memory_release(out);
            return false;
        }
        memcpy(out->name[i], set->name[i], sizeof *out->name);
        out->file[i] = set->file[i];
        ++out->file[i]->sets;
        ++out->n;
    }
    return true;
}

void murk_memory_release(murk_memory_files *set)
{
    for (size_t i = 0; i < set->n; ++i) {
        drop(set->file[i]);
    }
    free(set->name);
    free(set->file);
    *set = (murk_memory_files){0};
}

bool murk_memory_is(const char *path)
{
    return strncmp(path, MURK_MEMORY_PREFIX, strlen(MURK_MEMORY_PREFIX)) == 0;
}

const murk_memory_file *murk_memory_at(const char *path)
{
    const murk_memory_files *set = murk_host_now()->files;
    if (!set || !murk_memory_is(path)) {
        return NULL;
    }
    const size_t i = index_of(set, path + strlen(MURK_MEMORY_PREFIX));
    return i < set->n ? set->file[i] : NULL;
}

murk_status murk_memory_find(const murk_memory_file **out, const char *path,
                             murk_memory_kind kind, const char *where,
                             murk_error *err)
{
    static const char *const names[] = {[MURK_MEMORY_MESH] = "mesh",
                                        [MURK_MEMORY_GRID] = "grid",
                                        [MURK_MEMORY_TABLE] = "table"};
    const murk_memory_file *file = murk_memory_at(path);
    if (!file || file->kind != kind) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s: no %s of that name was added to the scene", path,
                         names[kind]);
    }
    *out = file;
    return MURK_OK;
}
