/* What fills the scene's media: grids of density and albedo, read from their
 * files, and profiles. */
#ifndef MURK_WORLD_FILLINGS_H
#define MURK_WORLD_FILLINGS_H

#include "base/status.h"
#include "medium/media.h"
#include "scene/scene.h"

typedef struct murk_fillings {
    size_t n;                   /* the scene's media */
    murk_grid **grid, **albedo; /* [n]; NULL where there is none */
    murk_profile *profile;      /* [n]; n 0 where there is none */
} murk_fillings;

/* The files of the scene's i-th medium, for checksums: at most two, the rest
 * NULL. A frame that is not there is refused with those that are. */
murk_status murk_fillings_files(const murk_scene_desc *scene, size_t i,
                                const char *file[2], murk_error *err);

/* Reads all grids, in child processes (medium/grid.h). *out is the caller's:
 * murk_fillings_destroy(). The scene must outlive it. */
murk_status murk_fillings_create(murk_fillings **out,
                                 const murk_scene_desc *scene, murk_error *err);
void murk_fillings_destroy(murk_fillings *fillings); /* NULL is fine */

/* Puts what fills the scene's i-th medium into it. */
void murk_fillings_give(const murk_fillings *fillings, size_t i,
                        murk_medium *medium);

#endif
