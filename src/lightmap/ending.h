/* Whether light in a scene ever ends: asked of a few photons before many are
 * traced. */
#ifndef MURK_LIGHTMAP_ENDING_H
#define MURK_LIGHTMAP_ENDING_H

#include "world/stage.h"

/* Fails with MURK_BAD_VALUE where each of the first photons goes on for as
 * many events or wraps as are followed: such a scene would be refused for its
 * losses after hours (contract: what is lost is counted and limited). */
murk_status murk_ending_check(const murk_stage *stage, uint32_t stream,
                              murk_error *err);

#endif
