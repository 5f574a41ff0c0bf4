/* Where the scene's sensors may stand: its candidates, in its free space. */
#ifndef MURK_STUDY_SITES_H
#define MURK_STUDY_SITES_H

#include "sensing/candidates.h"
#include "study/stage.h"

/* *out is the caller's: murk_candidates_destroy(). Fails as
 * murk_candidates_create(). */
murk_status murk_sites_find(murk_candidates **out, const murk_stage *stage,
                            unsigned threads, murk_error *err);

#endif
