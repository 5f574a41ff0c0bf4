/* Rotation of a direction by a scattering angle, for scattering and diffuse
 * reflection. The functions are inline and have no branches, so that a compiler
 * can compute them for several photons at once (transport/lanes_step.c). For
 * use inside src/transport only. */
#ifndef MURK_TRANSPORT_TURN_H
#define MURK_TRANSPORT_TURN_H

#include <stdint.h>
#include <string.h>

#include "base/vector.h"

static inline uint64_t murk_bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double murk_double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Cosine and sine of 2 pi u, 0 <= u <= 1, with an error of 3e-14: Taylor series
 * to x^14 within an eighth of a turn, and whole quarter turns. This takes half
 * the time of the functions of the C library, which would be a fifth of the
 * time of a collision, and gives the same bits on every machine. */
static inline void murk_turn_once(double u, double *cosine, double *sine)
{
    const double quarter = floor(4 * u + 0.5);
    const double x = 2 * MURK_PI * (u - 0.25 * quarter), x2 = x * x;
    const double s =
        x * (1 + x2 * (-1. / 6 +
                       x2 * (1. / 120 +
                             x2 * (-1. / 5040 +
                                   x2 * (1. / 362880 +
                                         x2 * (-1. / 39916800 +
                                               x2 * (1. / 6227020800)))))));
    const double c =
        1 + x2 * (-1. / 2 +
                  x2 * (1. / 24 +
                        x2 * (-1. / 720 +
                              x2 * (1. / 40320 +
                                    x2 * (-1. / 3628800 +
                                          x2 * (1. / 479001600 -
                                                x2 * (1. / 87178291200)))))));
    /* An odd number of quarter turns exchanges the two; the signs follow from
     * the quarter, 0 to 4, which is read from the last bits of the sum with
     * 2^52: few operations in vectors. */
    const uint64_t n = murk_bits_of(quarter + 0x1p52);
    const uint64_t is_odd = 0 - (n & 1);
    const uint64_t c_bits = murk_bits_of(c), s_bits = murk_bits_of(s);
    const uint64_t exchanged = (c_bits ^ s_bits) & is_odd;
    *cosine = murk_double_of(c_bits ^ exchanged ^ ((n + 1) & 2) << 62);
    *sine = murk_double_of(s_bits ^ exchanged ^ (n & 2) << 62);
}

/* One Newton step towards length 1: the remaining error is the square of the
 * rounding error, and the step is cheaper than a square root and a division. */
static inline murk_vec3 murk_trimmed(murk_vec3 d)
{
    return murk_scale(1.5 - 0.5 * murk_dot(d, d), d);
}

/* The unit direction d rotated by the angle of cosine mu, at azimuth 2 pi
 * u_phi. */
static inline murk_vec3 murk_turned_direction(murk_vec3 d, double mu,
                                              double u_phi)
{
    murk_vec3 t, b;
    murk_frame(d, &t, &b);
    double cosine, sine;
    murk_turn_once(u_phi, &cosine, &sine);
    const double s2 = 1 - mu * mu, s = sqrt(s2 > 0 ? s2 : 0);
    const double along_t = s * cosine, along_b = s * sine;
    return murk_trimmed(murk_vec(mu * d.x + along_t * t.x + along_b * b.x,
                                 mu * d.y + along_t * t.y + along_b * b.y,
                                 mu * d.z + along_t * t.z + along_b * b.z));
}

#endif
