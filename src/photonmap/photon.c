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

#define STEPS  32767.0 /* 2^15 - 1: 16 bits with a sign */
#define OFFSET 32768   /* stored coordinates are 1..65535, never 0 */

static double fold(double along, double across)
{
    return copysign(1 - fabs(across), along);
}

/* Added to a number below 2^51, it moves all digits after the point beyond the
 * 52 bits of the mantissa, so that the sum is rounded as by nearbyint(), which
 * is a call for processors before SSE4. */
#define ROUNDS 0x1.8p52

static uint32_t quantize(double coordinate)
{
    return (uint32_t)((int)(coordinate * STEPS + ROUNDS - ROUNDS) + OFFSET);
}

uint32_t murk_direction_pack(murk_vec3 unit)
{
    const double norm = fabs(unit.x) + fabs(unit.y) + fabs(unit.z);
    if (!(norm > 0 && isfinite(norm))) {
        return 0;
    }
    const double u = unit.x / norm, v = unit.y / norm;
    if (unit.z < 0) {
        return quantize(fold(u, v)) | quantize(fold(v, u)) << 16;
    }
    return quantize(u) | quantize(v) << 16;
}

murk_vec3 murk_direction_unpack(uint32_t packed)
{
    if (packed == 0) {
        return murk_vec(0, 0, 0);
    }
    const double u = ((int)(packed & 0xffff) - OFFSET) / STEPS;
    const double v = ((int)(packed >> 16) - OFFSET) / STEPS;
    const double z = 1 - fabs(u) - fabs(v);
    return murk_unit(z < 0 ? murk_vec(fold(u, v), fold(v, u), z)
                           : murk_vec(u, v, z));
}

murk_photon murk_photon_make(const murk_photon_values *v)
{
    const murk_vec3 at = v->position_m;
    return (murk_photon){
        .position_m = {(float)at.x, (float)at.y, (float)at.z},
        .direction = murk_direction_pack(v->direction),
        .normal = v->is_volume ? 0 : murk_direction_pack(v->normal),
        .power_w = (float)v->power_w,
        .emitted = v->emitted,
        .band = v->band,
        .light = v->light,
        .material = v->material,
        .kind = murk_photon_kind(v->is_volume, v->event_class)};
}
