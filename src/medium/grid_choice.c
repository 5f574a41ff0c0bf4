/* Selects a grid of an OpenVDB file by name and kind (medium/grid.h states
 * the rules), with messages that list the grids of the file. */
#include "medium/grid_choice.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

/* A list in a message gets no further entry beyond this many bytes, which are
 * enough to recognise the wanted grid. */
#define ENOUGH_LISTED 400
#define MAX_LISTED    (ENOUGH_LISTED + 200) /* with space for one more entry */

static bool is_float(const murk_grid_entry *entry)
{
    return strcmp(entry->type, "float") == 0 ||
           strcmp(entry->type, "double") == 0;
}

static bool is_density(const murk_grid_entry *entry)
{
    return is_float(entry) && !entry->is_level_set;
}

/* Lists the grids for a message, such as "density (float), temperature (float),
 * ...". */
static void list(char text[MAX_LISTED], const murk_grid_entry *entry, size_t n)
{
    size_t used = 0;
    for (size_t i = 0; i < n; ++i) {
        if (used > ENOUGH_LISTED) {
            memcpy(text + used, ", ...", sizeof ", ...");
            return;
        }
        const int length =
            snprintf(text + used, MAX_LISTED - used, "%s%.100s (%.60s)",
                     i ? ", " : "", entry[i].unique,
                     entry[i].is_level_set ? "level set" : entry[i].type);
        used += length > 0 ? (size_t)length : 0;
    }
}

/* The number of matching entries, and the first of them. */
typedef struct found {
    size_t n, first;
} found;

static void count_in(found *all, size_t i)
{
    all->first = all->n == 0 ? i : all->first;
    ++all->n;
}

/* The entries with a name. A unique name such as "density[1]" selects one
 * entry; a plain name may match several. */
static found those_named(const murk_grid_entry *entry, size_t n,
                         const char *name)
{
    found all = {0, 0};
    for (size_t i = 0; i < n; ++i) {
        if (strcmp(entry[i].unique, name) == 0) {
            return (found){1, i};
        }
        if (strcmp(entry[i].name, name) == 0) {
            count_in(&all, i);
        }
    }
    return all;
}

/* The entries selected without a name: the only density, or the one named
 * `density`; or, if there is no density, the only grid, which check_kind() then
 * refuses with a message that names its kind. */
static found those_meant(const murk_grid_entry *entry, size_t n)
{
    found all = {0, 0};
    for (size_t i = 0; i < n; ++i) {
        if (is_density(&entry[i])) {
            count_in(&all, i);
        }
    }
    if (all.n > 1) {
        const found named = those_named(entry, n, "density");
        return named.n > 0 ? named : all;
    }
    return all.n == 0 && n == 1 ? (found){1, 0} : all;
}

static murk_status check_kind(const murk_grid_entry *entry, const char *where,
                              murk_error *err)
{
    const char *name = entry->unique;
    if (!is_float(entry)) {
        return murk_fail(
            err, MURK_BAD_VALUE, where,
            "grid %.100s holds %.60s, must be float, half or double", name,
            entry->type);
    }
    if (entry->is_level_set) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "grid %.100s is a level set (distances to a "
                         "surface), must be a density",
                         name);
    }
    if (!entry->is_linear) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "grid %.100s has a frustum transform, must be linear",
                         name);
    }
    return MURK_OK;
}

murk_status murk_grid_choose(size_t *chosen, const murk_grid_entry *entry,
                             size_t n, const char *name, const char *where,
                             murk_error *err)
{
    assert(chosen && where);
    if (n == 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "holds no grids: empty, or cut off in its header");
    }
    /* Find the matching entries; exactly one must match. */
    const found all =
        name ? those_named(entry, n, name) : those_meant(entry, n);
    char there[MAX_LISTED];
    list(there, entry, n);
    if (all.n == 0) {
        return name ? murk_fail(err, MURK_BAD_VALUE, where,
                                "no grid named %.100s; there are %s", name,
                                there)
                    : murk_fail(err, MURK_BAD_VALUE, where,
                                "no float grid; there are %s", there);
    }
    if (all.n > 1) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "several grids, choose one by name (such as %.100s) "
                         "among %s",
                         entry[all.first].unique, there);
    }
    *chosen = all.first;
    return check_kind(&entry[all.first], where, err);
}
