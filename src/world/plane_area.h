/* How much of a plane lies in a box. */
#ifndef MURK_WORLD_PLANE_AREA_H
#define MURK_WORLD_PLANE_AREA_H

#include "base/vector.h"

/* [m2]; the normal need not be unit. 0 where it misses the box. */
double murk_plane_area(const murk_box *box, murk_vec3 point, murk_vec3 normal);

#endif
