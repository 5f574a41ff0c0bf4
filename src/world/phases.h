/* How the media of a scene scatter: phase functions and albedos, from the scene
 * or, for droplets of a NetCDF file, from the mean effective radius in the
 * file. Tables of phase functions are read from files or computed, and are
 * normalised. */
#ifndef MURK_WORLD_PHASES_H
#define MURK_WORLD_PHASES_H

#include "base/status.h"
#include "medium/phase.h"
#include "scene/scene.h"
#include "world/fillings.h"

typedef struct murk_phases {
    size_t n; /* number of distinct tables */
    murk_phase_table **table;
    const murk_scene_phase **of; /* [n]: the first phase function that uses the
                                  * table */
    size_t nodes;                /* number of nodes of all tables */
    murk_phase (*medium)[MURK_BANDS_MAX]; /* [scene->n_media]; bands that the
                                           * scene does not have are isotropic
                                           */
    size_t media;
    const murk_scene_medium **source; /* [media]: the medium with the albedo and
                                       * the phase functions that count: that
                                       * of the scene, or droplets[i] */
    murk_scene_medium **droplets;     /* [media]: the medium of the scene with
                                       * the albedo and the phase functions of
                                       * the droplets in the file
                                       * (murk_medium_droplets_fill()); NULL if
                                       * those of the scene count */
} murk_phases;

/* Builds the phase functions of all media. fillings are those of the scene or
 * of a scene with the same files; NULL only if no medium has
 * `effective_variance`. Phase functions that name the same
 * file, or that are computed from the same numbers, share one table; mixtures
 * of presets do not share tables. The caller owns *out (murk_phases_destroy());
 * the scene must outlive *out. Fails as murk_medium_droplets_fill(), with
 * MURK_BAD_VALUE or MURK_BAD_FILE at the place of a phase function in the scene
 * or at the file of a table, with the line if one is at fault; with
 * MURK_BAD_VALUE if all tables have too many nodes together; or with
 * MURK_NO_MEMORY. */
murk_status murk_phases_create(murk_phases **out, const murk_scene_desc *scene,
                               const murk_fillings *fillings, murk_error *err);
void murk_phases_destroy(murk_phases *phases); /* NULL is fine */

/* The name of the kind of the phase function of a medium, an element of
 * phases->source, in one band, as the scene file writes it (base/phase_kind.h):
 * "hg", "two_hg" and so on; "table" also for a mixture of a preset; "isotropic"
 * for Henyey-Greenstein with g = 0. */
const char *murk_phases_kind(const murk_scene_medium *medium, int band);

#endif
