/* The share of light from outside that the media of the domain absorb or
 * scatter before the light meets a surface, a change of the index of refraction
 * or the floor, which is the lower side of the domain.
 *
 * Models of sun and sky give the light that the whole atmosphere lets through,
 * clouds and haze included. If the domain of a scene also contains fog, the fog
 * dims this light a second time. The share that is lost in the domain lets a
 * user judge whether the fog in the scene is intended.
 *
 * The share is a mean over rays of a fixed pattern without random numbers. The
 * floor is divided into equal rectangles with one ray for each rectangle,
 * parallel to the beam. The ray ends at the middle of the rectangle and begins
 * where it enters the domain. If the domain is periodic or the media continue
 * outside, the ray instead begins straight above the middle, at the top of the
 * domain, and ends at the height of the floor. A surface or a change of the
 * index of refraction ends a ray early. A dome has such rays from 32 directions
 * with equal parts of the irradiance of an even sky. Light that is scattered
 * counts as lost, even if it goes on towards the floor. */
#ifndef MURK_WORLD_DAYLIGHT_LOSS_H
#define MURK_WORLD_DAYLIGHT_LOSS_H

#include "world/stage.h"

typedef struct murk_daylight_loss {
    bool is_known; /* false, with 0 in the other members, if the light is not
                    * distant, has no power, or does not come from above */
    double share;  /* share of the light's power that is lost, 0..1, over all
                    * bands */
    murk_spectrum optical_depth; /* mean over the rays, by band */
    murk_spectrum transmittance; /* mean over the rays, by band */
} murk_daylight_loss;

murk_daylight_loss murk_daylight_loss_of(const murk_stage *stage, size_t light);

#endif
