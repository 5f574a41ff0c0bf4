/* Light under the sea as a scene's words make it: the canonical problems 1 and
 * 2 of Mobley et al. 1993 with the sun by place and time, through a surface
 * without wind. Reference: adding-doubling, and the mean of seven models with
 * how far they differ (reference/sea.csv).
 *
 * The sun stands within .005 degrees of 30, which makes 1.5e-4 of its light;
 * the balls that Eou is read in make at most 1.5e-3 of it. Both are counted as
 * errors. The z-tests of a run share a 1e-6 chance of a false alarm (Sidak);
 * the seed is fixed. */
#include "check.h"
#include "mobley_sea.h"

#include <math.h>
#include <stdlib.h>

#define PHOTONS 120000
#define CHECKS  24

#define SUN_ERROR  1.5e-4
#define BALL_ERROR 1.5e-3

typedef struct reference {
    mobley_sea sea;
    double ed[MOBLEY_DEPTHS], eou[MOBLEY_DEPTHS]; /* tau 1 and 5 */
    double published_ed[MOBLEY_DEPTHS], differ_ed[MOBLEY_DEPTHS];
    double published_eou[MOBLEY_DEPTHS], differ_eou[MOBLEY_DEPTHS];
} reference;

static const reference WATERS[] = {
    {{1, .9, 1.34, NULL},
     {.365994, .0432891},
     {.372727, .0435371},
     {.366, .0433},
     {.002, .003},
     {.372, .0435},
     {.005, .007}},
    {{2, .9, 1.34, NULL},
     {.413475, .188131},
     {.0921634, .0459439},
     {.413, .187},
     {.001, .005},
     {.0931, .0463},
     {.021, .017}},
    {{1, .2, 1.34, NULL},
     {.141512, .00106573},
     {.0133866, 9.92385e-5},
     {.141, .00107},
     {.001, .005},
     {.0134, 1e-4},
     {.003, .039}},
};

static double limit(void)
{
    return murk_sidak_limit(1e-6, CHECKS);
}

static double off(murk_estimate e, double value, double share)
{
    return sigmas_off(e.value, value, hypot(e.standard_error, share * value));
}

/* The most that any value is off what is computed, in sigmas. */
static double worst_of(const mobley_light *light, const reference *r)
{
    double worst = 0;
    for (int k = 0; k < MOBLEY_DEPTHS; ++k) {
        worst = fmax(worst, off(light->ed[k], r->ed[k], SUN_ERROR));
        worst = fmax(worst, off(light->eou[k], r->eou[k], BALL_ERROR));
    }
    return worst;
}

static void test_light_is_mobleys(uint32_t seed)
{
    for (size_t i = 0; i < sizeof WATERS / sizeof *WATERS; ++i) {
        const reference *r = &WATERS[i];
        const mobley_light light = mobley_sea_lit(&r->sea, PHOTONS, seed);
        CHECK_NEAR(light.sun_deg, 30, .005);
        CHECK(worst_of(&light, r) <= limit());
        for (int k = 0; k < MOBLEY_DEPTHS; ++k) {
            CHECK(off(light.ed[k], r->published_ed[k],
                      hypot(SUN_ERROR, r->differ_ed[k])) <= limit());
            CHECK(off(light.eou[k], r->published_eou[k],
                      hypot(BALL_ERROR, r->differ_eou[k])) <= limit());
        }
    }
}

/* Teeth: water of another index or albedo, and a sun a degree higher. */
static void test_another_sea_is_refused(uint32_t seed)
{
    static const mobley_sea wrong[] = {{1, .9, 1.20, NULL},
                                       {1, .88, 1.34, NULL},
                                       {1, .9, 1.34, "2026-06-21T07:28:20Z"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        const mobley_light light = mobley_sea_lit(&wrong[i], PHOTONS, seed);
        CHECK(worst_of(&light, &WATERS[0]) > limit());
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_light_is_mobleys(seed);
    test_another_sea_is_refused(seed);
    return check_done();
}
