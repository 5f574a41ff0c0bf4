/* Jumps of a ray through free heights of a periodic domain: heights without
 * surfaces, bounded regions and lamps, at which nothing depends on x and y. The
 * ray passes these heights in one segment, however often it would wrap there.
 * For use inside src/transport only. */
#ifndef MURK_TRANSPORT_JUMP_H
#define MURK_TRANSPORT_JUMP_H

#include "transport/walker.h"

/* Lists the ranges of heights that are not free, as [n][2] bounds; NULL and 0
 * if the domain is not periodic. The caller frees *out. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_jump_heights(double (**out)[2], size_t *n,
                              const murk_transport_world *world,
                              murk_error *err);

/* The length [m] of a jump from the present position to the next height that is
 * not free, or to the top or bottom of the domain. 0 means no jump: jumps are
 * switched off (murk_walk_setup in transport/walker.h), or the ray has wrapped
 * less than WRAPS_BEFORE times (transport/jump.c) since the last other event,
 * is exactly level, is at a height that is not free, or would pass at most
 * MIN_PERIODS periods in x and in y. */
double murk_jump_ahead(const murk_walker *w);

/* Moves the photon, scores the segment and reports one wrap. The position of
 * the event is the end of the segment, which may lie outside of the domain; the
 * next segment begins at the image of this position inside. */
void murk_jump(murk_walker *w, double length_m);

#endif
