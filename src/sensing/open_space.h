/* Free space (sensing/candidates.h), asked of any point.
 *
 * A point lies in it when one unblocked straight way leads from it to where
 * light starts, or to a reached point of a grid: those at the corners of the
 * grid's cell around it, and of the cells next to that. So the gap between a
 * shelf and its wall is free, the inside of a crate is not; deep in what is
 * narrower than the grid is fine, points may be missed.
 *
 * Immutable after creation: any number of threads may ask. */
#ifndef MURK_SENSING_OPEN_SPACE_H
#define MURK_SENSING_OPEN_SPACE_H

#include "sensing/candidates.h"

#define MURK_OPEN_SPACE_GRIDS 2

typedef struct murk_open_space murk_open_space;

/* By 1..MURK_OPEN_SPACE_GRIDS grids within the domain, their clearance unused.
 * Borrows the surfaces. *out is the caller's: murk_open_space_destroy(). Fails
 * at `where` with MURK_NO_MEMORY, or with MURK_INTERRUPTED. */
murk_status murk_open_space_create(murk_open_space **out,
                                   const murk_candidate_grid *grid,
                                   size_t n_grids,
                                   const murk_surfaces *surfaces,
                                   const murk_reach *reach, unsigned threads,
                                   const char *where, murk_error *err);
void murk_open_space_destroy(murk_open_space *space); /* NULL is fine */

/* `point` in the domain, off any surface: just off one, as
 * murk_surfaces_leave() is, with its normal to that side, which ways must go
 * to; elsewhere with normal zero. */
bool murk_open_space_holds(const murk_open_space *space, murk_vec3 point,
                           murk_vec3 normal);

#endif
