/* Free space of a scene, asked of any point: sensing/open_space.h, by a grid
 * over the domain and one over the scene's grid of candidates. */
#ifndef MURK_PLAN_FREE_SPACE_H
#define MURK_PLAN_FREE_SPACE_H

#include "sensing/open_space.h"
#include "world/stage.h"

/* *out is the caller's: murk_open_space_destroy(). Fails as
 * murk_open_space_create(). */
murk_status murk_stage_free_space(murk_open_space **out,
                                  const murk_stage *stage, unsigned threads,
                                  murk_error *err);

#endif
