/* The surfaces that a picture shows, as points that sensors may see: what the
 * middle of each pixel looks at.
 *
 * A point is a record like a photon's, in the surface map's form, with the
 * pixel's number (row by row from the top) as that of the emitted photon and
 * power 1. Pixels that look at no surface have none. */
#ifndef MURK_RENDER_POINTS_H
#define MURK_RENDER_POINTS_H

#include "photonmap/photon.h"
#include "render/camera.h"
#include "render/scenery.h"

/* Those of the rows from first_row on, in the pixels' order; `band` is theirs.
 * (*out)[*n] is the caller's to free(). Fails with MURK_NO_MEMORY. Ends early
 * when interrupted: ask murk_interrupted(). */
murk_status murk_points_find(murk_photon **out, size_t *n,
                             const murk_scenery *scenery,
                             const murk_camera *camera, size_t first_row,
                             size_t rows, int band, unsigned threads,
                             murk_error *err);

#endif
