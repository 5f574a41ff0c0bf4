/* One sight of a camera, in one band: a ray followed into the world, and the
 * radiance that it finds.
 *
 * By paths (MURK_BY_PATHS) the ray goes on to its end, and at each event direct
 * light is added; lamps and the sky that it meets by itself count by the share
 * that shadow rays have left (render/direct.h). Free of bias. By maps
 * (MURK_BY_MAPS) it ends at its first diffuse reflection or scattering, and the
 * maps stand for all light that has been reflected or scattered before; in a
 * medium that place is drawn along the way by its optical depth (a march by
 * chance).
 *
 * Not found by paths: beams without width, and parallel light over mirrors or
 * through what bends it; the maps have both. */
#ifndef MURK_RENDER_SAMPLE_H
#define MURK_RENDER_SAMPLE_H

#include "render/gather.h"
#include "transport/follow.h"

typedef enum murk_render_method {
    MURK_BY_MAPS,
    MURK_BY_PATHS
} murk_render_method;

typedef struct murk_found {
    double surface, volume; /* radiance [W/m2/sr], by what the light came from
                               last: a surface or a light itself; a medium */
    double variance;        /* of both together, by the maps' records */
} murk_found;

typedef struct murk_sampler murk_sampler;

/* gather: NULL by paths. trace: seed, stream, caps and flight. All borrowed.
 * One sampler belongs to one thread. *out is the caller's. */
murk_status murk_sampler_create(murk_sampler **out, const murk_scenery *scenery,
                                const murk_gather *gather,
                                const murk_trace *trace, murk_error *err);
void murk_sampler_destroy(murk_sampler *sampler); /* NULL is fine */

/* number: of the ray, for its random numbers. */
murk_found murk_sampler_look(murk_sampler *sampler, uint64_t number, int band,
                             murk_vec3 from, murk_vec3 sight);

/* Rays so far that were lost, by caps or rounding. */
uint64_t murk_sampler_lost(const murk_sampler *sampler);

#endif
