/* Where photons start: lamps, beams and distant light.
 *
 * A channel is one light in one band. Photons are dealt to channels so that
 * every prefix of the photon indices is dealt in proportion to power; all
 * packets of a channel have equal power. Immutable after creation. */
#ifndef MURK_LIGHT_LIGHTS_H
#define MURK_LIGHT_LIGHTS_H

#include "base/bands.h"
#include "base/status.h"
#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_LIGHTS_MAX 256

typedef enum murk_light_type {
    MURK_LIGHT_SPHERE,     /* every point of the surface shines by cosine law */
    MURK_LIGHT_RECT,       /* cosine law, to the side of edge1 x edge2 */
    MURK_LIGHT_POINT,      /* isotropic */
    MURK_LIGHT_BEAM,       /* a disc of parallel rays, or spread evenly over the
                              cone of half angle divergence */
    MURK_LIGHT_DIRECTIONAL /* distant: parallel rays onto the domain */
} murk_light_type;

typedef struct murk_light {
    murk_light_type type;
    murk_vec3 position;     /* center, corner, the point, the beam's origin */
    murk_vec3 edge1, edge2; /* rect */
    murk_vec3 direction;    /* beam, directional: of travel, need not be unit */
    double radius_m;        /* sphere, beam */
    double divergence_rad;  /* beam: half angle of the cone */
    murk_spectrum power_w;  /* per band; directional: irradiance [W/m2] at right
                               angles to the beam, at the domain's boundary */
    const char *where;
} murk_light;

typedef struct murk_lights murk_lights;

/* Directional light enters an open domain through every lit face with power
 * irradiance * projected area of the box, and a periodic one through the top
 * only with power irradiance * cos(zenith) * area. Fails where a light has no
 * power at all in any band, lies outside the domain, or a periodic domain is
 * lit from below. *out is the caller's. */
murk_status murk_lights_create(murk_lights **out, const murk_light *lights,
                               size_t n_lights, int bands,
                               const murk_domain *domain, murk_error *err);
void murk_lights_destroy(murk_lights *lights); /* NULL is fine */

/* Channel c = light * bands + band. Power in watts; may be 0. */
size_t murk_lights_channels(const murk_lights *lights);
double murk_lights_channel_power_w(const murk_lights *lights, size_t channel);
double murk_lights_power_w(const murk_lights *lights); /* all together */

/* The channel that photon belongs to: a pure function of the photon's index.
 * The first photons go one to each channel that has power; the rest follow a
 * golden-ratio sequence over the powers. */
size_t murk_lights_channel_of(const murk_lights *lights, uint64_t photon);

/* How many of the photons [0, n) belong to each channel: fills
 * count[channels]. */
void murk_lights_deal(const murk_lights *lights, uint64_t n, uint64_t *count);

typedef struct murk_ray {
    murk_vec3 origin, direction;
} murk_ray;

/* The start of a photon: a pure function of (seed, stream, photon). */
murk_ray murk_lights_emit(const murk_lights *lights, uint32_t seed,
                          uint32_t stream, uint64_t photon);

/* A point from which the light's photons start, for reach: the middle of a
 * lamp. False for directional light, which has none. */
bool murk_lights_place(const murk_lights *lights, size_t light, murk_vec3 *out);
size_t murk_lights_count(const murk_lights *lights);
const murk_light *murk_lights_get(const murk_lights *lights, size_t light);

#endif
