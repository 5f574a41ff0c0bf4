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
    murk_profile *profile;      /* [n]; the numbers in it are borrowed from the
                                 * scene; without nodes if the medium has no
                                 * profile */
} murk_fillings;

/* The grid files of the i-th medium of the scene, for checksums: file[0] is
 * that of the density, NULL without a density grid; file[1] is that of the
 * albedo, NULL without an albedo grid or if both grids are in one file; file[2]
 * is that of the density of the next frame, NULL unless the time is between two
 * frames. If a file of the density does not exist, the function fails with
 * MURK_BAD_FILE if the file is a frame of a sequence, or with MURK_BAD_VALUE if
 * the path is the pattern of a sequence and the scene gives no frame; the
 * message lists frames that exist. The file of the albedo is not looked for. */
#define MURK_FILLING_FILES 3
murk_status murk_fillings_files(const murk_scene_desc *scene, size_t i,
                                const char *file[MURK_FILLING_FILES],
                                murk_error *err);

/* Imports all grids of the scene by murk_grid_read(),
 * murk_grid_read_between(), murk_grid_read_fds() and murk_grid_read_albedo()
 * (medium/grid.h), each grid in a subprocess of its own. With `from` not NULL
 * the grids of medium i are shared with medium from[i] of `other` instead,
 * unless from[i] is MURK_NOT_SHARED. Fails as these functions, or with
 * MURK_NO_MEMORY. The caller owns *out (murk_fillings_destroy()); the scene
 * must outlive *out. */
#define MURK_NOT_SHARED SIZE_MAX
murk_status murk_fillings_create(murk_fillings **out,
                                 const murk_scene_desc *scene,
                                 const murk_fillings *other, const size_t *from,
                                 murk_error *err);
void murk_fillings_destroy(murk_fillings *fillings); /* NULL is fine */

/* Sets the grid and the albedo grid of *medium to those of the i-th medium of
 * the fillings, NULL included, and the profile if the i-th medium has one. */
void murk_fillings_give(const murk_fillings *fillings, size_t i,
                        murk_medium *medium);

#endif
