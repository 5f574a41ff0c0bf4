/* The laws of presets, called one by one as a preset calls them and compared
 * with figures worked out by hand from the cited sources: spectral exponents
 * and slopes, units, and how scattering and absorption share an extinction.
 * Nothing here is random. */
#include "check.h"
#include "preset/law.h"
#include "preset/rain.h"
#include "preset/refraction.h"
#include "preset/visibility.h"
#include "preset/water_contents.h"
#include "preset/water_kd.h"
#include "preset/water_pure.h"

#include <stdlib.h>

enum { LINES = 4 };

typedef struct answer {
    double absorption[LINES], scattering[LINES];
    murk_preset_phase phase[LINES];
    murk_law_result optics;
} answer;

static const double nm[LINES] = {440, 500, 550, 660};

/* Runs one law at the wavelengths above. */
static answer run_law(const char *name, const murk_words *words,
                      const double *parameter, const murk_preset_table *table)
{
    answer out = {.optics = {0}};
    out.optics = (murk_law_result){.absorption_per_m = out.absorption,
                                   .scattering_per_m = out.scattering,
                                   .phase = out.phase};
    const murk_law *law = murk_law_find(name);
    const murk_law_call call = {.n = LINES,
                                .wavelength_nm = nm,
                                .words = words,
                                .parameter = parameter,
                                .table = table,
                                .where = "media.m"};
    murk_error err = {0};
    CHECK(law && law->run(&out.optics, &call, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    murk_preset_angles_destroy(out.optics.made);
    return out;
}

static murk_words with_word(murk_word_id id, double value)
{
    murk_words words = {{0}, {{0}}};
    words.given[id] = true;
    words.value[id][0] = value;
    return words;
}

static double extinction(const answer *a, int i)
{
    return a->absorption[i] + a->scattering[i];
}

/* ---- visibility ---- */

/* Kruse at 2 km: q = .585 * 2^(1/3) = .737054; Kim at 2 km: q = .16 * 2 + .34 =
 * .66. Both are -ln .02 / 2000 m at 550 nm. Extinction rises towards the blue.
 */
static void test_visibility_laws_by_hand(void)
{
    const murk_words words = with_word(MURK_WORD_VISIBILITY, 2000);
    const double albedo = .9;
    const double at_550 = 3.912023005428146 / 2000;
    const answer kruse = run_law("kruse", &words, &albedo, NULL);
    const answer kim = run_law("kim", &words, &albedo, NULL);
    CHECK_NEAR(extinction(&kruse, 2), at_550, 1e-12);
    CHECK_NEAR(extinction(&kim, 2), at_550, 1e-12);
    CHECK_NEAR(extinction(&kruse, 0) / at_550, pow(550. / 440, .737054), 1e-6);
    CHECK_NEAR(extinction(&kim, 0) / at_550, pow(550. / 440, .66), 1e-12);
    CHECK_NEAR(extinction(&kim, 3) / at_550, pow(550. / 660, .66), 1e-12);
    for (int i = 0; i < LINES; ++i) {
        CHECK_NEAR(kim.scattering[i] / extinction(&kim, i), .9, 1e-12);
        CHECK_NEAR(kruse.scattering[i] / extinction(&kruse, i), .9, 1e-12);
    }
}

/* Both sides of every limit of the two piecewise laws. */
static void test_visibility_exponents_by_range(void)
{
    CHECK_NEAR(murk_visibility_kruse_q(6), .585 * cbrt(6.), 1e-12);
    CHECK_NEAR(murk_visibility_kruse_q(6.001), 1.3, 1e-12);
    CHECK_NEAR(murk_visibility_kruse_q(50), 1.3, 1e-12);
    CHECK_NEAR(murk_visibility_kruse_q(50.001), 1.6, 1e-12);
    CHECK_NEAR(murk_visibility_kim_q(.4), 0, 0);
    CHECK_NEAR(murk_visibility_kim_q(.5), 0, 0);
    CHECK_NEAR(murk_visibility_kim_q(.75), .25, 1e-12);
    CHECK_NEAR(murk_visibility_kim_q(1), .5, 1e-12);
    CHECK_NEAR(murk_visibility_kim_q(6), 1.3, 1e-12);
    CHECK_NEAR(murk_visibility_kim_q(20), 1.3, 1e-12);
    CHECK_NEAR(murk_visibility_kim_q(51), 1.6, 1e-12);
    /* the two contrasts, .02 and .05: 3.912 and 2.996 */
    CHECK_NEAR(murk_visibility_of_mor(1000), 1000 * 3.912023 / 2.995732, 1e-3);
}

/* ---- air ---- */

/* The table of Bodhaine et al. 1999 for 288.15 K and 1013.25 hPa, read through
 * the law, so that pressure, temperature and the step from cm to m count. */
static void test_rayleigh_by_pressure_and_temperature(void)
{
    murk_words words = with_word(MURK_WORD_PRESSURE, 1013.25);
    words.given[MURK_WORD_TEMPERATURE] = true;
    words.value[MURK_WORD_TEMPERATURE][0] = 15;
    const answer a = run_law("rayleigh", &words, NULL, NULL);
    CHECK_NEAR(a.scattering[2], 1.14871e-5, 1e-10);
    CHECK_NEAR(a.scattering[1], 1.69646e-5, 1e-10);
    CHECK(a.absorption[2] == 0);
    words.value[MURK_WORD_PRESSURE][0] = 500;
    words.value[MURK_WORD_TEMPERATURE][0] = -20;
    const answer high = run_law("rayleigh", &words, NULL, NULL);
    CHECK_NEAR(high.scattering[2] / a.scattering[2],
               500 / 1013.25 * 288.15 / 253.15, 1e-9);
}

static void test_angstrom_by_hand(void)
{
    const double p[] = {2e-4, 500, 1.3, .8};
    const murk_words none = {{0}, {{0}}};
    const answer a = run_law("angstrom", &none, p, NULL);
    CHECK_NEAR(extinction(&a, 1), 2e-4, 1e-16);
    CHECK_NEAR(extinction(&a, 3) / 2e-4, pow(500. / 660, 1.3), 1e-12);
    CHECK(extinction(&a, 0) > extinction(&a, 1));
    CHECK_NEAR(a.scattering[3] / extinction(&a, 3), .8, 1e-12);
}

/* ---- rain ---- */

/* Marshall and Palmer at 1 mm/h: slope 4.1 per mm, pi 8000 / 4.1^3 mm2/m3 =
 * 3.64659e-4 1/m. Carbonneau: 1.076 dB/km is 1.076 ln(10) / 10 per km. Each
 * call gives one half of the extinction, and drops absorb in the half of the
 * rays alone. */
static void test_rain_by_hand(void)
{
    murk_words words = with_word(MURK_WORD_RAIN, 1);
    const double carbonneau[2][3] = {{0, 1.076, .67}, {1, 1.076, .67}};
    for (int rays = 0; rays < 2; ++rays) {
        const double is_rays = rays;
        words.value[MURK_WORD_RAIN][0] = 1;
        const answer mp = run_law("marshall_palmer", &words, &is_rays, NULL);
        const answer power =
            run_law("rain_power", &words, carbonneau[rays], NULL);
        CHECK_NEAR(extinction(&mp, 2), 3.64659e-4 / 2, 1e-9);
        CHECK_NEAR(extinction(&power, 2), 1.076 * 2.302585093e-4 / 2, 1e-12);
        words.value[MURK_WORD_RAIN][0] = 10;
        const answer ten = run_law("marshall_palmer", &words, &is_rays, NULL);
        const answer ten_power =
            run_law("rain_power", &words, carbonneau[rays], NULL);
        CHECK_NEAR(extinction(&ten, 2) / extinction(&mp, 2), pow(10, .63),
                   1e-9);
        CHECK_NEAR(extinction(&ten_power, 2) / extinction(&power, 2),
                   pow(10, .67), 1e-9);
        CHECK((ten.absorption[2] > 0) == (rays == 1));
    }
}

/* Where absorption is faint a drop absorbs in proportion to its diameter, so
 * all drops absorb as much as one of the mean diameter by cross section: 3 /
 * slope for sizes D^2 exp(-slope D). */
static void test_rain_absorbs_as_its_mean_drop(void)
{
    const murk_words words = with_word(MURK_WORD_RAIN, 1);
    const double is_rays = 1;
    const answer a = run_law("marshall_palmer", &words, &is_rays, NULL);
    for (int i = 0; i < LINES; ++i) {
        const murk_mie_index index = murk_water_refraction(nm[i]);
        const double per_m = 4 * 3.14159265358979 * index.k / (nm[i] * 1e-9);
        const double one = murk_drop_absorbs(3 / 4.1 * 1e-3, index.n, per_m);
        CHECK_NEAR(a.absorption[i] / extinction(&a, i) / one, 1, 2e-3);
    }
}

/* ---- water ---- */

static void test_what_is_known_in_green_follows_its_powers(void)
{
    const double p[] = {.179, .219, 514, .0105, .7};
    murk_words words = with_word(MURK_WORD_TEMPERATURE, 20);
    const answer a = run_law("in_green", &words, p, NULL);
    const double absorption = .179 - murk_water_absorption(514);
    const double scattering = .219 - murk_water_scattering(514, 20, 0);
    for (int i = 0; i < LINES; ++i) {
        CHECK_NEAR(a.absorption[i] / absorption, exp(-.0105 * (nm[i] - 514)),
                   1e-12);
        CHECK_NEAR(a.scattering[i] / scattering, pow(514 / nm[i], .7), 1e-12);
    }
    /* both fall towards the red */
    CHECK(a.scattering[0] > scattering && a.scattering[3] < scattering);
    CHECK(a.absorption[0] > absorption && a.absorption[3] < absorption);
    /* a beam attenuation scales everything but the water itself */
    words.given[MURK_WORD_BEAM_ATTENUATION] = true;
    words.value[MURK_WORD_BEAM_ATTENUATION][0] = 1;
    const answer dense = run_law("in_green", &words, p, NULL);
    const double water =
        murk_water_absorption(514) + murk_water_scattering(514, 20, 0);
    CHECK_NEAR(dense.scattering[1] / a.scattering[1],
               (1 - water) / (.179 + .219 - water), 1e-12);
}

/* Mineral particles: absorption falls by .0123 per nm from .041 m2/g at 443 nm,
 * scattering as wavelength^-.5 from .5 m2/g at 555 nm. */
static void test_sediment_follows_its_slopes(void)
{
    const murk_words words = with_word(MURK_WORD_SEDIMENT, 3);
    const answer a = run_law("sediment", &words, NULL, NULL);
    for (int i = 0; i < LINES; ++i) {
        CHECK_NEAR(a.absorption[i], .123 * exp(-.0123 * (nm[i] - 443)), 1e-12);
        CHECK_NEAR(a.scattering[i], 1.5 * pow(nm[i] / 555, -.5), 1e-12);
    }
    CHECK(a.scattering[0] > 1.5 && a.scattering[3] < 1.5);
}

static void test_dissolved_matter_follows_its_slopes(void)
{
    const murk_words cdom = with_word(MURK_WORD_CDOM, .4);
    const answer coast = run_law("cdom", &cdom, NULL, NULL);
    for (int i = 0; i < LINES; ++i) {
        CHECK_NEAR(coast.absorption[i], .4 * exp(-.0176 * (nm[i] - 440)),
                   1e-12);
        CHECK(coast.scattering[i] == 0);
    }
}

/* Scattering of particles falls as (nm / 550)^-(.5 (.3 - log10 C)) below 2
 * mg/m3: at .02, log10 = -1.69897, so the power is -.999485. */
static void test_chlorophyll_scatters_more_in_the_blue(void)
{
    const murk_words words = with_word(MURK_WORD_CHLOROPHYLL, .02);
    const answer a = run_law("chlorophyll", &words, NULL, NULL);
    CHECK_NEAR(a.scattering[2], .416 * pow(.02, .766), 1e-12);
    CHECK_NEAR(a.scattering[0] / a.scattering[2], pow(440. / 550, -.999485),
               1e-6);
    CHECK_NEAR(a.scattering[3] / a.scattering[2], pow(660. / 550, -.999485),
               1e-6);
    CHECK(a.phase[0].kind == MURK_PHASE_FOURNIER_FORAND);
}

/* The law inverts Kirk's: with what it gives, and with the water's own, the
 * attenuation of daylight is the table's. */
static void test_attenuation_of_daylight_comes_back(void)
{
    double at[LINES], kd[LINES];
    for (int i = 0; i < LINES; ++i) {
        at[i] = nm[i];
        kd[i] = .6 + .05 * i;
    }
    const murk_preset_table table = {
        .n = LINES, .wavelength_nm = at, .diffuse_attenuation_per_m = kd};
    const double p[] = {.8, 550, 1.2, 30};
    murk_words words = with_word(MURK_WORD_TEMPERATURE, 20);
    const answer a = run_law("diffuse_attenuation", &words, p, &table);
    for (int i = 0; i < LINES; ++i) {
        CHECK_NEAR(a.scattering[i], .8 * pow(550 / nm[i], 1.2), 1e-12);
        /* Kd = sqrt(a^2 + G b a) / m, see preset/water_kd.h. */
        const double whole = a.absorption[i] + murk_water_absorption(nm[i]);
        const double m = murk_water_sun_cosine(30);
        const double gb = (.473 * m - .218) * a.scattering[i] +
                          1.8 * murk_water_scattering(nm[i], 20, 0);
        CHECK_NEAR(sqrt(whole * whole + gb * whole) / m, kd[i], 1e-12);
    }
}

int main(void)
{
    test_visibility_laws_by_hand();
    test_visibility_exponents_by_range();
    test_rayleigh_by_pressure_and_temperature();
    test_angstrom_by_hand();
    test_rain_by_hand();
    test_rain_absorbs_as_its_mean_drop();
    test_what_is_known_in_green_follows_its_powers();
    test_sediment_follows_its_slopes();
    test_dissolved_matter_follows_its_slopes();
    test_chlorophyll_scatters_more_in_the_blue();
    test_attenuation_of_daylight_comes_back();
    return check_done();
}
