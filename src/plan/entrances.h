/* Where light comes into a scene's free space, for reach: lamps, the domain's
 * open sides for sun, sky and directional light, and their portals. All of
 * them, dark ones too: where sensors may stand is no matter of the hour. */
#ifndef MURK_PLAN_ENTRANCES_H
#define MURK_PLAN_ENTRANCES_H

#include "sensing/candidates.h"
#include "world/stage.h"

/* *places is out->lamps, the caller's: free(). where: for the message that
 * there is no memory. */
murk_status murk_entrances(murk_reach *out, murk_vec3 **places,
                           const murk_stage *stage, const char *where,
                           murk_error *err);

#endif
