/* How much the domain's own media take of light that comes from outside.
 *
 * Models of sun and sky give what the whole atmosphere leaves, weather
 * included. A scene that has fog in its domain, too, dims that light a second
 * time: this says by how much, so that a user can tell whether it is meant.
 *
 * Rays that nothing random is in: parallel to the beam, through the middles of
 * equal squares of the domain's floor, from where they enter the domain to the
 * first surface, the first change of the index of refraction, or the floor. Of
 * a dome, such rays from 32 directions that have equal parts of an even sky's
 * irradiance. What is scattered on towards the floor counts as taken. */
#ifndef MURK_WORLD_DAYLIGHT_LOSS_H
#define MURK_WORLD_DAYLIGHT_LOSS_H

#include "world/stage.h"

typedef struct murk_daylight_loss {
    bool is_known; /* false: not distant light, or dark, or from below */
    double share;  /* of its power that does not come through, 0..1 */
    murk_spectrum optical_depth; /* mean of the rays, per band */
    murk_spectrum transmittance; /* likewise */
} murk_daylight_loss;

murk_daylight_loss murk_daylight_loss_of(const murk_stage *stage, size_t light);

#endif
