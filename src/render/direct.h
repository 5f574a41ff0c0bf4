/* Direct light at a place, by shadow rays: what comes straight from the lights,
 * scattered or reflected there towards whoever looks. */
#ifndef MURK_RENDER_DIRECT_H
#define MURK_RENDER_DIRECT_H

#include "base/rng.h"
#include "medium/phase.h"
#include "render/scenery.h"

typedef struct murk_shading_point {
    int band;
    murk_vec3 position;
    murk_vec3 sight;  /* unit, of who looks, arriving at the place */
    double index;     /* of refraction, there */
    bool is_in_solid; /* where no shadow ray goes */
    /* a surface: */
    murk_vec3 normal; /* unit, faces who looks */
    double diffuse;   /* reflected by cosine law */
    /* a medium, where phase is not NULL: */
    const murk_phase *phase;
    double albedo;
    double cone; /* cosine: light that turns by less is looked for by going on,
                    not asked of the maps; -1 all, 1 none */
} murk_shading_point;

/* Light that the looking ray may also meet by going on from the place: of both
 * ways to find it each counts by how densely it looks there (the balance
 * heuristic: Veach and Guibas, SIGGRAPH 1995, doi:10.1145/218380.218498), so
 * that neither has to find what the other finds by far better. */
typedef struct murk_balance {
    bool goes_on; /* the ray goes on, with the density of its own law; in a
                     medium within the place's cone */
    bool sheets;  /* thin sheets let light through straight on, by their
                     transmittances; else they block */
} murk_balance;

/* Radiance [W/m2/sr] towards who looks, divided by the square of the index, for
 * the random numbers of that address. */
double murk_direct_light(const murk_scenery *scenery,
                         const murk_shading_point *place,
                         const murk_address *address, murk_balance balance);

/* The share that counts of a light that the ray, gone on from the place, has
 * met in a direction of travel that is drawn per_sr by murk_sources_shine().
 * wrapped: how far the sides of a periodic domain have moved the ray back since
 * the place; whole periods, which name the image that it has met. */
double murk_direct_rest(const murk_scenery *scenery,
                        const murk_shading_point *place, size_t light,
                        murk_vec3 arriving, double per_sr, murk_vec3 wrapped);

#endif
