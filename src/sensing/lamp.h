/* Where the light of a lamp sets out from. Internal to the room.
 *
 * A lamp that hangs free shines from its place; one on a surface, from just off
 * either side. One in glass also lights what is around: then places just
 * outside the glass count too, each along one of six fixed ways. */
#ifndef MURK_SENSING_LAMP_H
#define MURK_SENSING_LAMP_H

#include "base/vector.h"
#include "geometry/surfaces.h"

#include <stddef.h>

#define MURK_LAMP_PLACES_MAX 64

/* Writes the places, and returns how many, >= 1. Only solids that a lamp stands
 * in are passed: all six ways out of the lamp cross them, so their hollow
 * counts as in. What is opaque, or absorbs all, ends a way. */
size_t murk_lamp_places(const murk_surfaces *surfaces,
                        const murk_domain *domain, murk_vec3 lamp,
                        murk_vec3 place[MURK_LAMP_PLACES_MAX]);

#endif
