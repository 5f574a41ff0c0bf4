/* Light sources as seen from a point, for renderers that look towards lights:
 * the counterpart of murk_sources_emit(), which starts photons from lights.
 *
 * All functions assume clear air and an unobstructed view; the caller accounts
 * for occluders and media. Lamps are no surfaces: light passes through them,
 * and each is visible from the emitting side only. Light that is aimed at
 * portals arrives only along lines that pass a portal inward. */
#ifndef MURK_SOURCE_SHINE_H
#define MURK_SOURCE_SHINE_H

#include "source/sources.h"

/* True if murk_sources_shine() can sample the light. A beam of zero width and
 * zero divergence cannot be sampled, because no point lies in it. */
bool murk_sources_can_shine(const murk_sources *lights, size_t light);

/* Samples one direction from which the light reaches the point, by numbers in
 * (0, 1). The mean over the numbers of irradiance * f(direction) is the
 * integral of radiance * f over all directions, for any f. Returns false if
 * these numbers give no light; *shine then has no meaning. */
bool murk_sources_shine(const murk_sources *lights, size_t light, int band,
                        murk_vec3 place, const double u[MURK_SHINE_NUMBERS],
                        murk_shine *shine);

/* The light that reaches the point against the unit direction `sight`. Parallel
 * light, points, and beams that are parallel or have no width are invisible:
 * radiance 0. */
murk_glare murk_sources_glare(const murk_sources *lights, size_t light,
                              int band, murk_vec3 place, murk_vec3 sight);

#endif
