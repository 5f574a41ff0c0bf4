/* Patches of the sky, and places of the sun with their shares: the sun lies in
 * a triangle of places, whose shares solve three linear equations. */
#include "base/daylight_parts.h"

#include <math.h>
#include <stdbool.h>

#define DEG (MURK_PI / 180) /* radians */

/* Largest declination of the places: the obliquity of the ecliptic, 23.44
 * degrees, and a margin, so that the sun stays within the outermost triangles
 * where their corners are raised to the horizon. */
#define DECLINATION_MAX (25.5 * DEG)
#define STEP            (2 * DECLINATION_MAX / (MURK_SUN_DECLINATIONS - 1))
#define HOUR            (2 * MURK_PI / MURK_SUN_HOURS)

/* Sine of the elevation of places at the horizon: above the radius of the sun's
 * disc (.27 degrees), so that all of its light comes down. */
#define LOWEST 0.005

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

/* True if a place of a declination and hour is above the horizon. */
static bool is_up(double latitude, int row, int hour)
{
    return towards(latitude, row * STEP - DECLINATION_MAX, hour * HOUR).z >
           LOWEST;
}

/* True if any place of a cell that the place is a corner of is up: of those in
 * the rows and hours beside it. */
static bool is_beside_one_up(double latitude, int row, int hour)
{
    bool is_beside = false;
    for (int i = row - 1; i <= row + 1; ++i) {
        for (int j = hour - 1; j <= hour + 1; ++j) {
            is_beside = is_beside || (i >= 0 && i < MURK_SUN_DECLINATIONS &&
                                      is_up(latitude, i, j));
        }
    }
    return is_beside;
}

void murk_sun_places_make(murk_sun_places *out, double latitude_deg)
{
    const double latitude = latitude_deg * DEG;
    out->n = 0;
    for (int i = 0; i < MURK_SUN_DECLINATIONS; ++i) {
        for (int j = 0; j < MURK_SUN_HOURS; ++j) {
            murk_vec3 d =
                towards(latitude, i * STEP - DECLINATION_MAX, j * HOUR);
            out->number[i][j] =
                is_beside_one_up(latitude, i, j) ? (int)out->n : -1;
            if (out->number[i][j] < 0) {
                continue;
            }
            if (!(d.z > LOWEST)) { /* raised to the horizon */
                const double level = sqrt(d.x * d.x + d.y * d.y);
                const double to = sqrt((1 - LOWEST) * (1 + LOWEST));
                d = murk_vec(d.x / level * to, d.y / level * to, LOWEST);
            }
            out->towards[out->n++] = d;
        }
    }
    out->latitude_rad = latitude;
}

/* A triangle of places, and the shares of a sun in them. */
typedef struct triangle {
    int number[3];             /* of the places */
    double share[3], smallest; /* may be negative: the sun is outside */
} triangle;

/* One of the two triangles of a cell between two declinations and two hours,
 * with the shares by Cramer's rule. A triangle with a corner that is no place
 * has no shares. */
static triangle triangle_of(const murk_sun_places *places, int row, int hour,
                            bool is_upper, murk_vec3 sun)
{
    const int first = hour % MURK_SUN_HOURS, next = (hour + 1) % MURK_SUN_HOURS;
    triangle t = {
        .number = {places->number[row + is_upper][is_upper ? next : first],
                   places->number[row][next], places->number[row + 1][first]},
        .smallest = -INFINITY};
    murk_vec3 at[3];
    for (int k = 0; k < 3; ++k) {
        if (t.number[k] < 0) {
            return t;
        }
        at[k] = places->towards[t.number[k]];
    }
    /* Shares of a triangle without extent are not finite, and do not count. */
    const double volume = murk_dot(at[0], murk_cross(at[1], at[2]));
    double smallest = INFINITY;
    for (int k = 0; k < 3; ++k) {
        t.share[k] =
            murk_dot(sun, murk_cross(at[(k + 1) % 3], at[(k + 2) % 3])) /
            volume;
        smallest = fmin(smallest, t.share[k]);
    }
    t.smallest = fabs(volume) > 0 ? smallest : -INFINITY;
    return t;
}

/* The triangle about the sun. Sides of triangles are great circles, between
 * which circles of equal declination bend, and corners at the horizon are
 * raised, so the triangle may belong to a neighbour of the cell in which
 * declination and hour angle lie. */
static triangle find_triangle(const murk_sun_places *places, murk_vec3 sun)
{
    const double latitude = places->latitude_rad;
    const murk_vec3 pole = murk_vec(0, cos(latitude), sin(latitude)),
                    noon = murk_vec(0, -sin(latitude), cos(latitude));
    const double declination = asin(fmin(fmax(murk_dot(sun, pole), -1), 1));
    const double hour = atan2(-sun.x, murk_dot(sun, noon)) / HOUR;
    const int row = (int)floor((declination + DECLINATION_MAX) / STEP);
    const int column = (int)floor(hour) + MURK_SUN_HOURS;
    triangle found = {.smallest = -INFINITY};
    for (int k = 0; k < 18; ++k) { /* two triangles of each of nine cells */
        const int i = row - 1 + k / 6, j = column - 1 + k / 2 % 3;
        if (i >= 0 && i <= MURK_SUN_DECLINATIONS - 2) {
            const triangle t = triangle_of(places, i, j, k % 2, sun);
            found = t.smallest > found.smallest ? t : found;
        }
    }
    return found;
}

void murk_sun_places_share(const murk_sun_places *places, murk_vec3 sun,
                           double *share)
{
    const triangle t = find_triangle(places, sun);
    for (size_t k = 0; k < places->n; ++k) {
        share[k] = 0;
    }
    if (t.smallest == -INFINITY) {
        return;
    }
    /* A sun lower than the places at the horizon, or one that refraction
     * raises, may be a little outside of all triangles: then the irradiance of
     * a plane that faces the sun is exact alone. */
    double facing = 0;
    for (int k = 0; k < 3; ++k) {
        share[t.number[k]] += fmax(0, t.share[k]);
        facing +=
            fmax(0, t.share[k]) * murk_dot(places->towards[t.number[k]], sun);
    }
    for (int k = 0; k < 3 && t.smallest < 0; ++k) {
        share[t.number[k]] /= facing;
    }
}
