/* The side of a surface from which a stored photon is seen. For
 * use inside src/sensing only. */
#ifndef MURK_SENSING_FACING_H
#define MURK_SENSING_FACING_H

#include "geometry/surfaces.h"
#include "photonmap/photon.h"

/* An unpacked normal. */
typedef struct murk_side {
    uint32_t packed;
    murk_vec3 normal;
    murk_vec3 off; /* step off the surface, the same at every position */
    double tilt2;  /* square of the largest error of a stored normal [rad2], an
                      upper bound of the squared sine of the error; 0 along an
                      axis */
} murk_side;

/* Unpacks a normal. Normals along an axis are stored exactly; all others have
 * the error of the packing (photonmap/photon.h). */
static inline murk_side murk_side_of(const murk_surfaces *surfaces,
                                     uint32_t packed)
{
    const murk_vec3 n = murk_direction_unpack(packed), zero = {0, 0, 0};
    const bool is_along_axis = (n.x == 0) + (n.y == 0) + (n.z == 0) == 2;
    const double tilt = is_along_axis ? 0 : MURK_DIRECTION_ERROR_RAD;
    return (murk_side){packed, n, murk_surfaces_leave(surfaces, zero, n),
                       tilt * tilt};
}

/* A cache of unpacked normals, because buildings have few distinct normals. The
 * entry is chosen by the upper bits of the hash (Fibonacci hashing, Knuth, The
 * Art of Computer Programming, vol. 3, 6.4). A cache starts with all bytes
 * zero: 0 is the packed form of no normal, and the normal of such an entry is
 * zero, so that the entry faces no sensor. 64 entries fit the first-level cache
 * of a processor. */
#define MURK_SIDES_LOG2 6
#define MURK_SIDES      (1 << MURK_SIDES_LOG2)

static inline const murk_side *murk_side_recall(murk_side sides[MURK_SIDES],
                                                const murk_surfaces *surfaces,
                                                uint32_t packed)
{
    murk_side *s =
        &sides[(packed * UINT32_C(2654435769)) >> (32 - MURK_SIDES_LOG2)];
    if (__builtin_expect(s->packed != packed, 0)) {
        *s = murk_side_of(surfaces, packed);
    }
    return s;
}

/* The end of the sightlines to a photon: the place of a volume photon, or for a
 * surface photon a point slightly off the surface. *side is set to the side of
 * the surface, or to NULL for a volume photon. */
static inline murk_vec3 murk_side_start(const murk_photon *photon,
                                        const murk_surfaces *surfaces,
                                        murk_side sides[MURK_SIDES],
                                        const murk_side **side)
{
    const murk_vec3 at = murk_photon_place(photon);
    *side = murk_photon_is_volume(photon)
                ? NULL
                : murk_side_recall(sides, surfaces,
                                   murk_photon_packed_normal(photon));
    return *side ? murk_add(at, (*side)->off) : at;
}

/* True if normal . (sensor - photon) exceeds the possible error of storage. */
static inline bool murk_side_faces(const murk_side *s, murk_vec3 photon,
                                   murk_vec3 sensor, double position_error_m)
{
    const murk_vec3 offset = murk_sub(sensor, photon);
    const double above = murk_dot(s->normal, offset) - position_error_m;
    /* Without a branch: the outcome is hard to predict. */
    return (above > 0) & (above * above > s->tilt2 * murk_dot(offset, offset));
}

#endif
