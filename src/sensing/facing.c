/* Unpacks the normal of a stored surface photon. Normals along an axis are
 * stored exactly; all others have the error of the packing
 * (photonmap/photon.h). */
#include "sensing/facing.h"

murk_side murk_side_of(const murk_surfaces *surfaces, uint32_t packed)
{
    const murk_vec3 n = murk_direction_unpack(packed), zero = {0, 0, 0};
    const bool is_along_axis = (n.x == 0) + (n.y == 0) + (n.z == 0) == 2;
    const double tilt = is_along_axis ? 0 : MURK_DIRECTION_ERROR_RAD;
    return (murk_side){packed, n, murk_surfaces_leave(surfaces, zero, n),
                       tilt * tilt};
}
