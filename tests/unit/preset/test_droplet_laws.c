/* The laws of water droplets: number and mass concentrations, interpolation
 * over wavelength, and the inputs that are refused. */
#include "check.h"
#include "preset/check_words.h"
#include "preset/droplets.h"
#include "preset/law.h"
#include "preset/refraction.h"

#include <stdlib.h>

enum { MANY = 60 };

typedef struct answer {
    double absorption[MANY], scattering[MANY];
    murk_preset_phase phase[MANY];
    murk_law_result optics;
} answer;

static murk_words words_of(double per_cm3, double a, double b, double c)
{
    murk_words words = {0};
    words.given[MURK_WORD_DROPLETS] = words.given[MURK_WORD_DROPLET_SHAPE] =
        true;
    words.value[MURK_WORD_DROPLETS][0] = per_cm3;
    words.value[MURK_WORD_DROPLET_SHAPE][0] = a;
    words.value[MURK_WORD_DROPLET_SHAPE][1] = b;
    words.value[MURK_WORD_DROPLET_SHAPE][2] = c;
    return words;
}

static murk_status run(answer *out, size_t n, const double *nm,
                       const murk_words *words, murk_error *err)
{
    *out = (answer){0};
    out->optics = (murk_law_result){.absorption_per_m = out->absorption,
                                    .scattering_per_m = out->scattering,
                                    .phase = out->phase};
    const murk_law_call call = {
        .n = n, .wavelength_nm = nm, .words = words, .where = "media.fog"};
    return murk_law_find("droplets")->run(&out->optics, &call, err);
}

static void test_amounts(void)
{
    const double nm = 850;
    const murk_droplets shape = {6, 3, 1};
    murk_words words = words_of(200, 6, 3, 1);
    answer by_number, by_water;
    CHECK(run(&by_number, 1, &nm, &words, NULL) == MURK_OK);
    words.given[MURK_WORD_LIQUID_WATER] = true;
    words.value[MURK_WORD_LIQUID_WATER][0] =
        100 * murk_droplets_water_g_per_m3(&shape);
    CHECK(run(&by_water, 1, &nm, &words, NULL) == MURK_OK);
    CHECK_NEAR(by_number.scattering[0] / by_water.scattering[0], 2, 1e-12);
    CHECK_NEAR(by_number.absorption[0] / by_water.absorption[0], 2, 1e-12);
    murk_preset_angles_destroy(by_number.optics.made);
    murk_preset_angles_destroy(by_water.optics.made);
}

/* Wavelengths close together, out of order and repeated, are those asked for
 * one by one, to less than half a percent; in water's band at 1.4 um, too,
 * where absorption rises fourfold within 40 nm. */
static void test_between_wavelengths(void)
{
    const murk_words words = words_of(200, 6, 3, 1);
    double nm[MANY];
    for (int i = 0; i < MANY; ++i) {
        nm[i] = i % 2 ? 500 + 2 * i : 1500 - 3 * i;
    }
    nm[7] = nm[MANY - 1] = 550;
    answer all, one;
    CHECK(run(&all, MANY, nm, &words, NULL) == MURK_OK);
    CHECK(all.optics.has_phase && all.optics.made->columns == MANY);
    for (int i = 0; i < MANY; i += 7) {
        CHECK(run(&one, 1, &nm[i], &words, NULL) == MURK_OK);
        CHECK_NEAR(all.scattering[i] / one.scattering[0], 1, 5e-3);
        CHECK_NEAR(all.absorption[i] / one.absorption[0], 1, 5e-2);
        CHECK_NEAR(all.absorption[i] / all.scattering[i],
                   one.absorption[0] / one.scattering[0], 5e-5);
        CHECK(all.phase[i].kind == MURK_PHASE_TABLE &&
              all.phase[i].column == (size_t)i);
        murk_preset_angles_destroy(one.optics.made);
    }
    CHECK(all.scattering[7] == all.scattering[MANY - 1]);
    murk_preset_angles_destroy(all.optics.made);
}

static void test_refusals(void)
{
    const double nm = 550;
    answer none;
    murk_error err = {0};
    const murk_words large = words_of(1, 0, .01, 1);
    CHECK(run(&none, 1, &nm, &large, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "media.fog");
    CHECK_MENTIONS(err.text, "effective radius of 300, must be 0.05..50 um");

    murk_preset preset = {.name = "fog/droplets"};
    preset.word[MURK_WORD_DROPLETS].is_known = true;
    preset.word[MURK_WORD_DROPLETS].max[0] = 1e6;
    preset.word[MURK_WORD_VISIBILITY].is_known = true;
    preset.word[MURK_WORD_VISIBILITY].max[0] = 1e6;
    murk_words both = words_of(1, 6, 3, 1);
    both.given[MURK_WORD_DROPLET_SHAPE] = false;
    both.given[MURK_WORD_VISIBILITY] = true;
    both.value[MURK_WORD_VISIBILITY][0] = 100;
    err = (murk_error){0};
    CHECK(murk_preset_complete(&both, &preset, "media.fog", &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.text, "has visibility_m and droplets_per_cm3, must have one "
                         "of them");
}

int main(void)
{
    test_amounts();
    test_between_wavelengths();
    test_refusals();
    return check_done();
}
