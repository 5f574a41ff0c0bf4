/* Computes geocentric positions with the theories of libnova and transforms
 * them from the ecliptic of J2000 to the true equator of date: rotation by the
 * obliquity, precession, nutation (source/geocentric.h). */
#include "source/geocentric.h"

#include <libnova/earth.h>
#include <libnova/lunar.h>
#include <libnova/nutation.h>

#include <stdatomic.h>
#include <stddef.h>

/* Epoch (Julian date of 2000-01-01 12:00 TT) and units. */
#define J2000            2451545.0
#define DAYS_PER_CENTURY 36525.0
#define SECONDS_PER_DAY  86400.0
#define ASTRONOMICAL_M   149597870700.0 /* IAU 2012 */
#define LIGHT_M_PER_S    299792458.0
#define RAD_PER_DEG      (MURK_PI / 180)
#define RAD_PER_ARCSEC   (RAD_PER_DEG / 3600)
#define OBLIQUITY_J2000  84381.448 /* arc seconds, IAU 1976 */
/* A mean distance, exact enough for the light time, to .1 s. */
#define MOON_USUAL_M       384400e3
#define DAYS_WITHOUT_REUSE 100.0 /* libnova reuses nutation for .1 day */

/* The lock for the variables of libnova. A call takes some milliseconds at
 * most, and set-up makes a handful of calls. */
static atomic_flag libnova_is_taken = ATOMIC_FLAG_INIT;

static void take_libnova(void)
{
    while (atomic_flag_test_and_set_explicit(&libnova_is_taken,
                                             memory_order_acquire)) {
    }
}

static void give_libnova(void)
{
    atomic_flag_clear_explicit(&libnova_is_taken, memory_order_release);
}

typedef struct tilt {
    double longitude, obliquity; /* corrections [rad] */
} tilt;

static tilt nutation_at(double julian_date_tt)
{
    struct ln_nutation found;
    take_libnova();
    /* Evaluate another day first, so that libnova does not return a cached
     * result for this day. */
    ln_get_nutation(julian_date_tt + DAYS_WITHOUT_REUSE, &found);
    ln_get_nutation(julian_date_tt, &found);
    give_libnova();
    return (tilt){RAD_PER_DEG * found.longitude, RAD_PER_DEG * found.obliquity};
}

static double centuries(double julian_date)
{
    return (julian_date - J2000) / DAYS_PER_CENTURY;
}

static double mean_obliquity_rad(double julian_date_tt)
{
    const double t = centuries(julian_date_tt);
    return RAD_PER_ARCSEC *
           (OBLIQUITY_J2000 + t * (-46.8150 + t * (-0.00059 + t * 0.001813)));
}

/* The coordinates of v in a frame that is rotated by `angle` about x,
 * right-handed; likewise about y and z below. */
static murk_vec3 turn_x(double angle, murk_vec3 v)
{
    const double c = cos(angle), s = sin(angle);
    return murk_vec(v.x, c * v.y + s * v.z, c * v.z - s * v.y);
}

static murk_vec3 turn_y(double angle, murk_vec3 v)
{
    const double c = cos(angle), s = sin(angle);
    return murk_vec(c * v.x - s * v.z, v.y, s * v.x + c * v.z);
}

static murk_vec3 turn_z(double angle, murk_vec3 v)
{
    const double c = cos(angle), s = sin(angle);
    return murk_vec(c * v.x + s * v.y, c * v.y - s * v.x, v.z);
}

/* Transforms from the mean equator of J2000 to the mean equator of date. */
static murk_vec3 precess(double julian_date_tt, murk_vec3 v)
{
    const double t = centuries(julian_date_tt);
    const double zeta = t * (2306.2181 + t * (0.30188 + t * 0.017998));
    const double z = t * (2306.2181 + t * (1.09468 + t * 0.018203));
    const double theta = t * (2004.3109 - t * (0.42665 + t * 0.041833));
    v = turn_z(-zeta * RAD_PER_ARCSEC, v);
    v = turn_y(theta * RAD_PER_ARCSEC, v);
    return turn_z(-z * RAD_PER_ARCSEC, v);
}

/* Transforms from the ecliptic of J2000 to the true equator of date. */
static murk_vec3 to_true_equator(double julian_date_tt, murk_vec3 v)
{
    const double mean = mean_obliquity_rad(julian_date_tt);
    const tilt nutation = nutation_at(julian_date_tt);
    v = turn_x(-OBLIQUITY_J2000 * RAD_PER_ARCSEC, v);
    v = precess(julian_date_tt, v);
    v = turn_x(mean, v);
    v = turn_z(-nutation.longitude, v);
    return turn_x(-(mean + nutation.obliquity), v);
}

/* The time when the light left a body at some distance. Light time and
 * aberration together are corrected to first order in the speed of the earth:
 * body and earth are both taken at the time when the light left. */
static double when_left(double julian_date_tt, double distance_m)
{
    return julian_date_tt - distance_m / LIGHT_M_PER_S / SECONDS_PER_DAY;
}

murk_vec3 murk_geocentric_sun_m(double julian_date_tt)
{
    struct ln_helio_posn earth;
    take_libnova();
    ln_get_earth_helio_coords(julian_date_tt, &earth);
    ln_get_earth_helio_coords(
        when_left(julian_date_tt, ASTRONOMICAL_M * earth.R), &earth);
    give_libnova();
    const double length = ASTRONOMICAL_M * earth.R;
    const double longitude = RAD_PER_DEG * earth.L;
    const double latitude = RAD_PER_DEG * earth.B;
    const murk_vec3 sun = murk_vec(-length * cos(latitude) * cos(longitude),
                                   -length * cos(latitude) * sin(longitude),
                                   -length * sin(latitude));
    return to_true_equator(julian_date_tt, sun);
}

murk_vec3 murk_geocentric_moon_m(double julian_date_tt)
{
    struct ln_rect_posn moon; /* km */
    take_libnova();
    ln_get_lunar_geo_posn(when_left(julian_date_tt, MOON_USUAL_M), &moon, 0);
    give_libnova();
    return to_true_equator(julian_date_tt,
                           murk_vec(1e3 * moon.X, 1e3 * moon.Y, 1e3 * moon.Z));
}

double murk_true_obliquity_rad(double julian_date_tt)
{
    return mean_obliquity_rad(julian_date_tt) +
           nutation_at(julian_date_tt).obliquity;
}

double murk_sidereal_time_rad(double julian_date_ut, double julian_date_tt)
{
    const double days = julian_date_ut - J2000;
    const double t = days / DAYS_PER_CENTURY;
    const double mean_deg = 280.46061837 + 360.98564736629 * days +
                            t * t * (0.000387933 - t / 38710000);
    return RAD_PER_DEG * mean_deg +
           nutation_at(julian_date_tt).longitude *
               cos(murk_true_obliquity_rad(julian_date_tt));
}

/* The sum of coefficient[i] t^i. */
static double polynomial(const double *coefficient, int n, double t)
{
    double sum = 0;
    for (int i = n - 1; i >= 0; --i) {
        sum = sum * t + coefficient[i];
    }
    return sum;
}

double murk_delta_t_s(double julian_date_ut)
{
    /* Polynomials of Espenak and Meeus, each valid before a year. */
    static const struct {
        double before, origin; /* years */
        double coefficient[6];
    } pieces[] = {
        {1920, 1900, {-2.79, 1.494119, -0.0598939, 0.0061966, -0.000197}},
        {1941, 1920, {21.20, 0.84493, -0.076100, 0.0020936}},
        {1961, 1950, {29.07, 0.407, -1.0 / 233, 1.0 / 2547}},
        {1986, 1975, {45.45, 1.067, -1.0 / 260, -1.0 / 718}},
        {2005,
         2000,
         {63.86, 0.3345, -0.060374, 0.0017275, 0.000651814, 0.00002373599}},
        {2050, 2000, {62.92, 0.32217, 0.005589}},
        /* 32 ((y - 1820) / 100)^2 - 20 - .5628 (2150 - y), expanded about
         * 1820 */
        {HUGE_VAL, 1820, {-20 - 0.5628 * 330, 0.5628, 0.0032}},
    };
    const double year = 2000 + (julian_date_ut - 2451544.5) / 365.2425;
    size_t i = 0;
    while (year >= pieces[i].before) {
        ++i;
    }
    return polynomial(pieces[i].coefficient, 6, year - pieces[i].origin);
}
