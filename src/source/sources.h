/* Where photons start: lamps, beams and distant light (sun, moon, sky).
 *
 * A channel is one light in one band. Photons are dealt to channels so that
 * every prefix of the photon indices is dealt in proportion to power; all
 * packets of a channel have equal power. Immutable after creation. */
#ifndef MURK_SOURCE_SOURCES_H
#define MURK_SOURCE_SOURCES_H

#include "base/bands.h"
#include "base/source_type.h"
#include "base/status.h"
#include "base/vector.h"
#include "source/dome.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_SOURCES_MAX 256
#define MURK_PORTALS_MAX 256 /* of one light */

/* Largest angular radius of a distant source: its radiance is even to 2 %. */
#define MURK_DISC_RAD_MAX 0.1

/* A parallelogram that distant light passes towards edge1 x edge2: a window. */
typedef struct murk_portal {
    murk_vec3 corner, edge1, edge2;
} murk_portal;

typedef struct murk_source {
    murk_source_type type;
    murk_vec3 position;     /* center, corner, the point, the beam's origin */
    murk_vec3 edge1, edge2; /* rect */
    murk_vec3 direction;    /* beam, directional: of travel, need not be unit */
    double radius_m;        /* sphere, beam */
    double divergence_rad;  /* beam: half angle of the cone */
    double angular_radius_rad; /* directional: of the source's disc; 0: parallel
                                */
    murk_dome dome;            /* dome: how its radiance is spread */
    const murk_portal *portal; /* directional, dome: [portals]; the light is */
    size_t portals;            /* aimed at these alone; 0: at the domain */
    murk_spectrum power_w; /* per band. Directional: irradiance [W/m2] at right
                              angles to the beam, dome: on a level plane; both
                              at the domain's boundary */
    const char *where;
} murk_source;

/* From outside the domain: it starts on the domain's boundary. */
static inline bool murk_source_is_distant(const murk_source *light)
{
    return murk_source_type_group(light->type) != MURK_SOURCE_LAMP;
}

/* The smallest box around a lamp; empty for distant light. */
murk_box murk_source_box(const murk_source *light);

/* The largest distance of a point of a lamp from the lamp's middle [m]. */
double murk_source_extent_m(const murk_source *lamp);

/* The unit normal of a flat lamp, or `otherwise`. */
murk_vec3 murk_source_face(const murk_source *light, murk_vec3 otherwise);

/* Estimate of the irradiance [W/m2] that a lamp gives to a place, in clear air
 * and an open view; way: from the place to the middle of the lamp. has_images:
 * the domain is periodic, and the estimate stands for the images, too. */
double murk_source_irradiance_near(const murk_source *lamp, int band,
                                   murk_vec3 way, bool has_images);

typedef struct murk_sources murk_sources;

/* Distant light enters an open domain through every lit face with power
 * irradiance * projected area of the box (a dome: radiance times projected
 * area, over all directions), and a periodic one through the top only with
 * power irradiance on it * its area.
 *
 * Aimed at portals, it has the power that falls on these from outside, what
 * stands before them left aside, and nothing else enters: its photons start on
 * the domain's boundary where their way to a portal begins, so that all that
 * stands there shades. A ray that passes several portals inward belongs to the
 * first; drawn from another it ends where it starts, so that portals one behind
 * the other add to the light's power what escapes at once. Portals must lie in
 * the domain, which must be open.
 *
 * Lights without power are dark, and so may all of them be: then nothing is
 * emitted. Fails where a light lies outside the domain, or one with power
 * lights a periodic domain from below. *out is the caller's; it borrows
 * nothing. */
murk_status murk_sources_create(murk_sources **out, const murk_source *lights,
                                size_t n_lights, int bands,
                                const murk_domain *domain, murk_error *err);
void murk_sources_destroy(murk_sources *lights); /* NULL is fine */

/* Channel c = light * bands + band. Power in watts; may be 0. */
size_t murk_sources_channels(const murk_sources *lights);
double murk_sources_channel_power_w(const murk_sources *lights, size_t channel);
double murk_sources_power_w(const murk_sources *lights); /* all together */

/* Channels that have power. 0: all is dark, and no photon may be asked for. */
size_t murk_sources_lit(const murk_sources *lights);

/* The channel that photon belongs to: a pure function of the photon's index.
 * The first photons go one to each channel that has power; the rest follow a
 * golden-ratio sequence over the powers. */
size_t murk_sources_channel_of(const murk_sources *lights, uint64_t photon);

/* How many of the photons [0, n) belong to each channel: fills
 * count[channels]. Where all is dark, none. */
void murk_sources_deal(const murk_sources *lights, uint64_t n, uint64_t *count);

typedef struct murk_ray {
    murk_vec3 origin, direction;
    bool is_spent; /* belongs to another portal: ends where it starts */
} murk_ray;

/* The start of a photon: a pure function of (seed, stream, photon). */
murk_ray murk_sources_emit(const murk_sources *lights, uint32_t seed,
                           uint32_t stream, uint64_t photon);

/* Whether any light that the light has falls on a portal of it. */
bool murk_sources_portal_is_lit(const murk_sources *lights, size_t light,
                                size_t portal);

/* Of a dome: the integral over the sky of its relative radiance times the
 * cosine at a level plane. */
double murk_sources_sky_level(const murk_sources *lights, size_t light);

/* A point from which the light's photons start, for reach: the middle of a
 * lamp. False for distant light, which has none. */
bool murk_sources_place(const murk_sources *lights, size_t light,
                        murk_vec3 *out);
size_t murk_sources_count(const murk_sources *lights);
const murk_source *murk_sources_get(const murk_sources *lights, size_t light);

#endif
