/* The spatial structure of the media of a scene: grids of density and albedo,
 * read from their files, and vertical profiles. */
#ifndef MURK_WORLD_FILLINGS_H
#define MURK_WORLD_FILLINGS_H

#include "base/status.h"
#include "medium/media.h"
#include "scene/scene.h"

typedef struct murk_fillings {
    size_t n;                   /* number of media of the scene */
    murk_grid **grid, **albedo; /* [n]; NULL if the medium has none */
    murk_profile *profile;      /* [n]; a profile without nodes if the medium
                                 * has none */
} murk_fillings;

/* The files that the i-th medium of the scene names, for checksums. At most two
 * are set, the others are NULL. Fails if a frame of a sequence does not exist;
 * the message lists the frames that do. */
murk_status murk_fillings_files(const murk_scene_desc *scene, size_t i,
                                const char *file[2], murk_error *err);

/* Imports all grids, each in a subprocess (medium/grid.h). The caller owns *out
 * (murk_fillings_destroy()); the scene must outlive it. */
murk_status murk_fillings_create(murk_fillings **out,
                                 const murk_scene_desc *scene, murk_error *err);
void murk_fillings_destroy(murk_fillings *fillings); /* NULL is fine */

/* Sets grid, albedo grid and profile of the i-th medium. A profile states the
 * extinction by itself, so the extinction coefficient of the medium becomes 1.
 */
void murk_fillings_give(const murk_fillings *fillings, size_t i,
                        murk_medium *medium);

#endif
