/* Where the scene's sensors may stand: its grid of points (or one laid by murk
 * where the scene names no candidates; where it names others, that one carries
 * reach alone), its listed points and its mounts, in its free space and
 * zones. */
#ifndef MURK_PLAN_SITES_H
#define MURK_PLAN_SITES_H

#include "sensing/candidates.h"
#include "world/stage.h"

/* *out is the caller's: murk_candidates_destroy(). Fails at the scene's
 * own places, or those of the files it names. */
murk_status murk_sites_find(murk_candidates **out, const murk_stage *stage,
                            unsigned threads, murk_error *err);

/* The same of n worlds: the candidates that are usable in each of them, by
 * their places. Counts of why others are not are those of the first; those that
 * only a later one drops count as unreached. Fails at where[i] where none is
 * left. */
murk_status murk_sites_find_common(murk_candidates **out,
                                   const murk_stage *const *stage,
                                   const char *const *where, size_t n,
                                   unsigned threads, murk_error *err);

#endif
