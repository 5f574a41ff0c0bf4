/* The parts into which daylight is cut, so that a year of hours can share the
 * light that is traced once: patches of the sky, and places of the sun.
 *
 * The patches are the 145 of Tregenza (Lighting Research and Technology 19
 * (1987) 13, doi:10.1177/096032718701900103): seven rows of 12 degrees and a
 * cap at the zenith. The places of the sun are those at 6 declinations and each
 * full hour angle that are above the horizon at a latitude, and those beside
 * them, raised to the horizon, so that a low sun lies between places, too.
 *
 * Directions have the coordinates east, north and up. */
#ifndef MURK_BASE_DAYLIGHT_PARTS_H
#define MURK_BASE_DAYLIGHT_PARTS_H

#include "base/vector.h"

#include <stddef.h>

#define MURK_SKY_PATCHES 145 /* Tregenza */
/* As many places as the lights of a scene leave beside the patches and some
 * lamps. */
#define MURK_SUN_DECLINATIONS 6
#define MURK_SUN_HOURS        24
/* All declinations and hours; 66 to 104 of them are places. */
#define MURK_SUN_PLACES_MAX (MURK_SUN_DECLINATIONS * MURK_SUN_HOURS)

/* The elevations and the azimuths, clockwise from north, that a patch lies
 * between; patch 0..144. The azimuths of the first patch of a row lie on both
 * sides of 0. */
typedef struct murk_patch_bounds {
    double low_rad, high_rad, from_rad, to_rad;
} murk_patch_bounds;
murk_patch_bounds murk_sky_patch_bounds(size_t patch);

/* The places of the sun at a latitude. */
typedef struct murk_sun_places {
    double latitude_rad;
    size_t n;
    murk_vec3 towards[MURK_SUN_PLACES_MAX];            /* [n] unit vectors */
    int number[MURK_SUN_DECLINATIONS][MURK_SUN_HOURS]; /* among the n; -1: far
                                                        * below the horizon */
} murk_sun_places;
void murk_sun_places_make(murk_sun_places *out, double latitude_deg);

/* The shares share[places->n] of a sun that stands in the unit direction `sun`,
 * above the horizon: at most three places about the sun have one. The vectors
 * to the places, times the shares, add up to `sun`, so that the irradiance of
 * each plane that all three light is exact; shares add up to a little more than
 * 1. Exceptions are a sun lower than .3 degrees, and one in ten thousand
 * positions at the edge of the places with a sun lower than a degree: there the
 * sum is off by up to .12. */
void murk_sun_places_share(const murk_sun_places *places, murk_vec3 sun,
                           double *share);

#endif
