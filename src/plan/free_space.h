/* The free space of a scene: whether light can reach a point
 * (sensing/open_space.h), by one grid over the domain and one over the grid of
 * candidates that the scene gives. */
#ifndef MURK_PLAN_FREE_SPACE_H
#define MURK_PLAN_FREE_SPACE_H

#include "sensing/open_space.h"
#include "world/stage.h"

/* The caller owns *out (murk_open_space_destroy()). Fails as
 * murk_open_space_create(). */
murk_status murk_stage_free_space(murk_open_space **out,
                                  const murk_stage *stage, unsigned threads,
                                  murk_error *err);

#endif
