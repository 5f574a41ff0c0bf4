/* One sight of a camera, in one band: a ray followed into the world, and the
 * radiance that it finds.
 *
 * By paths (MURK_BY_PATHS) the ray goes on to its end, and at each event direct
 * light is added; lamps and the sky that it meets by itself count by the share
 * that shadow rays have left (render/direct.h). Free of bias.
 *
 * By maps (MURK_BY_MAPS) it ends at its first diffuse reflection, where the
 * maps stand for all light that has been reflected or scattered before. In a
 * medium the place is drawn along the way by its optical depth (a march by
 * chance), and a phase function's forward peak is left to the ray: where it
 * turns by less than a cone, which next to no record comes in by, it goes on,
 * and of light that has been reflected or scattered before records within the
 * cone do not count. So neither bias nor sparks come of it.
 *
 * By maps alone (MURK_BY_MAPS_ONLY) no shadow ray is sent, and the maps stand
 * for direct light, too: for that within the cone as well, since a ray that has
 * gone on does not find all lights.
 *
 * Not found by paths: beams without width, and parallel light over mirrors or
 * through what bends it; the maps have both. */
#ifndef MURK_RENDER_SAMPLE_H
#define MURK_RENDER_SAMPLE_H

#include "render/gather.h"
#include "transport/follow.h"

typedef enum murk_render_method {
    MURK_BY_MAPS,
    MURK_BY_PATHS,
    MURK_BY_MAPS_ONLY
} murk_render_method;

typedef struct murk_found {
    double surface, volume; /* radiance [W/m2/sr], by what the light came from
                               last: a surface or a light itself; a medium */
    bool meets_light; /* the ray has met a light before it was scattered or
                         reflected diffusely */
} murk_found;

typedef struct murk_sampler murk_sampler;

/* gather: for the method; NULL by paths. trace: seed, stream, caps and flight.
 * All borrowed. One sampler belongs to one thread. *out is the caller's. */
murk_status murk_sampler_create(murk_sampler **out, const murk_scenery *scenery,
                                murk_render_method method,
                                const murk_gather *gather,
                                const murk_trace *trace, murk_error *err);
void murk_sampler_destroy(murk_sampler *sampler); /* NULL is fine */

/* number: of the ray, for its random numbers. What the maps bring is added to
 * group[], too; by paths it is not looked at. */
murk_found murk_sampler_look(murk_sampler *sampler, uint64_t number, int band,
                             murk_vec3 from, murk_vec3 sight,
                             double group[MURK_GATHER_GROUPS]);

/* Rays so far that were lost, by caps or rounding. */
uint64_t murk_sampler_lost(const murk_sampler *sampler);

#endif
