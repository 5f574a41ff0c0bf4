/* Direct light at a point, by shadow rays: light that arrives from the lights
 * without an event and is scattered or reflected at the point towards the
 * viewer. */
#ifndef MURK_RENDER_DIRECT_H
#define MURK_RENDER_DIRECT_H

#include "base/rng.h"
#include "render/choice.h"

/* How direct light is combined with light that the viewing ray itself finds
 * after the point. Each of the two is weighted by the density with which it
 * samples the direction (balance heuristic: Veach and Guibas, SIGGRAPH 1995,
 * doi:10.1145/218380.218498), so that each finds the light for which it is the
 * better method. */
typedef struct murk_balance {
    bool goes_on; /* the ray continues, in directions with the density of the
                   * reflection or phase function; in a medium it finds only
                   * light within the cone of the point (render/choice.h) */
    bool sheets;  /* thin sheets transmit shadow rays without deflection,
                   * according to the transmittance; otherwise they block */
} murk_balance;

/* Returns an estimate of the direct light that the point sends towards the
 * viewer, as radiance [W/m2/sr] divided by the square of the refractive index
 * at the point. The random numbers are those of `address`. */
double murk_direct_light(const murk_scenery *scenery,
                         const murk_shading_point *place,
                         const murk_address *address, murk_balance balance);

/* Returns the weight, 0..1 by the balance heuristic, of light that the
 * continued ray has found. arriving: direction of travel of the light, which
 * murk_sources_shine() samples with density per_sr. wrapped: the total
 * displacement [m] of the ray at the sides of a periodic domain since the
 * point, a multiple of the period on each axis, which identifies the image of
 * the light. */
double murk_direct_rest(const murk_scenery *scenery,
                        const murk_shading_point *place, size_t light,
                        murk_vec3 arriving, double per_sr, murk_vec3 wrapped);

#endif
