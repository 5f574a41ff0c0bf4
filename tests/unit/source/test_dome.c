/* The sky's light: the law, what enters a domain, from where.
 *
 * The law is held against values that others print; directions against its own
 * quadrature, for each of the fifteen types, by Pearson's chi-square over zones
 * of the hemisphere made normal by Wilson and Hilferty (1931). All z-tests of a
 * run share a 1e-6 chance of a false alarm (Sidak); the seed is fixed, so the
 * verdict repeats. */
#include "base/stats.h"
#include "check.h"
#include "source/sources.h"

#include <stdlib.h>

#define SAMPLES UINT64_C(40000)
#define Z_TESTS 64

/* Zones: equal in sin^2 of the zenith angle, and in azimuth; points of the
 * midpoint rule along each of them. */
#define RINGS   8
#define SECTORS 8
#define ZONES   (RINGS * SECTORS)
#define POINTS  12

static const murk_domain hall = {{{-2, -1, 0}, {4, 3, 5}}, false};
static const murk_domain slab = {{{-2, -1, 0}, {4, 3, 5}}, true};
static const double face_m2[3] = {20, 30, 24}; /* across x, y, z */

/* 35 degrees up, between the axes. */
static murk_vec3 sun(void)
{
    const double up = 35 * MURK_PI / 180, around = 0.7;
    return murk_vec(cos(up) * cos(around), cos(up) * sin(around), sin(up));
}

static murk_source sky_of(int type)
{
    return (murk_source){.type = MURK_SOURCE_SKY,
                         .dome = murk_dome_cie(type, sun()),
                         .power_w = {{100}},
                         .where = "a.yaml:3:5: lights.0"};
}

static murk_sources *made(const murk_source *light, const murk_domain *domain)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, light, 1, 1, domain, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return lights;
}

/* ---- the law ---- */

/* Gradation: 1 + 4 exp(-.7) of the overcast sky, which is three times brighter
 * at the zenith than at the horizon as Moon and Spencer (1942) had it, to .5 %.
 * Indicatrix: 3.3264628 at 30 degrees for type 12 is what the program colour
 * 0.4.7 prints. */
static void test_law_is_the_standard_s(void)
{
    const murk_vec3 up = {0, 0, 1}, level = {1, 0, 0};
    const murk_dome overcast = murk_dome_cie(1, up);
    CHECK_NEAR(murk_dome_radiance(&overcast, up), 1 + 4 * exp(-0.7), 1e-14);
    CHECK_NEAR(murk_dome_radiance(&overcast, up) / 3, 1, 0.005);
    CHECK_NEAR(murk_dome_radiance(&overcast, level), 1, 1e-14);
    CHECK(murk_dome_radiance(&overcast, murk_vec(0.6, 0, -0.8)) == 0);

    murk_dome clear = murk_dome_cie(12, level);
    const murk_vec3 at = {cos(MURK_PI / 6), 0, sin(MURK_PI / 6)};
    const double gradation = 1 - exp(-0.32 / 0.5);
    CHECK_NEAR(murk_dome_radiance(&clear, at) / gradation, 3.3264628, 1e-7);
    clear.c = 10.1;
    CHECK(fabs(murk_dome_radiance(&clear, at) / gradation - 3.3264628) > 1e-3);

    const murk_dome zero = {0}, even = murk_dome_cie(5, level);
    CHECK(murk_dome_radiance(&zero, at) == 1);
    CHECK(murk_dome_radiance(&even, at) == 1);
}

/* ---- quadrature ---- */

/* Integral over one zone of radiance times weight(direction), by midpoints. */
static double over_zone(const murk_dome *dome, int ring, int sector,
                        double (*weight)(murk_vec3 towards))
{
    const double from = asin(sqrt((double)ring / RINGS));
    const double to = asin(sqrt((double)(ring + 1) / RINGS));
    double sum = 0;
    for (int i = 0; i < POINTS; ++i) {
        const double zenith = from + (i + 0.5) / POINTS * (to - from);
        for (int j = 0; j < POINTS; ++j) {
            const double phi =
                2 * MURK_PI * (sector + (j + 0.5) / POINTS) / SECTORS;
            const murk_vec3 d = {sin(zenith) * cos(phi), sin(zenith) * sin(phi),
                                 cos(zenith)};
            sum += murk_dome_radiance(dome, d) * weight(d) * sin(zenith);
        }
    }
    return sum * (to - from) / POINTS * 2 * MURK_PI / (SECTORS * POINTS);
}

static double onto_top(murk_vec3 d)
{
    return face_m2[2] * d.z;
}

static double onto_box(murk_vec3 d)
{
    return face_m2[0] * fabs(d.x) + face_m2[1] * fabs(d.y) + face_m2[2] * d.z;
}

static double onto_east(murk_vec3 d) /* the face that looks east */
{
    return face_m2[0] * fmax(0, d.x);
}

static double over_sky(const murk_dome *dome, double (*weight)(murk_vec3))
{
    double sum = 0;
    for (int z = 0; z < ZONES; ++z) {
        sum += over_zone(dome, z / SECTORS, z % SECTORS, weight);
    }
    return sum;
}

/* ---- what enters ---- */

static int zone_of(murk_vec3 d)
{
    const double v = d.x * d.x + d.y * d.y;
    const double turn = atan2(d.y, d.x) / (2 * MURK_PI);
    const int ring = (int)fmin(RINGS - 1, v * RINGS);
    const int sector = (int)((turn < 0 ? turn + 1 : turn) * SECTORS);
    return ring * SECTORS + (sector < SECTORS ? sector : SECTORS - 1);
}

/* Sigmas by which photons differ from radiance times weight over the zones. */
static double misfit(const murk_source *light, const murk_domain *domain,
                     const murk_dome *law, double (*weight)(murk_vec3),
                     uint32_t seed)
{
    murk_sources *lights = made(light, domain);
    double count[ZONES] = {0};
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        ++count[zone_of(murk_scale(-1, ray.direction))];
    }
    murk_sources_destroy(lights);
    const double all = over_sky(law, weight);
    double chi2 = 0;
    for (int z = 0; z < ZONES; ++z) {
        const double want = (double)SAMPLES / all *
                            over_zone(law, z / SECTORS, z % SECTORS, weight);
        chi2 += (count[z] - want) * (count[z] - want) / want;
    }
    const double free = ZONES - 1, spread = 2 / (9 * free);
    return (cbrt(chi2 / free) - (1 - spread)) / sqrt(spread);
}

static void test_directions_follow_every_type(uint32_t seed)
{
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    murk_source light;
    for (int type = 1; type <= MURK_DOME_TYPES; ++type) {
        light = sky_of(type);
        CHECK(misfit(&light, &slab, &light.dome, onto_top, seed) < limit);
        CHECK(misfit(&light, &hall, &light.dome, onto_box, seed) < limit);
    }
    /* Teeth: a corona a quarter narrower, another gradation. */
    murk_dome wrong = light.dome;
    wrong.d *= 1.25;
    CHECK(misfit(&light, &slab, &wrong, onto_top, seed) > 2 * limit);
    light = sky_of(3);
    wrong = light.dome;
    wrong.a *= 2;
    CHECK(misfit(&light, &hall, &wrong, onto_box, seed) > limit);
}

/* Power is E A in a periodic domain; of an open one all faces that the sky
 * sees take theirs: half of E on upright ones under an even sky, what
 * quadrature says under others. The tables are right to a few 1e-4. */
static void test_power_is_by_projected_area(void)
{
    const murk_source even = sky_of(5);
    murk_sources *lights = made(&even, &slab);
    CHECK_NEAR(murk_sources_power_w(lights), 2400, 1e-9);
    murk_sources_destroy(lights);
    lights = made(&even, &hall);
    CHECK_NEAR(murk_sources_power_w(lights), 100 * (24 + 20 + 30), 1e-9);
    murk_sources_destroy(lights);
    for (int type = 1; type <= MURK_DOME_TYPES; ++type) {
        const murk_source light = sky_of(type);
        lights = made(&light, &hall);
        const double want = 100 * 24 * over_sky(&light.dome, onto_box) /
                            over_sky(&light.dome, onto_top);
        CHECK_NEAR(murk_sources_power_w(lights) / want, 1, 4e-4);
        murk_sources_destroy(lights);
        lights = made(&light, &slab);
        CHECK_NEAR(murk_sources_power_w(lights), 2400, 1e-9);
        murk_sources_destroy(lights);
    }
}

/* Photons start on the face through which they fly in, and each face has a
 * share of them: here of the face at the largest x. */
static void test_photons_enter_through_their_face(uint32_t seed)
{
    /* A sky over an open domain. */
    const murk_source light = sky_of(13);
    murk_sources *lights = made(&light, &hall);
    double east = 0;
    bool on_face = true, downward = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        /* Each photon starts on a side or the top, inwards and not upwards. */
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        const murk_vec3 p = ray.origin, d = ray.direction;
        on_face = on_face && murk_box_contains(&hall.box, p) &&
                  ((p.x == -2 && d.x > 0) || (p.x == 4 && d.x < 0) ||
                   (p.y == -1 && d.y > 0) || (p.y == 3 && d.y < 0) ||
                   (p.z == 5 && d.z < 0));
        downward = downward && d.z <= 0 && !ray.is_spent &&
                   fabs(murk_length(d) - 1) < 1e-14;
        east += p.x == 4;
    }
    CHECK(on_face);
    CHECK(downward);
    /* The share of the face by quadrature over the sky; a share that is 10
     * % larger is refused. */
    const double part =
        over_sky(&light.dome, onto_east) / over_sky(&light.dome, onto_box);
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    const double sigma = sqrt(part * (1 - part) / (double)SAMPLES);
    CHECK_WITHIN(limit, east / (double)SAMPLES, part, sigma);
    CHECK(sigmas_off(east / (double)SAMPLES, 1.1 * part, sigma) > limit);
    murk_sources_destroy(lights);
}

static void refused(const murk_source *light, const char *part)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, light, 1, 1, &hall, &err) ==
          MURK_BAD_VALUE);
    CHECK(lights == NULL);
    CHECK_TEXT(err.where, light->where);
    CHECK_MENTIONS(err.text, part);
}

static void test_bad_skies_are_named(void)
{
    murk_source light = sky_of(12);
    light.dome.b = NAN;
    refused(&light, "coefficient b of the sky is nan, must be finite");
    light = sky_of(12);
    light.dome.towards = murk_vec(0, 0, 0);
    refused(&light, "towards is [0, 0, 0], must be finite and not zero");
    light.dome.towards = murk_vec(0, INFINITY, 0);
    refused(&light, "must be finite and not zero");
    light = sky_of(12);
    light.dome.c = -50;
    refused(&light, "relative radiance of the sky is -");
    light = sky_of(1);
    light.power_w.band[0] = -1;
    refused(&light, "irradiance_w_per_m2 is -1 W/m2 in band 0");
    light = sky_of(1);
    light.dome.a = -1;
    light.dome.b = 800;
    refused(&light, "must be 0 or more");
}

/* A sun under the horizon brightens its side of the sky all the same. */
static void test_sun_may_be_below(void)
{
    murk_source light = sky_of(12);
    light.dome.towards = murk_vec(9, 0, -1); /* need not be unit */
    murk_sources *lights = made(&light, &hall);
    murk_dome unit = light.dome;
    unit.towards = murk_unit(unit.towards);
    const double want =
        100 * 24 * over_sky(&unit, onto_box) / over_sky(&unit, onto_top);
    CHECK_NEAR(murk_sources_power_w(lights) / want, 1, 4e-4);
    murk_vec3 place;
    CHECK(!murk_sources_place(lights, 0, &place));
    murk_sources_destroy(lights);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_law_is_the_standard_s();
    test_directions_follow_every_type(seed);
    test_power_is_by_projected_area();
    test_photons_enter_through_their_face(seed);
    test_bad_skies_are_named();
    test_sun_may_be_below();
    return check_done();
}
