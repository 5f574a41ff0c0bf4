/* Where the scene's sensors may stand: its grid of points (or one laid by murk
 * where the scene names no candidates; where it names others, that one carries
 * reach alone), its listed points and its mounts, in its free space and
 * zones. */
#ifndef MURK_STUDY_SITES_H
#define MURK_STUDY_SITES_H

#include "sensing/candidates.h"
#include "study/stage.h"

/* *out is the caller's: murk_candidates_destroy(). Fails at the scene's
 * own places, or those of the files it names. */
murk_status murk_sites_find(murk_candidates **out, const murk_stage *stage,
                            unsigned threads, murk_error *err);

#endif
