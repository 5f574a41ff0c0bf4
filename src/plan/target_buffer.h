/* Records of targets before they enter maps. Internal to the files of targets.
 */
#ifndef MURK_PLAN_TARGET_BUFFER_H
#define MURK_PLAN_TARGET_BUFFER_H

#include "base/stats.h"
#include "photonmap/map.h"
#include "world/stage.h"

typedef struct murk_target_buffer {
    murk_photon *photon;
    size_t n, capacity;
} murk_target_buffer;

/* False when out of memory. */
bool murk_target_buffer_put(murk_target_buffer *buffer,
                            const murk_photon *photon);

/* A record of weight 1; a zero normal means a record in the volume. */
murk_photon murk_target_of(murk_vec3 place, murk_vec3 normal, uint32_t number,
                           int band);

/* The material or medium of a record that lies on or in none. */
#define MURK_TARGET_IN_NONE UINT8_MAX

/* The medium with the largest extinction at a place. */
uint8_t murk_target_medium(const murk_stage *stage, int band, murk_vec3 place);

/* The task of drawing targets. */
typedef struct murk_target_source {
    const murk_stage *stage;
    uint32_t stream;
    unsigned threads;
    uint64_t first_number; /* photon number of the first point */
    uint64_t max;          /* stop after this number of points */
} murk_target_source;

/* The result of drawing. */
typedef struct murk_target_draw {
    uint64_t points;    /* number of points kept */
    murk_estimate size; /* size of the free space: volume, or area with each
                         * side counted */
} murk_target_draw;

/* Draw points into an empty buffer. The power of a record is area or volume. */
murk_status murk_targets_draw_surfaces(murk_target_buffer *buffer,
                                       murk_target_draw *out,
                                       const murk_target_source *source,
                                       murk_error *err);
murk_status murk_targets_draw_volume(murk_target_buffer *buffer,
                                     murk_target_draw *out,
                                     const murk_target_source *source,
                                     murk_error *err);

/* Reads the list of targets: points with a normal are appended to `surface`,
 * others to `volume`. */
murk_status murk_targets_read(murk_target_buffer *surface,
                              murk_target_buffer *volume, uint64_t *points,
                              const murk_stage *stage, murk_error *err);

#endif
