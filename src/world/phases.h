/* The phase functions of the media of a scene, with tables read from files and
 * normalised. */
#ifndef MURK_WORLD_PHASES_H
#define MURK_WORLD_PHASES_H

#include "base/status.h"
#include "medium/phase.h"
#include "scene/scene.h"

typedef struct murk_phases {
    size_t n; /* number of distinct tables */
    murk_phase_table **table;
    const murk_scene_phase **of; /* [n]: the first phase function of the scene
                                  * that uses the table */
    size_t nodes;                /* number of nodes of all tables */
    murk_phase (*medium)[MURK_BANDS_MAX]; /* [scene->n_media]; bands that the
                                           * scene does not have are isotropic
                                           */
} murk_phases;

/* Builds the phase functions of all media. Equal phase functions share one
 * table, except for mixtures of presets. The caller owns *out
 * (murk_phases_destroy()); the scene must outlive *out. Fails with
 * MURK_BAD_VALUE or MURK_BAD_FILE at the place of a phase function in the scene
 * or at file and line of a table, or with MURK_NO_MEMORY. */
murk_status murk_phases_create(murk_phases **out, const murk_scene_desc *scene,
                               murk_error *err);
void murk_phases_destroy(murk_phases *phases); /* NULL is fine */

/* The name of the kind of a phase function in one band, as the scene file
 * writes it: "hg", "two_hg" and so on; "isotropic" for Henyey-Greenstein with g
 * = 0. */
const char *murk_phases_kind(const murk_scene_medium *medium, int band);

#endif
