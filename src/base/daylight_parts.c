/* Patches of the sky, and places of the sun with their shares: the sun lies in
 * a triangle of places, whose shares solve three linear equations. */
#include "base/daylight_parts.h"

#include <math.h>
#include <stdbool.h>

#define DEG (MURK_PI / 180) /* radians */

/* Largest declination of the places: the obliquity of the ecliptic, 23.44
 * degrees, rounded up. */
#define DECLINATION_MAX (23.45 * DEG)
#define STEP            (2 * DECLINATION_MAX / (MURK_SUN_DECLINATIONS - 1))
#define HOUR            (2 * MURK_PI / MURK_SUN_HOURS)

/* Sine of the elevation below which there is no place: light along the horizon
 * would not come down. */
#define LOWEST 0.01

murk_patch_bounds murk_sky_patch_bounds(size_t patch)
{
    /* Patches of each row, which is 12 degrees high (Tregenza 1987). */
    static const size_t in_row[] = {30, 30, 24, 24, 18, 12, 6, 1};
    const double height = 12 * DEG;
    size_t row = 0;
    while (patch >= in_row[row]) {
        patch -= in_row[row++];
    }
    const double width = 2 * MURK_PI / (double)in_row[row];
    return (murk_patch_bounds){
        .low_rad = (double)row * height,
        .high_rad = fmin((double)(row + 1) * height, MURK_PI / 2),
        .from_rad = ((double)patch - .5) * width,
        .to_rad = ((double)patch + .5) * width};
}

static murk_vec3 towards(double latitude, double declination, double hour)
{
    const double level = cos(declination), up = sin(declination);
    return murk_vec(-level * sin(hour),
                    cos(latitude) * up - sin(latitude) * level * cos(hour),
                    sin(latitude) * up + cos(latitude) * level * cos(hour));
}

void murk_sun_places_make(murk_sun_places *out, double latitude_deg)
{
    out->n = 0;
    out->latitude_rad = latitude_deg * DEG;
    for (int i = 0; i < MURK_SUN_DECLINATIONS; ++i) {
        for (int j = 0; j < MURK_SUN_HOURS; ++j) {
            const murk_vec3 d = towards(out->latitude_rad,
                                        i * STEP - DECLINATION_MAX, j * HOUR);
            out->number[i][j] = d.z > LOWEST ? (int)out->n : -1;
            if (d.z > LOWEST) {
                out->towards[out->n++] = d;
            }
        }
    }
}

/* A triangle of places, which may be below the horizon, and the shares of a sun
 * in them. */
typedef struct triangle {
    int row[3], hour[3];
    murk_vec3 at[3];
    double share[3], smallest; /* may be negative: the sun is outside */
} triangle;

/* One of the two triangles of a cell between two declinations and two hours,
 * with the shares by Cramer's rule. */
static triangle triangle_of(double latitude, int row, int hour, bool is_upper,
                            murk_vec3 sun)
{
    const int next = (hour + 1) % MURK_SUN_HOURS;
    triangle t = {.row = {row + is_upper, row, row + 1},
                  .hour = {is_upper ? next : hour, next, hour}};
    for (int k = 0; k < 3; ++k) {
        t.at[k] = towards(latitude, t.row[k] * STEP - DECLINATION_MAX,
                          t.hour[k] * HOUR);
    }
    const double volume = murk_dot(t.at[0], murk_cross(t.at[1], t.at[2]));
    t.smallest = INFINITY;
    for (int k = 0; k < 3; ++k) {
        t.share[k] =
            murk_dot(sun, murk_cross(t.at[(k + 1) % 3], t.at[(k + 2) % 3])) /
            volume;
        t.smallest = fmin(t.smallest, t.share[k]);
    }
    return t;
}

/* The triangle about the sun. Sides of triangles are great circles, between
 * which circles of equal declination bend, so the triangle may belong to a
 * neighbour of the cell in which the declination lies. */
static triangle find_triangle(double latitude, murk_vec3 sun)
{
    const murk_vec3 pole = murk_vec(0, cos(latitude), sin(latitude)),
                    noon = murk_vec(0, -sin(latitude), cos(latitude));
    const double declination = asin(fmin(fmax(murk_dot(sun, pole), -1), 1));
    const double hour = atan2(-sun.x, murk_dot(sun, noon)) / HOUR;
    const int row = (int)floor((declination + DECLINATION_MAX) / STEP);
    const int j = ((int)floor(hour) + MURK_SUN_HOURS) % MURK_SUN_HOURS;
    triangle found = {.smallest = -INFINITY};
    for (int i = row - 1; i <= row + 1; ++i) {
        for (int upper = 0; upper < 2; ++upper) {
            if (i < 0 || i > MURK_SUN_DECLINATIONS - 2) {
                continue;
            }
            const triangle t = triangle_of(latitude, i, j, upper, sun);
            found = t.smallest > found.smallest ? t : found;
        }
    }
    return found;
}

void murk_sun_places_share(const murk_sun_places *places, murk_vec3 sun,
                           double *share)
{
    const triangle t = find_triangle(places->latitude_rad, sun);
    double level = 0;
    for (size_t k = 0; k < places->n; ++k) {
        share[k] = 0;
    }
    /* Refraction may leave the sun a little outside of all triangles. */
    for (int k = 0; k < 3; ++k) {
        const int number = places->number[t.row[k]][t.hour[k]];
        if (number >= 0 && t.share[k] > 0) {
            share[number] = t.share[k];
            level += t.share[k] * t.at[k].z;
        }
    }
    /* Keep the irradiance of the level plane where a corner is left out. */
    for (size_t k = 0; k < places->n && level > 0; ++k) {
        share[k] *= sun.z / level;
    }
}
