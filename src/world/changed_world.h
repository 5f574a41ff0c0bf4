/* The places at which the worlds of two stages differ. */
#ifndef MURK_WORLD_CHANGED_WORLD_H
#define MURK_WORLD_CHANGED_WORLD_H

#include "base/box_list.h"
#include "world/stage.h"

/* What must be the same outside of the boxes. */
typedef enum murk_world_use {
    MURK_USE_SIGHT,           /* sightlines: occlusion, transmittance */
    MURK_USE_ACCEPTING_SIGHT, /* of sensors that accept light scattered
                               * forward: phase functions, too */
    MURK_USE_LIGHT            /* the paths of photons */
} murk_world_use;

/* Fills *changed with the boxes of all that differs, enlarged for the rounding
 * of rays: what meets none of them is the same in both worlds, in every bit.
 * In a periodic domain the boxes are those of one period. All places have
 * changed if the domains differ. Fails with MURK_NO_MEMORY. */
murk_status murk_changed_world(murk_box_list *changed, const murk_stage *a,
                               const murk_stage *b, murk_world_use what,
                               murk_error *err);

#endif
