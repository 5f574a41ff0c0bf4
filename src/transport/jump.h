/* Jumps of a ray through free heights of a periodic domain: heights with no
 * surface, no bounded region and no lamp, where nothing depends on x and y.
 * However often it would wrap there, it gets through in one leg. Private to
 * this room. */
#ifndef MURK_TRANSPORT_JUMP_H
#define MURK_TRANSPORT_JUMP_H

#include "transport/walker.h"

/* The heights that are not free, as [n][2] bounds; *out is the caller's:
 * free(). NULL and 0 where the domain is not periodic. */
murk_status murk_jump_heights(double (**out)[2], size_t *n,
                              const murk_transport_world *world,
                              murk_error *err);

/* How far a jump leads; 0: the ray has not wrapped often enough since its last
 * event, or the way to the next height that is not free is short. */
double murk_jump_ahead(const murk_walker *w);

/* Goes so far, tells the leg and one wrap: the event's position is where the
 * leg ends, outside of the domain, and the next leg begins at its image. */
void murk_jump(murk_walker *w, double length_m);

#endif
