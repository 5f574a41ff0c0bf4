/* Free space (sensing/candidates.h) for arbitrary points.
 *
 * A point is in free space if one unblocked straight segment joins it to a lamp
 * (sensing/lamp.h), or to a reached point of a grid: a corner of the grid cell
 * around the point, or of the cells next to that. So the gap between a shelf
 * and a wall is free, and the inside of a crate is not; points deep in gaps
 * narrower than the grid spacing may be missed.
 *
 * Immutable after creation: any number of threads may call
 * murk_open_space_holds(). */
#ifndef MURK_SENSING_OPEN_SPACE_H
#define MURK_SENSING_OPEN_SPACE_H

#include "sensing/candidate_request.h"

/* The largest number of grids. Callers use one over the domain, and the grid of
 * candidates of the scene. */
#define MURK_OPEN_SPACE_GRIDS 2

typedef struct murk_open_space murk_open_space;

/* Uses 1..MURK_OPEN_SPACE_GRIDS grids within the domain; their clearance is not
 * used. Borrows the surfaces. The caller destroys *out. Fails at `where` with
 * MURK_NO_MEMORY, or with MURK_INTERRUPTED. */
murk_status murk_open_space_create(murk_open_space **out,
                                   const murk_candidate_grid *grid,
                                   size_t n_grids,
                                   const murk_surfaces *surfaces,
                                   const murk_reach *reach, unsigned threads,
                                   const char *where, murk_error *err);
void murk_open_space_destroy(murk_open_space *space); /* accepts NULL */

/* True if `point` is in free space. The point must lie in the domain and off
 * any surface. For a point just off a surface (murk_surfaces_leave()) `normal`
 * points to that side, and segments must start towards it; otherwise normal is
 * zero. */
bool murk_open_space_holds(const murk_open_space *space, murk_vec3 point,
                           murk_vec3 normal);

#endif
