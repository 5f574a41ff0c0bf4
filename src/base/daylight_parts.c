/* Patches of the sky, and places of the sun with their shares: the sun lies in
 * a triangle of places, whose shares solve three linear equations. */
#include "base/daylight_parts.h"

#include <math.h>

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

/* The numbers of the three places about a sun at a declination and hour angle:
 * each cell between places is cut along the diagonal from the higher
 * declination and the earlier hour. */
static void find_triangle(int node[3][2], double declination, double hour)
{
    const int last = MURK_SUN_DECLINATIONS - 2;
    const double u =
        fmin(fmax((declination + DECLINATION_MAX) / STEP, 0), last + 1);
    const double v = hour / HOUR - MURK_SUN_HOURS * floor(hour / (2 * MURK_PI));
    const int i = (int)fmin(floor(u), last), j = (int)floor(v) % MURK_SUN_HOURS;
    const int next = (j + 1) % MURK_SUN_HOURS;
    const int is_upper = u - i + (v - floor(v)) > 1;
    node[0][0] = i + is_upper;
    node[0][1] = is_upper ? next : j;
    node[1][0] = i;
    node[1][1] = next;
    node[2][0] = i + 1;
    node[2][1] = j;
}

void murk_sun_places_share(const murk_sun_places *places, murk_vec3 sun,
                           double *share)
{
    const double latitude = places->latitude_rad;
    const murk_vec3 pole = murk_vec(0, cos(latitude), sin(latitude)),
                    noon = murk_vec(0, -sin(latitude), cos(latitude));
    const double declination = asin(fmin(fmax(murk_dot(sun, pole), -1), 1));
    int node[3][2];
    murk_vec3 at[3];
    for (size_t k = 0; k < places->n; ++k) {
        share[k] = 0;
    }
    /* The corners of the triangle, and the shares by Cramer's rule. */
    find_triangle(node, declination, atan2(-sun.x, murk_dot(sun, noon)));
    for (int k = 0; k < 3; ++k) {
        at[k] = towards(latitude, node[k][0] * STEP - DECLINATION_MAX,
                        node[k][1] * HOUR);
    }
    const double volume = murk_dot(at[0], murk_cross(at[1], at[2]));
    double level = 0;
    for (int k = 0; k < 3; ++k) {
        const int number = places->number[node[k][0]][node[k][1]];
        const double own =
            murk_dot(sun, murk_cross(at[(k + 1) % 3], at[(k + 2) % 3])) /
            volume;
        /* Rounding and refraction may leave the sun a little outside. */
        if (number >= 0 && own > 0) {
            share[number] = own;
            level += own * at[k].z;
        }
    }
    /* Keep the irradiance of the level plane where a corner is left out. */
    for (size_t k = 0; k < places->n && level > 0; ++k) {
        share[k] *= sun.z / level;
    }
}
