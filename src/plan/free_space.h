/* The free space of a scene: whether light can reach a point
 * (sensing/open_space.h), by one grid over the domain and, if the scene gives a
 * grid of candidates within the domain, a second grid over that; the share of a
 * box or a ball that is free; and the places through which light enters. */
#ifndef MURK_PLAN_FREE_SPACE_H
#define MURK_PLAN_FREE_SPACE_H

#include "base/stats.h"
#include "sensing/candidates.h"
#include "sensing/open_space.h"
#include "world/stage.h"

/* The places through which light enters the free space of a scene: lamps,
 * portals, and the open sides of the domain for distant light (sun, moon, sky
 * and directional light). Candidate sites are usable only if light can reach
 * them from these places (sensing/candidates.h). Sources that do not emit at
 * the time of the scene are included, because the usable sites should not
 * depend on the hour.
 *
 * Sets *out. *places is the array that out->lamps points to; the caller frees
 * *places with free(). Fails with MURK_NO_MEMORY at `where`. */
murk_status murk_entrances(murk_reach *out, murk_vec3 **places,
                           const murk_stage *stage, const char *where,
                           murk_error *err);

/* The caller owns *out (murk_open_space_destroy()). Fails as
 * murk_open_space_create(). */
murk_status murk_stage_free_space(murk_open_space **out,
                                  const murk_stage *stage, unsigned threads,
                                  murk_error *err);

/* Warns at `where` that no open way leads from the place of `name`, such as "a
 * fixed sensor", to any light, if there is none. The place must lie in the
 * domain. */
void murk_warn_unless_open(const murk_open_space *space, const char *where,
                           const char *name, murk_vec3 place);

/* The same for each fixed sensor of the scene. Does nothing if there is no
 * light. Fails as murk_open_space_create(). */
murk_status murk_warn_of_fixed_sensors(const murk_stage *stage,
                                       unsigned threads, murk_error *err);

typedef struct murk_part {
    bool is_ball;
    murk_box box; /* of a ball: the bounding box */
    murk_vec3 center;
    double radius_m;
    uint32_t number; /* addresses the random numbers of this part */
} murk_part;

/* The share (0..1) of the part that lies in free space, by stratified sampling:
 * part->box is divided into equal cells with one random point in each, and of a
 * ball only the points inside count. The standard error is that of independent
 * points, an upper bound for stratified points. space NULL means that nothing
 * obstructs the part: the share is 1. If no random point lies in a ball, the
 * share is 0. */
murk_estimate murk_free_share(const murk_part *part,
                              const murk_open_space *space, uint32_t seed,
                              unsigned threads);

#endif
