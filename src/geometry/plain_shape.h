/* The convex shapes of regions that are tested for intersection with closed
 * meshes: half space, box and sphere. */
#ifndef MURK_GEOMETRY_PLAIN_SHAPE_H
#define MURK_GEOMETRY_PLAIN_SHAPE_H

#include "base/vector.h"

typedef enum murk_plain {
    MURK_PLAIN_BELOW, /* half space of the points with z < box.max.z, in world
                         coordinates */
    MURK_PLAIN_BOX,
    MURK_PLAIN_SPHERE
} murk_plain;

typedef struct murk_plain_shape {
    murk_plain plain;
    murk_box box; /* finite, except for half spaces */
    murk_vec3 center;
    double radius_m;
    murk_affine to_world; /* a similarity; not used for half spaces */
} murk_plain_shape;

#endif
