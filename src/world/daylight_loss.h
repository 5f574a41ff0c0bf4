/* The share of light from outside that the media of the domain absorb or
 * scatter before the light meets a surface, a change of the index of refraction
 * or the floor.
 *
 * Models of sun and sky give the light that the whole atmosphere lets through,
 * weather included. If the domain of a scene also contains fog, the fog dims
 * this light a second time. The share that is lost there lets a user judge
 * whether that is intended.
 *
 * The share is a mean over rays of a fixed pattern without random numbers. The
 * rays are parallel to the beam, lead to the middles of equal rectangles of the
 * domain's floor, and reach from their entry into the domain to the first
 * surface, the first change of the index of refraction, or the floor. If the
 * domain is periodic or continues outside, they begin straight above these
 * middles, at the top of the domain. A dome has such rays from 32 directions
 * with equal parts of the irradiance of an even sky. Light that is scattered
 * counts as lost, even if it goes on towards the floor. */
#ifndef MURK_WORLD_DAYLIGHT_LOSS_H
#define MURK_WORLD_DAYLIGHT_LOSS_H

#include "world/stage.h"

typedef struct murk_daylight_loss {
    bool is_known; /* false, and the other members 0: the light is not distant,
                    * is dark, or does not come from above */
    double share;  /* share of the light's power that is lost, 0..1 */
    murk_spectrum optical_depth; /* mean over the rays, by band */
    murk_spectrum transmittance; /* mean over the rays, by band */
} murk_daylight_loss;

murk_daylight_loss murk_daylight_loss_of(const murk_stage *stage, size_t light);

#endif
