/* Selects a grid of a file by name and kind, as medium/grid.h describes, and
 * checks that it can be a density or an albedo.
 *
 * For use inside src/medium only; plain C, which vdb_bridge.cpp includes, too.
 */
#ifndef MURK_MEDIUM_GRID_CHOICE_H
#define MURK_MEDIUM_GRID_CHOICE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_grid_entry {
    const char *unique; /* "density[1]" if names repeat */
    const char *name;
    const char *type; /* type of the values, as OpenVDB calls it */
    bool is_level_set;
    bool is_linear; /* the transform is linear */
} murk_grid_entry;

/* Sets *chosen to the index of the selected entry of entry[n]. `name` may be
 * NULL. Fails at `where` with MURK_BAD_FILE if there is no grid, and with
 * MURK_BAD_VALUE if none or several match, or if the selected grid has values
 * other than float or double, is a level set, or has a transform that is not
 * linear. */
murk_status murk_grid_choose(size_t *chosen, const murk_grid_entry *entry,
                             size_t n, const char *name, const char *where,
                             murk_error *err);

#endif
