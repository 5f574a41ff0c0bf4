/* The relative radiance of the sky over the upper hemisphere.
 *
 * Towards zenith angle Z and at the angle chi from the sun, the relative
 * radiance is f(chi) phi(Z), with the gradation
 *
 *     phi = 1 + a exp(b / cos Z)
 *
 * and the indicatrix
 *
 *     f = 1 + c (exp(d chi) - exp(d pi / 2)) + e cos^2 chi.
 *
 * If all coefficients are 0 the sky is even; a struct set to zero therefore
 * means the even sky. There is no sky below the horizon.
 *
 * Source of the law and of the fifteen types: CIE S 011/E:2003 (ISO
 * 15469:2004), Spatial distribution of daylight - CIE standard general sky;
 * Darula and Kittler, CIE general sky standard defining luminance
 * distributions, eSim 2002. The coefficients are from secondary sources: five
 * open programs that implement the standard and agree. */
#ifndef MURK_SOURCE_DOME_H
#define MURK_SOURCE_DOME_H

#include "base/vector.h"

#define MURK_DOME_TYPES 15 /* of CIE S 011 */

/* A part of the sky between two elevations and two azimuths. */
typedef struct murk_sky_patch {
    double low, high;        /* sines of the elevations; high 0: no patch */
    double from_rad, to_rad; /* azimuths from the axis x towards y, from_rad in
                              * 0..2 pi and to_rad above it, by at most 2 pi */
} murk_sky_patch;

typedef struct murk_dome {
    double a, b;          /* gradation */
    double c, d, e;       /* indicatrix; d per radian */
    murk_vec3 towards;    /* direction of the sun (or moon) from the ground; any
                           * length, may be below the horizon. Not read if c and e
                           * are 0 */
    murk_sky_patch patch; /* the sky is even in this patch and dark elsewhere;
                           * without a patch the whole sky shines */
} murk_dome;

/* Returns a type of the standard, 1..15: 1 overcast, 5 even, 12 clear. */
murk_dome murk_dome_cie(int type, murk_vec3 towards);

/* The relative radiance in a unit direction from the ground; 0 below the
 * horizon. If dome->towards is read, it must be a unit vector. */
double murk_dome_radiance(const murk_dome *dome, murk_vec3 direction);

#endif
