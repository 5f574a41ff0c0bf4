/* A hash table of points in cubic cells, for finding the points near a place
 * while points are being added: callers drop a new point that lies too near to
 * an earlier one.
 *
 * The caller stores the points. A point is known by a number, the order in
 * which it was added, from 0. The table takes 16 to 32 bytes for each point,
 * and at least 4 kB. */
#ifndef MURK_BASE_CELLS_H
#define MURK_BASE_CELLS_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>

typedef struct murk_cells murk_cells;

/* size_m > 0 is the side of a cell. The caller destroys *out with
 * murk_cells_destroy(). Fails with MURK_NO_MEMORY. */
murk_status murk_cells_create(murk_cells **out, double size_m, murk_error *err);
void murk_cells_destroy(murk_cells *cells); /* NULL is fine */

/* Adds a point. Fails with MURK_NO_MEMORY, also beyond 2^32 - 1 points. */
murk_status murk_cells_add(murk_cells *cells, murk_vec3 point, murk_error *err);

/* Called with the number of a point; true ends the search. */
typedef bool (*murk_cells_visit)(void *context, size_t number);

/* Calls visit() for every point in the cells that the cube of half side
 * radius_m <= size_m about `point` touches. In each cell the newest point comes
 * first. visit() may also receive points of other cells, and a point twice.
 * Returns true if a call of visit() ended the search. */
bool murk_cells_search(const murk_cells *cells, murk_vec3 point,
                       double radius_m, murk_cells_visit visit, void *context);

#endif
