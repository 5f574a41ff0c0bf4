/* Heights above the ground: above the highest surface of the scene at a place.
 */
#ifndef MURK_PLAN_ON_GROUND_H
#define MURK_PLAN_ON_GROUND_H

#include "scene/table_places.h"
#include "world/stage.h"

/* Reads the place of a row of a table relative to the local origin of the scene
 * of the stage. A height above the ground counts from the first surface, of
 * whatever material, below the top of the domain. Fails as
 * murk_table_places_read(), and with MURK_BAD_VALUE at the line if there is no
 * surface. */
murk_status murk_place_on_ground(murk_vec3 *out, const murk_stage *stage,
                                 const murk_table_places *places, size_t row,
                                 murk_error *err);

#endif
