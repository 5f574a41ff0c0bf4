/* Shares out sun and sky among the parts of daylight. A patch gets the mean
 * radiance of the sky in it, by the midpoints of some cells, and then all
 * patches one factor by which the irradiance of a level plane is exact. (With
 * the radiance that is right for the level plane in each patch, windows would
 * get up to 4 % too little: near the horizon a clear sky is brightest below.)
 */
#include "world/daylight.h"

#include <math.h>

#include "source/patch_table.h"

/* Angular radius of a place of the sun: the mean radius of the sun's disc
 * (.2666 degrees at one astronomical unit). */
#define SUN_RADIUS_RAD (0.2666 * MURK_PI / 180)

#define TURN (2 * MURK_PI) /* all around */

/* A direction (east, north, up) in the coordinates of the scene. */
static murk_vec3 in_scene(murk_vec3 d, murk_vec3 north)
{
    const murk_vec3 east = murk_vec(north.y, -north.x, 0);
    murk_vec3 out = murk_vec(0, 0, d.z);
    out = murk_along(out, d.x, east);
    return murk_along(out, d.y, north);
}

static murk_vec3 from_scene(murk_vec3 d, murk_vec3 north)
{
    return murk_vec(d.x * north.y - d.y * north.x,
                    d.x * north.x + d.y * north.y, d.z);
}

static murk_sky_patch patch_of(const murk_daylight *daylight, size_t patch)
{
    const murk_patch_bounds bounds = murk_sky_patch_bounds(patch);
    const double north = atan2(daylight->north.y, daylight->north.x);
    const double from = north - bounds.to_rad;
    const double turned = from - TURN * floor(from / TURN);
    return (murk_sky_patch){.low = sin(bounds.low_rad),
                            .high = sin(bounds.high_rad),
                            .from_rad = turned,
                            .to_rad =
                                turned + (bounds.to_rad - bounds.from_rad)};
}

/* The irradiance of a level plane by the mean relative radiance of a patch. */
static double level_irradiance(const murk_dome *dome,
                               const murk_sky_patch *patch)
{
    const int cells = MURK_PATCH_CELLS;
    double sum = 0;
    for (int c = 0; c < cells * cells; ++c) {
        const murk_vec3 d = murk_sky_patch_at(patch, (c / cells + .5) / cells,
                                              (c % cells + .5) / cells);
        sum += murk_dome_radiance(dome, d);
    }
    /* The mean sine of the elevation is that of the middle: cells of equal
     * solid angle have equal steps of the sine. */
    return sum * murk_sky_patch_sr(patch) * (patch->low + patch->high) / 2;
}

void murk_daylight_make(murk_daylight *out, const murk_source *sun,
                        const murk_source *sky, double latitude_deg,
                        murk_vec3 north)
{
    const murk_vec3 to_sun = from_scene(murk_scale(-1, sun->direction), north);
    murk_dome dome = sky->dome;
    double sum = 0;
    out->north = north;
    if (dome.c != 0 || dome.e != 0) {
        dome.towards = murk_unit(dome.towards);
    }
    /* The patches, then the places. */
    for (size_t k = 0; k < MURK_SKY_PATCHES; ++k) {
        const murk_sky_patch patch = patch_of(out, k);
        out->patch[k] = level_irradiance(&dome, &patch);
        sum += out->patch[k];
    }
    for (size_t k = 0; k < MURK_SKY_PATCHES; ++k) {
        out->patch[k] /= sum;
    }
    murk_sun_places_make(&out->places, latitude_deg);
    if (to_sun.z > 0) {
        murk_sun_places_share(&out->places, to_sun, out->place);
    } else {
        for (size_t k = 0; k < out->places.n; ++k) {
            out->place[k] = 0;
        }
    }
}

static void multiply(murk_spectrum *power, double factor)
{
    for (int b = 0; b < MURK_BANDS_MAX; ++b) {
        power->band[b] *= factor;
    }
}

void murk_daylight_patch(murk_source *out, const murk_daylight *daylight,
                         size_t patch)
{
    out->is_part = true;
    out->dome = (murk_dome){.patch = patch_of(daylight, patch)};
    multiply(&out->power_w, daylight->patch[patch]);
}

void murk_daylight_place(murk_source *out, const murk_daylight *daylight,
                         size_t place)
{
    out->is_part = true;
    out->direction = murk_scale(
        -1, in_scene(daylight->places.towards[place], daylight->north));
    out->angular_radius_rad = SUN_RADIUS_RAD;
    multiply(&out->power_w, daylight->place[place]);
}
