/* Light of the sky: how its radiance is spread over the upper hemisphere.
 *
 * Relative radiance towards a place in the sky at zenith angle Z, at the angle
 * chi from the sun, is f(chi) phi(Z), with the gradation
 *     phi = 1 + a exp(b / cos Z)
 * and the indicatrix
 *     f = 1 + c (exp(d chi) - exp(d pi / 2)) + e cos^2 chi.
 * All zeros is the even sky, so that is what a struct set to zero means. Below
 * the horizon there is no sky.
 *
 * Source of the law and of the fifteen types: CIE S 011/E:2003 (ISO
 * 15469:2004), Spatial distribution of daylight - CIE standard general sky;
 * Darula and Kittler, CIE general sky standard defining luminance
 * distributions, eSim 2002. The coefficients are at second hand: as five open
 * programs that implement the standard agree on them. */
#ifndef MURK_SOURCE_DOME_H
#define MURK_SOURCE_DOME_H

#include "base/vector.h"

#define MURK_DOME_TYPES 15

typedef struct murk_dome {
    double a, b;       /* gradation */
    double c, d, e;    /* indicatrix; d per radian */
    murk_vec3 towards; /* the sun (or moon), from the ground; need not be unit,
                          may be below the horizon. Not read where c and e are
                          0 */
} murk_dome;

/* A type of the standard, 1..15: 1 overcast, 5 even, 12 clear. */
murk_dome murk_dome_cie(int type, murk_vec3 towards);

/* Relative radiance in a unit direction from the ground; 0 below the horizon.
 * dome->towards must be unit here, where it is read. */
double murk_dome_radiance(const murk_dome *dome, murk_vec3 direction);

#endif
