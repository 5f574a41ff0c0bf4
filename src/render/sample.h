/* One sample of a camera in one band: follows a ray into the world and returns
 * the radiance along it.
 *
 * By paths (MURK_BY_PATHS) the ray is followed to its end, and direct light is
 * added at each event. Lamps and sky that the ray hits by itself are weighted
 * against shadow rays (render/direct.h). The result is unbiased.
 *
 * By maps (MURK_BY_MAPS) the ray ends at its first diffuse reflection, where
 * the maps give all light that was reflected or scattered before. In a medium,
 * the point of scattering is drawn along the ray by optical depth. The forward
 * peak of a phase function is left to the ray: if the ray is scattered by less
 * than the angle of a cone, in which hardly any record arrives, it continues,
 * and records of later events within the cone do not count; otherwise the ray
 * ends. This avoids bias and outliers.
 *
 * By maps alone (MURK_BY_MAPS_ONLY) no shadow ray is sent, and the maps give
 * direct light, too, also within the cone, because the continued ray does not
 * find all lights.
 *
 * Not found by paths: beams of zero width and divergence, and the light of
 * directional sources, points and narrow beams after mirrors or refraction. The
 * maps contain all of these. */
#ifndef MURK_RENDER_SAMPLE_H
#define MURK_RENDER_SAMPLE_H

#include "render/gather.h"
#include "transport/follow.h"

typedef enum murk_render_method {
    MURK_BY_MAPS,
    MURK_BY_PATHS,
    MURK_BY_MAPS_ONLY
} murk_render_method;

/* The radiance along a ray. */
typedef struct murk_found {
    /* The radiance [W/m2/sr], split by the last scattering or diffuse
     * reflection of the light on the way to the camera: `volume` if that event
     * was in a medium, `surface` if that event was on a surface or if there was
     * none. Mirror reflection and refraction are not counted as events. */
    double surface, volume;
    bool meets_light; /* the ray has hit a light before it was scattered or
                       * reflected diffusely */
} murk_found;

typedef struct murk_sampler murk_sampler;

/* gather: radiance from the maps; NULL by paths. trace: seed, stream, limits
 * and flight. All must outlive the sampler. A sampler belongs to one thread.
 * The caller destroys *out. */
murk_status murk_sampler_create(murk_sampler **out, const murk_scenery *scenery,
                                murk_render_method method,
                                const murk_gather *gather,
                                const murk_trace *trace, murk_error *err);
void murk_sampler_destroy(murk_sampler *sampler); /* NULL is fine */

/* Traces one ray; `number` addresses the random numbers. Contributions of the
 * maps are part of the radiance, and are also added to group[], which serves
 * the estimate of the error (render/gather.h). By paths, group[] is not used.
 */
murk_found murk_sampler_trace(murk_sampler *sampler, uint64_t number, int band,
                              murk_vec3 from, murk_vec3 sight,
                              double group[MURK_GATHER_GROUPS]);

/* The number of rays so far that were lost to limits or rounding. */
uint64_t murk_sampler_lost(const murk_sampler *sampler);

#endif
