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
    murk_profile *profile;      /* [n]; borrowed from the scene; a profile
                                 * without nodes if the medium has none */
} murk_fillings;

/* The grid files of the i-th medium of the scene, for checksums: file[0] of the
 * density, file[1] of the albedo if that is another file; NULL if there is
 * none. Fails with MURK_BAD_FILE if a frame of a sequence does not exist, or
 * with MURK_BAD_VALUE if a sequence is given without frame; the message lists
 * the frames that exist. */
murk_status murk_fillings_files(const murk_scene_desc *scene, size_t i,
                                const char *file[2], murk_error *err);

/* Imports all grids, each in a subprocess (medium/grid.h), and fails as that
 * import does or with MURK_NO_MEMORY. The caller owns *out
 * (murk_fillings_destroy()); the scene must outlive *out. */
murk_status murk_fillings_create(murk_fillings **out,
                                 const murk_scene_desc *scene, murk_error *err);
void murk_fillings_destroy(murk_fillings *fillings); /* NULL is fine */

/* Sets grid and albedo grid of the i-th medium to those of the fillings, NULL
 * included, and the profile if the medium has one. A profile states the
 * extinction by itself, so the extinction coefficient of such a medium becomes
 * 1 in all bands. */
void murk_fillings_give(const murk_fillings *fillings, size_t i,
                        murk_medium *medium);

#endif
