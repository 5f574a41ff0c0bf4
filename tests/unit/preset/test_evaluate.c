/* How parts become a preset's bands: sums of parts, means over bands, words
 * that multiply, scaling to a visibility, and mixtures of phase functions by
 * their share of scattering. The presets are made by hand, so every figure is
 * known. Nothing here is random. */
#include "check.h"
#include "preset/check_words.h"
#include "preset/law.h"
#include "preset/preset.h"

#include <stdlib.h>

/* Straight lines in wavelength, so that a mean over a band is the value at its
 * middle. */
static double at_nm[] = {400, 600};
static double absorbing[] = {.1, .3}, scattering[] = {.4, .2};
static double fine_absorbing[] = {.02, .02}, fine_scattering[] = {.06, .1};

static murk_preset two_parts(void)
{
    static murk_preset_source source = {.what = "all", .from = "this test"};
    murk_preset p = {.name = "test/parts",
                     .source = &source,
                     .sources = 1,
                     .wavelength_nm = {400, 600},
                     .parts = 2};
    for (int i = 0; i < 2; ++i) {
        p.part[i] = (murk_preset_part){
            .times = -1,
            .table = {.n = 2,
                      .wavelength_nm = at_nm,
                      .absorption_per_m = i ? fine_absorbing : absorbing,
                      .scattering_per_m = i ? fine_scattering : scattering},
            .has_phase = true,
            .phase = {.kind = MURK_PHASE_HG, .value = {i ? .2 : .8}}};
    }
    return p;
}

static murk_preset_result evaluated(const murk_preset *p,
                                    const murk_words *words,
                                    const murk_preset_bands *bands)
{
    murk_preset_result result = {0};
    murk_error err = {0};
    CHECK(murk_preset_evaluate(&result, p, words, bands, "media.m", &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return result;
}

/* At 450 nm: absorption .15 + .02, scattering .35 + .07. */
static void test_parts_add_up(void)
{
    const murk_preset p = two_parts();
    const double line[] = {450, 600};
    const murk_preset_bands bands = {.n = 2, .line_nm = line};
    const murk_words none = {{0}, {{0}}};
    murk_preset_result r = evaluated(&p, &none, &bands);
    CHECK_NEAR(r.extinction_per_m.band[0], .59, 1e-12);
    CHECK_NEAR(r.albedo.band[0], .42 / .59, 1e-12);
    CHECK_NEAR(r.extinction_per_m.band[1], .62, 1e-12);
    CHECK(r.mixture[0] && r.mixture[0]->n == 2);
    if (r.mixture[0] && r.mixture[0]->n == 2) {
        CHECK_NEAR(r.mixture[0]->part[0].share, .35 / .42, 1e-12);
        CHECK_NEAR(r.mixture[0]->part[0].value[0], .8, 0);
        CHECK_NEAR(r.mixture[0]->part[1].share, .07 / .42, 1e-12);
        CHECK_NEAR(r.mixture[0]->part[1].value[0], .2, 0);
    }
    murk_preset_result_release(&r);
}

/* The albedo of a band is its scattering over its extinction, not a mean of
 * albedos: 400 to 600 nm has .32 + .08 of .2 + .3 + .02 + .08. */
static void test_a_band_is_a_mean_over_its_wavelengths(void)
{
    const murk_preset p = two_parts();
    const double edge[] = {400, 500, 600};
    const murk_preset_bands bands = {.n = 2, .edge_nm = edge};
    const murk_words none = {{0}, {{0}}};
    murk_preset_result r = evaluated(&p, &none, &bands);
    CHECK_NEAR(r.extinction_per_m.band[0], .15 + .35 + .02 + .07, 1e-12);
    CHECK_NEAR(r.extinction_per_m.band[1], .25 + .25 + .02 + .09, 1e-12);
    CHECK_NEAR(r.albedo.band[1], .34 / .61, 1e-12);
    if (r.mixture[1] && r.mixture[1]->n == 2) {
        CHECK_NEAR(r.mixture[1]->part[0].share, .25 / .34, 1e-12);
    }
    murk_preset_result_release(&r);
}

static void know(murk_preset *p, murk_word_id id, double otherwise)
{
    p->word[id] = (murk_preset_word){.is_known = true,
                                     .has_preset = true,
                                     .preset = {otherwise},
                                     .min = {.01},
                                     .max = {1e6}};
}

static void test_a_word_multiplies_its_part_alone(void)
{
    murk_preset p = two_parts();
    p.part[1].times = MURK_WORD_SOOT;
    know(&p, MURK_WORD_SOOT, 2);
    const double line = 450;
    const murk_preset_bands bands = {.n = 1, .line_nm = &line};
    murk_words words = {{0}, {{0}}};
    murk_preset_result r = evaluated(&p, &words, &bands);
    CHECK_NEAR(r.extinction_per_m.band[0], .5 + 2 * .09, 1e-12);
    murk_preset_result_release(&r);
    words.given[MURK_WORD_SOOT] = true;
    words.value[MURK_WORD_SOOT][0] = 5;
    r = evaluated(&p, &words, &bands);
    CHECK_NEAR(r.extinction_per_m.band[0], .5 + 5 * .09, 1e-12);
    CHECK_NEAR(r.albedo.band[0], (.35 + 5 * .07) / .95, 1e-12);
    murk_preset_result_release(&r);
}

/* The scaled part makes up at 550 nm what the other leaves of -ln .02 / 5 m:
 * there the first part has .5, and the second .02 + .09. At 450 nm the factor
 * is the same. */
static void test_scaled_parts_make_up_the_visibility(void)
{
    murk_preset p = two_parts();
    p.part[1].scaled = true;
    know(&p, MURK_WORD_VISIBILITY, 5);
    const double line[] = {550, 450};
    const murk_preset_bands bands = {.n = 2, .line_nm = line};
    murk_words words = {{0}, {{0}}};
    murk_preset_result r = evaluated(&p, &words, &bands);
    const double whole = 3.912023005428146 / 5, factor = (whole - .5) / .11;
    CHECK_NEAR(r.extinction_per_m.band[0], whole, 1e-12);
    CHECK_NEAR(r.extinction_per_m.band[1], .5 + factor * .09, 1e-12);
    CHECK_NEAR(r.albedo.band[1], (.35 + factor * .07) / (.5 + factor * .09),
               1e-12);
    murk_preset_result_release(&r);
    /* a visibility that the other part alone falls short of is refused */
    words.given[MURK_WORD_VISIBILITY] = true;
    words.value[MURK_WORD_VISIBILITY][0] = 8;
    murk_error err = {0};
    CHECK(murk_preset_evaluate(&r, &p, &words, &bands, "media.m", &err) ==
          MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "must be at most 7.82405 m");
}

/* The range of mor_m is that of visibility_m, at its own contrast: 1 m of
 * meteorological range are 3.912023 / 2.995732 = 1.305866 m of visibility. */
static void test_mor_has_the_range_of_visibility(void)
{
    murk_preset p = two_parts();
    know(&p, MURK_WORD_VISIBILITY, 100);
    const double factor = 3.912023005428146 / 2.995732273553991;
    const double mor[] = {.011 / factor, .99e6 / factor, .0099 / factor,
                          1.01e6 / factor};
    for (int i = 0; i < 4; ++i) {
        const murk_status status =
            murk_preset_check_word(&p, MURK_WORD_MOR, &mor[i], "media.m", NULL);
        CHECK(status == (i < 2 ? MURK_OK : MURK_BAD_VALUE));
    }
    murk_words words = {{0}, {{0}}};
    words.given[MURK_WORD_MOR] = true;
    words.value[MURK_WORD_MOR][0] = 50;
    CHECK(murk_preset_complete(&words, &p, "media.m", NULL) == MURK_OK);
    CHECK_NEAR(words.value[MURK_WORD_VISIBILITY][0], 50 * factor, 1e-9);
}

/* A quarter of the way from 400 to 600 nm, the columns have shares of 3 to
 * 1. */
static void test_phase_columns_are_shared_by_wavelength(void)
{
    /* A preset whose phase function is a table with two columns. */
    murk_preset p = two_parts();
    murk_preset_angles *angles = NULL;
    CHECK(!murk_preset_angles_create(&angles, 3, 2, true, NULL));
    if (!angles) {
        return;
    }
    angles->wavelength_nm[0] = 400;
    angles->wavelength_nm[1] = 600;
    for (int i = 0; i < 3; ++i) {
        angles->angle_deg[i] = 90. * i;
        angles->phase_per_sr[i] = 1;
        angles->phase_per_sr[3 + i] = 2;
    }
    /* Evaluate one part at 450 nm. */
    p.parts = 1;
    p.part[0].angles = angles;
    p.part[0].phase.kind = MURK_PHASE_TABLE;
    const double line = 450;
    const murk_preset_bands bands = {.n = 1, .line_nm = &line};
    const murk_words none = {{0}, {{0}}};
    murk_preset_result r = evaluated(&p, &none, &bands);
    /* The mixture has both columns. */
    CHECK(r.mixture[0] && r.mixture[0]->n == 2);
    if (r.mixture[0] && r.mixture[0]->n == 2) {
        CHECK_NEAR(r.mixture[0]->part[0].share, .75, 1e-12);
        CHECK_NEAR(r.mixture[0]->part[0].phase_per_sr[0], 1, 0);
        CHECK_NEAR(r.mixture[0]->part[1].phase_per_sr[0], 2, 0);
    }
    murk_preset_result_release(&r);
    murk_preset_angles_destroy(angles);
}

static void test_bands_outside_are_refused(void)
{
    const murk_preset p = two_parts();
    const double line[] = {400, 600}, beyond[] = {399.9, 600.1};
    const murk_words none = {{0}, {{0}}};
    for (int i = 0; i < 2; ++i) {
        const murk_preset_bands in = {.n = 1, .line_nm = &line[i]};
        const murk_preset_bands out = {.n = 1, .line_nm = &beyond[i]};
        murk_preset_result r = evaluated(&p, &none, &in);
        murk_preset_result_release(&r);
        murk_error err = {0};
        CHECK(murk_preset_evaluate(&r, &p, &none, &out, "media.m", &err) ==
              MURK_BAD_VALUE);
        CHECK_MENTIONS(err.text, "must be within 400..600 nm");
    }
}

int main(void)
{
    test_parts_add_up();
    test_a_band_is_a_mean_over_its_wavelengths();
    test_a_word_multiplies_its_part_alone();
    test_scaled_parts_make_up_the_visibility();
    test_mor_has_the_range_of_visibility();
    test_phase_columns_are_shared_by_wavelength();
    test_bands_outside_are_refused();
    return check_done();
}
