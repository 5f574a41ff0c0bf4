/* The points of surfaces that are visible at the centers of the pixels of a
 * picture, for computing which of them sensors see.
 *
 * A point is a record in the form of the surface photon map. The number of the
 * pixel (row by row from the top) takes the place of the number of the emitted
 * photon, and the power is 1. Pixels that show no surface have no point. */
#ifndef MURK_RENDER_POINTS_H
#define MURK_RENDER_POINTS_H

#include "photonmap/photon.h"
#include "render/camera.h"
#include "render/scenery.h"

/* Finds the points of `rows` rows from first_row on, in the order of the
 * pixels, for the given band. The caller frees *out. Fails with MURK_NO_MEMORY.
 * Ends early after an interrupt: the caller checks murk_interrupted(). */
murk_status murk_points_find(murk_photon **out, size_t *n,
                             const murk_scenery *scenery,
                             const murk_camera *camera, size_t first_row,
                             size_t rows, int band, unsigned threads,
                             murk_error *err);

#endif
