/* Which side of its surface a stored photon is seen from. Internal to the room.
 */
#ifndef MURK_SENSING_FACING_H
#define MURK_SENSING_FACING_H

#include "geometry/surfaces.h"
#include "photonmap/photon.h"

/* A normal unpacked. */
typedef struct murk_side {
    uint32_t packed;
    murk_vec3 normal;
    murk_vec3 off; /* the step off the surface, the same wherever it lies */
    double tilt2;  /* squared sine of what storing may have turned it by */
} murk_side;

murk_side murk_side_of(const murk_surfaces *surfaces, uint32_t packed);

/* Built places have few normals, so those met last are kept; where among them
 * is told by the upper bits of its hash (Fibonacci). All zero to begin with: 0
 * is nothing's normal, and sees nothing. */
#define MURK_SIDES_LOG2 6
#define MURK_SIDES      (1 << MURK_SIDES_LOG2)

static inline const murk_side *murk_side_recall(murk_side sides[MURK_SIDES],
                                                const murk_surfaces *surfaces,
                                                uint32_t packed)
{
    murk_side *s =
        &sides[(packed * UINT32_C(2654435769)) >> (32 - MURK_SIDES_LOG2)];
    if (s->packed != packed) {
        *s = murk_side_of(surfaces, packed);
    }
    return s;
}

/* normal . (sensor - photon) > what storage may have moved it by. */
static inline bool murk_side_faces(const murk_side *s, murk_vec3 photon,
                                   murk_vec3 sensor, double position_error_m)
{
    const murk_vec3 way = murk_sub(sensor, photon);
    const double above = murk_dot(s->normal, way) - position_error_m;
    return above > 0 && above * above > s->tilt2 * murk_dot(way, way);
}

#endif
