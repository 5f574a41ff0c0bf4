/* The tallies of a scene. */
#ifndef MURK_WORLD_SCENE_TALLIES_H
#define MURK_WORLD_SCENE_TALLIES_H

#include "world/stage.h"

/* Converts the tallies of the scene and checks them against the domain. *out
 * has scene->n_tallies elements and belongs to the caller: free(); it is NULL
 * if the scene has no tallies. */
murk_status murk_tallies_asked(murk_tally_desc **out,
                               const murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err);

/* An upper bound on the bytes that the tallies of this stage take in a run. */
double murk_tallies_bytes(const murk_stage *stage, unsigned threads);

/* Creates the tallies of a run for that many threads; *out is NULL if the scene
 * has none. Fails if they would take more than memory_max_bytes. The caller
 * owns *out: murk_tallies_destroy(). */
murk_status murk_tallies_of_stage(murk_tallies **out, const murk_stage *stage,
                                  unsigned threads, double memory_max_bytes,
                                  murk_error *err);

#endif
