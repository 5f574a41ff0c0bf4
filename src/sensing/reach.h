/* The points of a grid that lie in free space. For use inside src/sensing only.
 *
 * Free space is the space that light reaches: points joined to a lamp (or, for
 * distant light, to an open side of the domain) by an unblocked straight
 * segment, and then all points that unblocked steps between grid neighbours
 * lead to. The result is a closure, so it does not depend on the order of the
 * steps or on threads. */
#ifndef MURK_SENSING_REACH_H
#define MURK_SENSING_REACH_H

#include "base/status.h"
#include "sensing/candidate_request.h"
#include "sensing/free_segments.h"

#include <stdint.h>

typedef struct murk_free_space {
    murk_free_segments segments; /* the tests that decide on reach */
    const murk_reach *reach;     /* borrowed */
    murk_vec3 *place; /* [places] from which the light of lamps starts
                         (sensing/lamp.h) */
    size_t places;
    uint8_t *closeness;   /* [points] murk_closeness */
    uint8_t *is_reached;  /* [points] */
    uint8_t *is_doubtful; /* [points] unreached, although a diagonal step from a
                             reached point is open */
} murk_free_space;

/* Finds the free space of a grid that murk_candidate_desc_check() accepts.
 * Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. Call murk_free_space_release()
 * also after a failure. */
murk_status murk_free_space_find(murk_free_space *out,
                                 const murk_candidate_grid *grid,
                                 const murk_surfaces *surfaces,
                                 const murk_reach *reach, unsigned threads,
                                 const char *where, murk_error *err);
void murk_free_space_release(murk_free_space *space);

#endif
