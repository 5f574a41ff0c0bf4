/* The places from which the light of a lamp starts. For use inside src/sensing
 * only.
 *
 * The light of a lamp in free space starts at the lamp; that of a lamp on a
 * surface starts just off both sides (at the lamp, if no ray along an axis
 * finds the surface). For a lamp inside a transmitting solid, such as a glass
 * globe, places just outside of the solid count as well, in six fixed
 * directions. */
#ifndef MURK_SENSING_LAMP_H
#define MURK_SENSING_LAMP_H

#include "base/vector.h"
#include "geometry/surfaces.h"

#include <stddef.h>

/* Enough for the two sides of a surface, and for five crossings in each of six
 * directions from each side. Further places are left out. */
#define MURK_LAMP_PLACES_MAX 64

/* Writes the places and returns their number, >= 1. The solids that contain a
 * lamp are those that all six directions from the lamp cross, so the hollow of
 * a solid counts as inside. A direction is followed through the surfaces of
 * these solids and through thin sheets. It ends at another solid, and at a
 * surface that transmits no light. */
size_t murk_lamp_places(const murk_surfaces *surfaces,
                        const murk_domain *domain, murk_vec3 lamp,
                        murk_vec3 place[MURK_LAMP_PLACES_MAX]);

#endif
