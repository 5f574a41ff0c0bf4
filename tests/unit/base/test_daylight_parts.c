/* Parts of daylight: the patches cover the upper half once; the shares of the
 * places of the sun give the irradiance of planes exactly; at every latitude
 * parts are few enough for the lights of a scene. */
#include "base/daylight_parts.h"
#include "base/rng.h"
#include "check.h"

#define RAD (MURK_PI / 180)

static void test_patches(void)
{
    double solid = 0;
    for (size_t p = 0; p < MURK_SKY_PATCHES; ++p) {
        const murk_patch_bounds b = murk_sky_patch_bounds(p);
        CHECK(b.low_rad >= 0 && b.high_rad > b.low_rad &&
              b.to_rad > b.from_rad);
        solid += (sin(b.high_rad) - sin(b.low_rad)) * (b.to_rad - b.from_rad);
    }
    CHECK_NEAR(solid, 2 * MURK_PI, 1e-12);
    /* Directions on a lattice that meets no edge belong to one patch each. */
    int places = 0;
    for (double up = .013; up < 1.57; up += .0317) {
        for (double around = .0071; around < 6.28; around += .0531) {
            int n = 0;
            for (size_t p = 0; p < MURK_SKY_PATCHES; ++p) {
                const murk_patch_bounds b = murk_sky_patch_bounds(p);
                const double turn = 2 * MURK_PI;
                const double own =
                    around - turn * floor((around - b.from_rad) / turn);
                n += up >= b.low_rad && up < b.high_rad && own < b.to_rad;
            }
            places += n == 1;
            CHECK(n == 1);
        }
    }
    CHECK(places > 5000);
    /* The first patch lies about north, at the horizon; the last is the cap. */
    CHECK_NEAR(murk_sky_patch_bounds(0).from_rad, -6 * RAD, 1e-12);
    CHECK_NEAR(murk_sky_patch_bounds(144).low_rad, 84 * RAD, 1e-12);
}

static murk_vec3 sum_of(const murk_sun_places *places, const double *share,
                        int *n)
{
    murk_vec3 sum = {0, 0, 0};
    *n = 0;
    for (size_t k = 0; k < places->n; ++k) {
        CHECK(share[k] >= 0 && share[k] < 1.02);
        sum = murk_along(sum, share[k], places->towards[k]);
        *n += share[k] > 0;
    }
    return sum;
}

/* The sun at a declination and hour angle, as textbooks have it. */
static murk_vec3 sun_at(double latitude, double declination, double hour)
{
    const double z = sin(latitude) * sin(declination) +
                     cos(latitude) * cos(declination) * cos(hour);
    const double east = -cos(declination) * sin(hour);
    const double north = (sin(declination) - z * sin(latitude)) / cos(latitude);
    return murk_vec(east, north, z);
}

static void test_shares(void)
{
    int all = 0, low = 0, gaps = 0;
    /* Suns at all latitudes, days and hours. */
    for (int i = 0; i < 20000; ++i) {
        const murk_random4 r = murk_random(7, MURK_TEST, (uint64_t)i, 0, 0);
        const double latitude_deg = -80 + 160 * r.u[0];
        const double declination = 23.44 * RAD * (2 * r.u[1] - 1);
        const double hour = MURK_PI * (2 * r.u[2] - 1);
        const murk_vec3 sun = sun_at(latitude_deg * RAD, declination, hour);
        double share[MURK_SUN_PLACES_MAX];
        murk_sun_places places;
        int n;
        if (!(sun.z > .006)) {
            continue;
        }
        murk_sun_places_make(&places, latitude_deg);
        murk_sun_places_share(&places, sun, share);
        const murk_vec3 sum = sum_of(&places, share, &n);
        CHECK(n >= 1 && n <= 3);
        const double off = murk_length(murk_sub(sum, sun));
        CHECK_NEAR(off, 0, sun.z > sin(1 * RAD) ? 1e-9 : .12);
        gaps += off > 1e-9;
        low += sun.z < sin(6 * RAD);
        ++all;
    }
    CHECK(all > 8000 && low > 500 && gaps < all / 2000);
}

/* A sun lower than all places. */
static void test_horizon(void)
{
    const double latitude = 45 * RAD;
    for (double hour = -2; hour <= 2; hour += .013) {
        double share[MURK_SUN_PLACES_MAX];
        murk_sun_places places;
        int n;
        /* The declination at which the sun is at the horizon at that hour. */
        const double declination = atan(-cos(hour) / tan(latitude));
        const murk_vec3 sun = sun_at(latitude, declination + 1e-4, hour);
        if (fabs(declination) < 23.4 * RAD) {
            CHECK(sun.z > 0 && sun.z < .001);
            murk_sun_places_make(&places, 45);
            murk_sun_places_share(&places, sun, share);
            const murk_vec3 sum = sum_of(&places, share, &n);
            CHECK_NEAR(murk_length(murk_sub(sum, sun)), 0, .12);
        }
    }
}

static void test_counts(void)
{
    for (double latitude = -90; latitude <= 90; latitude += .5) {
        murk_sun_places places;
        murk_sun_places_make(&places, latitude);
        CHECK(places.n >= 60 && places.n <= 104);
    }
}

int main(void)
{
    test_patches();
    test_shares();
    test_horizon();
    test_counts();
    return check_done();
}
