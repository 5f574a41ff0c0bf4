/* The places through which light enters the free space of a scene: lamps,
 * portals, and the open sides of the domain for sun, sky and directional light.
 * Candidate sites are usable if light can reach them from there
 * (sensing/candidates.h). Sources that do not emit at the time of the scene are
 * included, because the usable sites should not depend on the hour. */
#ifndef MURK_PLAN_ENTRANCES_H
#define MURK_PLAN_ENTRANCES_H

#include "sensing/candidates.h"
#include "world/stage.h"

/* Sets *out. *places is the array that out->lamps points to; the caller owns
 * it: free(). where is the place in the scene for an out-of-memory message. */
murk_status murk_entrances(murk_reach *out, murk_vec3 **places,
                           const murk_stage *stage, const char *where,
                           murk_error *err);

#endif
