/* Light sources: where photons start. They are lamps (spheres, rectangles,
 * points and beams) and distant light (parallel light or a disc, such as sun
 * and moon; the sky).
 *
 * A channel is one light in one band. Photons are dealt to channels in such a
 * way that the first n photons, for any n, are distributed in proportion to
 * power, or to given weights, to within a few photons of each channel. All
 * packets of a channel have equal power: that of the channel, divided by the
 * number of photons dealt to it. Immutable after creation but for
 * murk_sources_deal_by(). */
#ifndef MURK_SOURCE_SOURCES_H
#define MURK_SOURCE_SOURCES_H

#include "base/status.h"
#include "base/vector.h"
#include "source/source.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Photon records store the number of a light in 8 bits. */
#define MURK_SOURCES_MAX 256

/* Creates the light sources. Distant light enters an open domain through every
 * lit face, with power irradiance * projected area of the box (for a dome:
 * radiance times projected area, integrated over all directions). Distant light
 * enters a periodic domain through the top only, with power irradiance on the
 * top * area of the top.
 *
 * Light that is aimed at portals has the power that would fall on the portals
 * from outside without occluders, and the light enters nowhere else. Photons
 * start on the boundary of the domain, on the line to a point of a portal, so
 * that occluders in front of the portal cast shadows. A ray that passes several
 * portals inward belongs to the first one. A ray that is drawn from another
 * portal ends where it starts; if portals lie one behind the other, the power
 * of the light thus includes power that escapes at once. Portals must lie in
 * the domain, which must be open.
 *
 * Lights without power are dark; if all lights are dark, nothing is emitted.
 * Fails with MURK_BAD_VALUE if there is no light or more than MURK_SOURCES_MAX,
 * if the domain is no finite box, if a member of a light is out of range, if a
 * lamp or a portal lies outside the domain, if a light is aimed at portals in a
 * periodic domain, if the total power is not finite, or if a directional light
 * with power lights a periodic domain from below or from the side; or with
 * MURK_NO_MEMORY. The caller destroys *out, which refers to none of the
 * arguments. */
murk_status murk_sources_create(murk_sources **out, const murk_source *lights,
                                size_t n_lights, int bands,
                                const murk_domain *domain, murk_error *err);
void murk_sources_destroy(murk_sources *lights); /* NULL is fine */

/* Deals photons in proportion to weight[channels] in place of power, so that
 * the channel of a photon stays the same while powers change. A weight must be
 * above 0 where the power is. Photons that are dealt to a channel without power
 * are not traced. To be called before the light sources are used. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_sources_deal_by(murk_sources *lights, const double *weight,
                                 murk_error *err);

/* True if every photon has the same channel in both. */
bool murk_sources_deal_alike(const murk_sources *a, const murk_sources *b);

/* Channel c = light * bands + band. The power [W] may be 0. */
size_t murk_sources_channels(const murk_sources *lights);
double murk_sources_channel_power_w(const murk_sources *lights, size_t channel);
/* The sum over all channels [W]. */
double murk_sources_power_w(const murk_sources *lights);

/* The number of channels with power. If it is 0, no photon may be asked for. */
size_t murk_sources_lit(const murk_sources *lights);

/* The number of channels that photons are dealt to: those with power, or those
 * with a weight (murk_sources_deal_by()). */
size_t murk_sources_dealt(const murk_sources *lights);

/* The channel of a photon: a pure function of the photon index. The first
 * photons go one to each of these channels; the rest follow a golden-ratio
 * sequence over the powers or weights. */
size_t murk_sources_channel_of(const murk_sources *lights, uint64_t photon);

/* Counts the photons [0, n) of each channel into count[channels]: those that
 * are traced, so 0 for channels without power. */
void murk_sources_deal(const murk_sources *lights, uint64_t n, uint64_t *count);

/* The start of a photon: a pure function of (seed, stream, photon). */
murk_ray murk_sources_emit(const murk_sources *lights, uint32_t seed,
                           uint32_t stream, uint64_t photon);

/* The same for a caller that knows the channel of the photon. */
murk_ray murk_sources_emit_in(const murk_sources *lights, size_t channel,
                              uint32_t seed, uint32_t stream, uint64_t photon);

/* True if the portal receives any light of this light source. */
bool murk_sources_portal_is_lit(const murk_sources *lights, size_t light,
                                size_t portal);

/* The center of a lamp. False, with *out unchanged, for distant light. */
bool murk_sources_place(const murk_sources *lights, size_t light,
                        murk_vec3 *out);
size_t murk_sources_count(const murk_sources *lights);
const murk_source *murk_sources_get(const murk_sources *lights, size_t light);

#endif
