/* Points sorted into cubic cells, to find those near a place as they come:
 * for dropping what lies too near to something listed before.
 *
 * The points themselves stay with the caller, who knows them by number: the
 * order in which they were added, from 0. Eight bytes a point and as many
 * again for the table. */
#ifndef MURK_BASE_CELLS_H
#define MURK_BASE_CELLS_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>

typedef struct murk_cells murk_cells;

/* size_m > 0: the side of a cell. *out is the caller's: murk_cells_destroy().
 * Fails with MURK_NO_MEMORY. */
murk_status murk_cells_create(murk_cells **out, double size_m, murk_error *err);
void murk_cells_destroy(murk_cells *cells); /* NULL is fine */

/* Fails with MURK_NO_MEMORY, and beyond 2^32 - 1 points. */
murk_status murk_cells_add(murk_cells *cells, murk_vec3 point, murk_error *err);

/* True ends the search. */
typedef bool (*murk_cells_meet)(void *context, size_t number);

/* Calls meet() for every point in the cells that the cube of half side
 * radius_m <= size_m about `point` touches, newest first in each; others may
 * come too, and a point twice. Whether a call ended the search. */
bool murk_cells_search(const murk_cells *cells, murk_vec3 point,
                       double radius_m, murk_cells_meet meet, void *context);

#endif
