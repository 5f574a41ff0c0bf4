/* Which points of a grid lie in free space. Internal to the room.
 *
 * Free space is what light reaches: a point that a lamp (or an open side of
 * the domain, for distant light) has an unblocked straight way to, and then
 * whatever unblocked steps between grid neighbours lead to. The answer is a
 * closure, so it does not depend on the order of steps or on threads. */
#ifndef MURK_SENSING_REACH_H
#define MURK_SENSING_REACH_H

#include "base/status.h"
#include "sensing/candidates.h"
#include "sensing/ways.h"

#include <stdint.h>

typedef struct murk_free_space {
    uint8_t *closeness;  /* [points] murk_closeness */
    uint8_t *is_reached; /* [points] */
    uint8_t
        *is_doubtful; /* [points] unreached, but for an open diagonal step */
} murk_free_space;

/* Fills *out for a grid already checked. Fails with MURK_NO_MEMORY or
 * MURK_INTERRUPTED, leaving nothing to release. */
murk_status murk_free_space_find(murk_free_space *out,
                                 const murk_candidate_grid *grid,
                                 const murk_surfaces *surfaces,
                                 const murk_reach *reach, unsigned threads,
                                 const char *where, murk_error *err);
void murk_free_space_release(murk_free_space *space);

#endif
