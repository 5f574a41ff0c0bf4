/* The free space of a scene: whether light can reach a point
 * (sensing/open_space.h), by one grid over the domain and one over the grid of
 * candidates that the scene gives; the share of a box or a ball that is free;
 * and the places through which light enters. */
#ifndef MURK_PLAN_FREE_SPACE_H
#define MURK_PLAN_FREE_SPACE_H

#include "base/stats.h"
#include "sensing/candidates.h"
#include "sensing/open_space.h"
#include "world/stage.h"

/* The places through which light enters the free space of a scene: lamps,
 * portals, and the open sides of the domain for sun, sky and directional light.
 * Candidate sites are usable if light can reach them from there
 * (sensing/candidates.h). Sources that do not emit at the time of the scene are
 * included, because the usable sites should not depend on the hour.
 *
 * Sets *out. *places is the array that out->lamps points to; the caller owns
 * it: free(). where is the place in the scene for an out-of-memory message. */
murk_status murk_entrances(murk_reach *out, murk_vec3 **places,
                           const murk_stage *stage, const char *where,
                           murk_error *err);

/* The caller owns *out (murk_open_space_destroy()). Fails as
 * murk_open_space_create(). */
murk_status murk_stage_free_space(murk_open_space **out,
                                  const murk_stage *stage, unsigned threads,
                                  murk_error *err);

typedef struct murk_part {
    bool is_ball;
    murk_box box; /* of a ball: the bounding box */
    murk_vec3 center;
    double radius_m;
    uint32_t number; /* addresses the random numbers of this part */
} murk_part;

/* The share (0..1) of the part that lies in free space, by stratified sampling:
 * one random point in each of equal cells. The stated error is that of
 * independent points, an upper bound. space NULL means that nothing obstructs
 * the part: the share is 1. If no random point lies in a ball, the share is 0.
 */
murk_estimate murk_free_share(const murk_part *part,
                              const murk_open_space *space, uint32_t seed,
                              unsigned threads);

#endif
