/* Which points of a grid lie in free space. Internal to the room.
 *
 * Free space is what light reaches: a point that a lamp (or an open side of
 * the domain, for distant light) has an unblocked straight way to, and then
 * whatever unblocked steps between grid neighbours lead to. The answer is a
 * closure, so it does not depend on the order of steps or on threads.
 *
 * A ray aimed exactly at a seam of a mesh may slip through (one in 500, where a
 * vertex lies on another triangle's edge), and grids and walls at round
 * coordinates do aim so. A way is therefore open only
 * when two more, their far end moved aside by half a hair, are open too. */
#ifndef MURK_SENSING_REACH_H
#define MURK_SENSING_REACH_H

#include "base/status.h"
#include "sensing/candidates.h"

#include <stdint.h>

typedef enum murk_closeness {
    MURK_CLEAR_OF_SURFACES,
    MURK_BARELY_CLEAR, /* nothing within a hair, something within two */
    MURK_TOO_CLOSE,    /* for the clearance asked for */
    MURK_ON_SURFACE    /* within a hair: sees nothing, and no way leads there */
} murk_closeness;

typedef struct murk_free_space {
    uint8_t *closeness;  /* [points] murk_closeness */
    uint8_t *is_reached; /* [points] */
    size_t doubtful;     /* unreached, but for an open diagonal step */
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
