/* Octahedral packing of directions (Cigolle et al. 2014): the unit sphere is
 * projected on the octahedron |x| + |y| + |z| = 1, the lower half is folded
 * over the upper one, and the two remaining coordinates are rounded to a
 * lattice of 2 * 32767 steps on each side.
 *
 * The error: each coordinate is wrong by at most h / 2, h = 1 / 32767. On a
 * face of the octahedron, x + y + z = 1 (up to signs), this moves the point by
 * at most sqrt(a^2 + b^2 + (a + b)^2) with a = b = h / 2, which is h sqrt(6) /
 * 2; across a fold the bound holds for each part. The face is at a distance of
 * 1 / sqrt(3) from the center, so the angle is at most h sqrt(6) / 2 * sqrt(3)
 * = 3 / (sqrt(2) 32767) = 6.474e-5. */
#include "photonmap/photon.h"

murk_vec3 murk_direction_unpack(uint32_t packed)
{
    if (packed == 0) {
        return murk_vec(0, 0, 0);
    }
    const double u =
        ((int)(packed & 0xffff) - MURK_DIRECTION_OFFSET) / MURK_DIRECTION_STEPS;
    const double v =
        ((int)(packed >> 16) - MURK_DIRECTION_OFFSET) / MURK_DIRECTION_STEPS;
    const double z = 1 - fabs(u) - fabs(v);
    return murk_unit(z < 0 ? murk_vec(murk_direction_fold(u, v),
                                      murk_direction_fold(v, u), z)
                           : murk_vec(u, v, z));
}
