/* Daylight in water falls as radiative transfer says, and presets by Jerlov's
 * types as his table says; a beam attenuation mistaken for it would be seen.
 *
 * The checks share a 1e-6 chance of a false alarm (Sidak); the seed is fixed.
 */
#include "base/stats.h"
#include "check.h"
#include "daylight.h"
#include "preset/case_1.h"

#include <math.h>
#include <stdlib.h>

#define CHECKS  8
#define PHOTONS 40000

/* Jerlov's figures are of light from 10 % to 1 % of the surface's; those of the
 * open ocean of light down to 10 %. */
static const double DEEP[2] = {.1, .01}, SHALLOW[2] = {1, .1};

static double limit(void)
{
    return murk_sidak_limit(1e-6, CHECKS);
}

/* Nothing scatters: Kd = a / cosine of the sun below the surface, exactly. */
static murk_estimate absorber(double sun_zenith_deg, uint32_t seed)
{
    const int nm = 500;
    const double about = .1;
    murk_estimate out;
    daylight_attenuation(&out, "extinction_per_m: 0.1, albedo: 0",
                         sun_zenith_deg, DEEP, 1, &nm, &about, 2 * PHOTONS,
                         seed);
    return out;
}

static double below(double sun_zenith_deg, double index)
{
    const double sine = sin(sun_zenith_deg * 3.14159265358979324 / 180) / index;
    return sqrt(1 - sine * sine);
}

static void test_absorption_alone(uint32_t seed)
{
    const murk_estimate k = absorber(60, seed);
    CHECK_WITHIN(limit(), k.value, .1 / below(60, 1.34), k.standard_error);
    /* teeth: no surface at all, or another sun */
    CHECK(sigmas_off(k.value, .1 / below(60, 1), k.standard_error) > limit());
    CHECK(sigmas_off(k.value, .1 / below(30, 1.34), k.standard_error) >
          limit());
}

/* Within 10 % of Jerlov 1976, which is more than Kirk's law is off. */
static void test_types_fall_as_jerlov_says(uint32_t seed)
{
    static const struct {
        const char *water;
        double per_m;
    } type[] = {{"preset: water/jerlov-IA", .026},
                {"preset: water/jerlov-III", .135},
                {"preset: water/jerlov-5C", .56},
                {"preset: water/jerlov-9C", 1.6}};
    const int nm = 450;
    for (size_t i = 0; i < sizeof type / sizeof *type; ++i) {
        murk_estimate k;
        daylight_attenuation(&k, type[i].water, 30, DEEP, 1, &nm,
                             &type[i].per_m, PHOTONS, seed);
        CHECK(fabs(k.value - type[i].per_m) <=
              .1 * type[i].per_m + limit() * k.standard_error);
    }
}

/* Attenuation is within 10 % of the law that is observed in the open ocean,
 * at both ends of the range of the law and between. Teeth: the absorption
 * of particles and dissolved matter alone (water/sea has the same
 * particles) leaves the water too clear from .3 mg/m3 on. */
static void test_case_1_falls_as_observed(uint32_t seed)
{
    /* Water by the preset, at each concentration and wavelength. */
    static const double chlorophyll[] = {.03, .3, 3, 10};
    static const int nm[] = {412, 443, 490, 555};
    for (int i = 0; i < 4; ++i) {
        double about[4];
        char water[100];
        murk_estimate k[4];
        for (int b = 0; b < 4; ++b) {
            about[b] = murk_case_1_kd(nm[b], chlorophyll[i]);
        }
        snprintf(water, sizeof water,
                 "preset: water/case-1, chlorophyll_mg_per_m3: %g",
                 chlorophyll[i]);
        daylight_attenuation(k, water, 30, SHALLOW, 4, nm, about, PHOTONS,
                             seed);
        for (int b = 0; b < 4; ++b) {
            CHECK(fabs(k[b].value - about[b]) <=
                  .1 * about[b] + limit() * k[b].standard_error);
        }
    }
    /* Water with a smaller absorption is clearer than the law by more than
     * the tolerance. */
    const double about = murk_case_1_kd(490, 3);
    murk_estimate clear;
    daylight_attenuation(&clear,
                         "preset: water/sea, chlorophyll_mg_per_m3: 3, "
                         "cdom_per_m: 0.0222",
                         30, SHALLOW, 1, &nm[2], &about, PHOTONS, seed);
    CHECK(clear.value < .9 * about - limit() * clear.standard_error);
}

/* Teeth: Jerlov's figure as beam attenuation leaves far more light. */
static void test_beam_attenuation_is_something_else(uint32_t seed)
{
    const int nm = 450;
    const double per_m = .56, about = .2;
    murk_estimate k;
    daylight_attenuation(&k, "preset: water/jerlov-5C, extinction_per_m: 0.56",
                         30, DEEP, 1, &nm, &about, PHOTONS, seed);
    CHECK(k.value < .9 * per_m - limit() * k.standard_error);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_absorption_alone(seed);
    test_types_fall_as_jerlov_says(seed);
    test_case_1_falls_as_observed(seed);
    test_beam_attenuation_is_something_else(seed);
    return check_done();
}
