/* The tallies of a scene. */
#ifndef MURK_WORLD_SCENE_TALLIES_H
#define MURK_WORLD_SCENE_TALLIES_H

#include "world/stage.h"

/* Converts the tallies of the scene and checks them against the domain. *out
 * has scene->n_tallies elements; the caller frees *out. *out is NULL if the
 * scene has no tallies, and after a failure. The scene must outlive *out. Fails
 * as murk_tallies_check() or with MURK_NO_MEMORY. */
murk_status murk_tallies_asked(murk_tally_desc **out,
                               const murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err);

/* murk_tallies_memory() of the tallies of this stage in bytes; 0 if there are
 * none. */
double murk_tallies_bytes(const murk_stage *stage, unsigned threads);

/* Creates the tallies of a run in which at most `threads` threads add to them;
 * *out is NULL if the scene has none. Fails as murk_tallies_create()
 * (transport/tallies.h), also if the tallies would take more than
 * memory_max_bytes. The caller destroys *out with murk_tallies_destroy(); the
 * stage must outlive *out. */
murk_status murk_tallies_of_stage(murk_tallies **out, const murk_stage *stage,
                                  unsigned threads, double memory_max_bytes,
                                  murk_error *err);

#endif
