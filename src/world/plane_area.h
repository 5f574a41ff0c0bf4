/* The area of the part of a plane that lies in a box. */
#ifndef MURK_WORLD_PLANE_AREA_H
#define MURK_WORLD_PLANE_AREA_H

#include "base/vector.h"

/* The area in m2 of the part of the plane through `point` that lies in the box;
 * 0 if the plane misses the box. The normal need not have unit length. */
double murk_plane_area(const murk_box *box, murk_vec3 point, murk_vec3 normal);

#endif
