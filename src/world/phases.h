/* The phase functions of a scene's media: tables read and normalised. */
#ifndef MURK_WORLD_PHASES_H
#define MURK_WORLD_PHASES_H

#include "base/status.h"
#include "medium/phase.h"
#include "scene/scene.h"

typedef struct murk_phases {
    size_t n; /* different tables */
    murk_phase_table **table;
    const murk_scene_phase **of; /* [n]: the first phase that needs it */
    size_t nodes;                /* of all tables */
    murk_phase (*medium)[MURK_BANDS_MAX]; /* [scene->n_media]; bands past the
                                             scene's are isotropic */
} murk_phases;

/* *out is the caller's: murk_phases_destroy(); the scene must outlive it.
 * Fails at the place in the scene, or at the file and line of a table. */
murk_status murk_phases_create(murk_phases **out, const murk_scene_desc *scene,
                               murk_error *err);
void murk_phases_destroy(murk_phases *phases); /* NULL is fine */

/* "hg", "two_hg", .. of a band, as the scene has it; "isotropic" where g is
 * 0. */
const char *murk_phases_kind(const murk_scene_medium *medium, int band);

#endif
