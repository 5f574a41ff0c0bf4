/* Converts geocentric positions of sun and moon to azimuth, elevation, distance
 * and phase for an observer, with parallax and refraction
 * (source/ephemeris.h). */
#include "source/ephemeris.h"

#include "base/vector.h"
#include "source/geocentric.h"

#include <assert.h>
#include <stddef.h>

#define DEG_PER_RAD     (180 / MURK_PI) /* radians to degrees */
#define SECONDS_PER_DAY 86400.0         /* of universal time */

/* WGS 84 */
#define EARTH_RADIUS_M   6378137.0
#define EARTH_FLATTENING (1 / 298.257223563)

#define SUN_RADIUS_M  695.99e6 /* 959.63 arc seconds at 1 au */
#define MOON_RADIUS_M 1737.4e3 /* IAU mean radius */

/* The refraction at the horizon in the SPA of NREL (source/ephemeris.h): a disc
 * with the upper edge below this depression is invisible and not raised. */
#define HORIZON_REFRACTION_DEG 0.5667

typedef struct range {
    const char *name;
    double value, min, max;
    const char *unit;
} range;

static murk_status check_observer(const murk_observer *o, murk_error *err)
{
    const range ranges[] = {
        {"latitude", o->latitude_deg, -90, 90, "degrees"},
        {"longitude", o->longitude_deg, -180, 360, "degrees"},
        {"altitude", o->altitude_m, -500, 20000, "m"},
        {"pressure", o->pressure_hpa, 0, 1200, "hPa"},
        {"temperature", o->temperature_c, -100, 100, "degrees C"},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; ++i) {
        const range *r = &ranges[i];
        if (!(r->value >= r->min && r->value <= r->max)) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "the observer's %s is %g, must be %g..%g %s",
                             r->name, r->value, r->min, r->max, r->unit);
        }
    }
    return MURK_OK;
}

static murk_status check(const murk_observer *observer, double julian_date_utc,
                         murk_error *err)
{
    if (!(julian_date_utc >= MURK_EPHEMERIS_FROM &&
          julian_date_utc < MURK_EPHEMERIS_TO)) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "the date (Julian date %.2f) is outside the years "
                         "1900..2149, for which sun and moon are known",
                         julian_date_utc);
    }
    return check_observer(observer, err);
}

/* The sky of the observer: east, north and up in the frame of the true equator,
 * and the position of the observer [m from the center of the earth]. */
typedef struct local_sky {
    murk_vec3 east, north, up, place;
    double julian_date_tt;
} local_sky;

static local_sky local_sky_of(const murk_observer *observer,
                              double julian_date_utc)
{
    local_sky out;
    out.julian_date_tt =
        julian_date_utc + murk_delta_t_s(julian_date_utc) / SECONDS_PER_DAY;
    const double turned =
        murk_sidereal_time_rad(julian_date_utc, out.julian_date_tt) +
        observer->longitude_deg / DEG_PER_RAD;
    /* Unit vectors at the latitude and the local sidereal time. */
    const double latitude = observer->latitude_deg / DEG_PER_RAD;
    const double c = cos(latitude), s = sin(latitude);
    out.east = murk_vec(-sin(turned), cos(turned), 0);
    out.north = murk_vec(-s * cos(turned), -s * sin(turned), c);
    out.up = murk_vec(c * cos(turned), c * sin(turned), s);
    /* The position on the ellipsoid. */
    const double flat = (1 - EARTH_FLATTENING) * (1 - EARTH_FLATTENING);
    const double curve = EARTH_RADIUS_M / sqrt(c * c + flat * s * s);
    const double across = (curve + observer->altitude_m) * c;
    out.place = murk_vec(across * cos(turned), across * sin(turned),
                         (flat * curve + observer->altitude_m) * s);
    return out;
}

double murk_standard_pressure_hpa(double altitude_m)
{
    return 1013.25 * pow(1 - 2.25577e-5 * altitude_m, 5.25588);
}

double murk_refraction_deg(double geometric_elevation_deg, double pressure_hpa,
                           double temperature_c)
{
    const double e = geometric_elevation_deg;
    return pressure_hpa / 1010 * 283 / (273 + temperature_c) * 1.02 /
           (60 * tan((e + 10.3 / (e + 5.11)) / DEG_PER_RAD));
}

static murk_body body_at(const local_sky *sky, const murk_observer *observer,
                         murk_vec3 geocentric, double radius_m)
{
    const murk_vec3 seen = murk_sub(geocentric, sky->place);
    /* Direction, then size and refraction. */
    const double east = murk_dot(seen, sky->east);
    const double north = murk_dot(seen, sky->north);
    const double up = murk_dot(seen, sky->up);
    murk_body out = {.distance_m = murk_length(seen), .illuminated = 1};
    out.azimuth_deg = DEG_PER_RAD * atan2(east, north);
    if (out.azimuth_deg < 0) {
        out.azimuth_deg += 360;
    }
    out.diameter_deg = DEG_PER_RAD * 2 * asin(radius_m / out.distance_m);
    out.geometric_elevation_deg = DEG_PER_RAD * atan2(up, hypot(east, north));
    out.elevation_deg = out.geometric_elevation_deg;
    if (out.elevation_deg >= -(out.diameter_deg / 2 + HORIZON_REFRACTION_DEG)) {
        out.elevation_deg += murk_refraction_deg(
            out.geometric_elevation_deg,
            observer->pressure_hpa > 0
                ? observer->pressure_hpa
                : murk_standard_pressure_hpa(observer->altitude_m),
            observer->temperature_c);
    }
    return out;
}

murk_status murk_sun_at(murk_body *out, const murk_observer *observer,
                        double julian_date_utc, murk_error *err)
{
    assert(out && observer);
    const murk_status status = check(observer, julian_date_utc, err);
    if (status) {
        return status;
    }
    const local_sky sky = local_sky_of(observer, julian_date_utc);
    *out = body_at(&sky, observer, murk_geocentric_sun_m(sky.julian_date_tt),
                   SUN_RADIUS_M);
    return MURK_OK;
}

murk_status murk_moon_at(murk_body *out, const murk_observer *observer,
                         double julian_date_utc, murk_error *err)
{
    assert(out && observer);
    const murk_status status = check(observer, julian_date_utc, err);
    if (status) {
        return status;
    }
    const local_sky sky = local_sky_of(observer, julian_date_utc);
    const murk_vec3 moon = murk_geocentric_moon_m(sky.julian_date_tt);
    const murk_vec3 sun = murk_geocentric_sun_m(sky.julian_date_tt);
    *out = body_at(&sky, observer, moon, MOON_RADIUS_M);
    /* Phase from the angle at the moon. */
    const murk_vec3 to_sun = murk_unit(murk_sub(sun, moon));
    const murk_vec3 to_observer = murk_unit(murk_sub(sky.place, moon));
    const double cosine = murk_dot(to_sun, to_observer);
    out->phase_angle_deg =
        DEG_PER_RAD *
        atan2(murk_length(murk_cross(to_sun, to_observer)), cosine);
    out->illuminated = (1 + cosine) / 2;
    return MURK_OK;
}
