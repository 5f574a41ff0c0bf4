/* The phase functions of the media of a scene. Tables are read from files or
 * computed, and are normalised. */
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

/* Builds the phase functions of all media. Phase functions that name the same
 * file, or that are computed from the same numbers, share one table; mixtures
 * of presets do not share tables. The caller owns *out (murk_phases_destroy());
 * the scene must outlive *out. Fails with MURK_BAD_VALUE or MURK_BAD_FILE at
 * the place of a phase function in the scene or at the file of a table, with
 * the line if one is at fault; with MURK_BAD_VALUE if all tables have too many
 * nodes together; or with MURK_NO_MEMORY. */
murk_status murk_phases_create(murk_phases **out, const murk_scene_desc *scene,
                               murk_error *err);
void murk_phases_destroy(murk_phases *phases); /* NULL is fine */

/* The name of the kind of a medium's phase function in one band, as the scene
 * file writes it (base/phase_kind.h): "hg", "two_hg" and so on; "table" also
 * for a mixture of a preset; "isotropic" for Henyey-Greenstein with g = 0. */
const char *murk_phases_kind(const murk_scene_medium *medium, int band);

#endif
