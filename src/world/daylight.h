/* Daylight in parts: sun and sky of a light of type daylight, shared out among
 * patches of the sky and places of the sun (base/daylight_parts.h). */
#ifndef MURK_WORLD_DAYLIGHT_H
#define MURK_WORLD_DAYLIGHT_H

#include "base/daylight_parts.h"
#include "source/sources.h"

/* What the parts of one light have in common. */
typedef struct murk_daylight {
    murk_vec3 north;
    murk_sun_places places;
    double patch[MURK_SKY_PATCHES]; /* shares of the irradiance of the sky on a
                                     * level plane; they add up to 1 */
    double place[MURK_SUN_PLACES_MAX]; /* shares of the sun, as
                                        * murk_sun_places_share() */
} murk_daylight;

/* Shares out a sun and a sky, which were converted as a whole
 * (murk_sky_light()). north: unit vector in the coordinates of the scene. A sun
 * below the horizon has no shares. */
void murk_daylight_make(murk_daylight *out, const murk_source *sun,
                        const murk_source *sky, double latitude_deg,
                        murk_vec3 north);

/* Turns *out, a copy of the whole sky, into the patch 0..144: an even sky
 * there, with the share of the irradiance. */
void murk_daylight_patch(murk_source *out, const murk_daylight *daylight,
                         size_t patch);

/* Turns *out, a copy of the whole sun, into the place 0..n-1: from there, with
 * the share of the irradiance. */
void murk_daylight_place(murk_source *out, const murk_daylight *daylight,
                         size_t place);

#endif
