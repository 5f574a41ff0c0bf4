/* Turning a direction: what each scattering and diffuse reflection does. In a
 * header because the photon's loop waits for it. Private to this room. */
#ifndef MURK_TRANSPORT_TURN_H
#define MURK_TRANSPORT_TURN_H

#include "base/vector.h"

/* Cosine and sine of 2 pi u, 0 <= u <= 1, to 3e-14: their series to x^14 within
 * an eighth of a turn, and from there whole quarter turns. Half the time of the
 * library's, which would be a fifth of a collision's, and the same bits on
 * every machine. */
static inline void murk_turn_once(double u, double *cosine, double *sine)
{
    static const double quarter_cosine[] = {1, 0, -1, 0, 1};
    static const double quarter_sine[] = {0, 1, 0, -1, 0};
    const int quarter = (int)(4 * u + 0.5);
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
    const double qc = quarter_cosine[quarter], qs = quarter_sine[quarter];
    *cosine = qc * c - qs * s;
    *sine = qs * c + qc * s;
}

/* One Newton step towards length 1: exact to the square of what rounding has
 * left it off by, and cheaper than a root and a division. */
static inline murk_vec3 murk_trimmed(murk_vec3 d)
{
    return murk_scale(1.5 - 0.5 * murk_dot(d, d), d);
}

/* Unit d turned by the angle of cosine mu, at azimuth 2 pi u_phi about it. */
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
