/* The tallies of a scene. */
#ifndef MURK_WORLD_SCENE_TALLIES_H
#define MURK_WORLD_SCENE_TALLIES_H

#include "world/stage.h"

/* What the scene asks for, checked against the domain: scene->n_tallies of
 * them, NULL for none. *out is the caller's to free(). */
murk_status murk_tallies_asked(murk_tally_desc **out,
                               const murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err);

/* Bytes that a run with the stage's tallies takes for them, at most. */
double murk_tallies_bytes(const murk_stage *stage, unsigned threads);

/* Made for that many threads; *out is NULL where the scene has none. Refused
 * where they take more than memory_most_bytes. *out is the caller's:
 * murk_tallies_destroy(). */
murk_status murk_tallies_of_stage(murk_tallies **out, const murk_stage *stage,
                                  unsigned threads, double memory_max_bytes,
                                  murk_error *err);

#endif
