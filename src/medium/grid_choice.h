/* Which grid of a file is meant, and whether it can be a density or an albedo:
 * the choice that medium/grid.h states, by names and kinds alone.
 *
 * Inside this room only; plain C for both sides of the bridge. */
#ifndef MURK_MEDIUM_GRID_CHOICE_H
#define MURK_MEDIUM_GRID_CHOICE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_grid_entry {
    const char *unique; /* "density[1]" where names repeat */
    const char *name;
    const char *type; /* of its values, as OpenVDB calls it */
    bool is_level_set;
    bool is_linear; /* its transform */
} murk_grid_entry;

/* *chosen of entry[n] by `name`, NULL: whichever is meant without one. Fails
 * at `where` with MURK_BAD_FILE where there is none at all, with
 * MURK_BAD_VALUE where none or several fit, or the one that does is no field
 * of numbers between faces that are planes. */
murk_status murk_grid_choose(size_t *chosen, const murk_grid_entry *entry,
                             size_t n, const char *name, const char *where,
                             murk_error *err);

#endif
