/* Direct light at a point, by shadow rays: light that arrives from the lights
 * without an event and is scattered or reflected at the point towards the
 * viewer. */
#ifndef MURK_RENDER_DIRECT_H
#define MURK_RENDER_DIRECT_H

#include "base/rng.h"
#include "medium/phase.h"
#include "render/scenery.h"

/* A point at which light is scattered or reflected towards the viewer. */
typedef struct murk_shading_point {
    int band;
    murk_vec3 position;
    murk_vec3 sight;  /* unit direction of the viewing ray that arrives at the
                       * point */
    double index;     /* refractive index at the point */
    bool is_in_solid; /* inside a solid, where no shadow ray is sent */
    /* a surface: */
    murk_vec3 normal; /* unit normal towards the viewer */
    double diffuse;   /* diffuse reflectance */
    /* a medium, if phase is not NULL: */
    const murk_phase *phase;
    double albedo;
    double cone; /* cosine: light that is scattered by a smaller angle is found
                  * by continuing the ray, not from the maps; -1 all, 1 none */
} murk_shading_point;

/* How direct light is combined with light that the viewing ray itself finds
 * after the point. Each of the two is weighted by the density with which it
 * samples the direction (balance heuristic: Veach and Guibas, SIGGRAPH 1995,
 * doi:10.1145/218380.218498), so that each finds the light for which it is the
 * better method. */
typedef struct murk_balance {
    bool goes_on; /* the ray continues, in directions with the density of the
                   * reflection or phase function; in a medium within the cone
                   * of the point */
    bool sheets;  /* thin sheets transmit shadow rays without deflection,
                   * according to the transmittance; otherwise they block */
} murk_balance;

/* Returns the radiance [W/m2/sr] towards the viewer, divided by the square of
 * the index, for the random numbers of that address. */
double murk_direct_light(const murk_scenery *scenery,
                         const murk_shading_point *place,
                         const murk_address *address, murk_balance balance);

/* Returns the weight of light that the continued ray has found. arriving:
 * direction of travel of the light, which murk_sources_shine() samples with
 * density per_sr. wrapped: the total displacement of the ray at the sides of a
 * periodic domain since the point, in whole periods, which identifies the image
 * of the light. */
double murk_direct_rest(const murk_scenery *scenery,
                        const murk_shading_point *place, size_t light,
                        murk_vec3 arriving, double per_sr, murk_vec3 wrapped);

#endif
