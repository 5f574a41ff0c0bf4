/* Independent normal numbers at the whole places, between them their mean by
 * smooth weights, over the root of the sum of squared weights: so the variance
 * is 1 everywhere, not at the whole places alone. */
#include "kinds.h"

#include "base/rng.h"

#include <math.h>

#define OCTAVES_MAX 8

static double normal_at(uint32_t seed, uint32_t layer, int64_t i, int64_t j,
                        int64_t k)
{
    /* 32 bits of x and of y, the address's event is z */
    const uint64_t column = (uint64_t)(uint32_t)i | (uint64_t)(uint32_t)j << 32;
    const murk_random4 r =
        murk_random(seed, MURK_TEST, column, (uint32_t)k, layer);
    return sqrt(-2 * log(r.u[0])) * cos(2 * MURK_PI * r.u[1]);
}

static double smooth(double t)
{
    return t * t * t * (t * (6 * t - 15) + 10);
}

static double one_octave(uint32_t seed, uint32_t layer, murk_vec3 p)
{
    const double x = floor(p.x), y = floor(p.y), z = floor(p.z);
    const double s[3] = {smooth(p.x - x), smooth(p.y - y), smooth(p.z - z)};
    double sum = 0, squares = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
        const double weight = (a ? s[0] : 1 - s[0]) * (b ? s[1] : 1 - s[1]) *
                              (c ? s[2] : 1 - s[2]);
        sum += weight * normal_at(seed, layer, (int64_t)x + a, (int64_t)y + b,
                                  (int64_t)z + c);
        squares += weight * weight;
    }
    return sum / sqrt(squares);
}

double noise_normal(uint32_t seed, uint32_t layer, int octaves, murk_vec3 p)
{
    double sum = 0, variance = 0, share = 1, scale = 1;
    for (int i = 0; i < octaves; ++i) {
        sum += sqrt(share) * one_octave(seed, layer * OCTAVES_MAX + (uint32_t)i,
                                        murk_scale(scale, p));
        variance += share;
        share /= 2;
        scale *= 2;
    }
    return sum / sqrt(variance);
}

double noise_patches(double spread, double noise)
{
    return exp(spread * noise - spread * spread / 2);
}

double normal_share(double deviation, double from, double to)
{
    const double scale = deviation * 1.41421356237309504880;
    return (erf(to / scale) - erf(from / scale)) / 2;
}
