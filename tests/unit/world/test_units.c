/* What `units` make of a watt of each light in each band, how bands add up, and
 * what is said of bands that count nothing. Nothing is random. */
#include "world/units.h"

#include "base/log.h"
#include "check.h"
#include "stage_text.h"

#include <stdio.h>
#include <string.h>

static char noted[400];

static void note(const char *where, const char *text)
{
    (void)where;
    snprintf(noted, sizeof noted, "%s", text);
}

#define SITE                                                     \
    "murk: 1\ndomain: {min_m: [0, 0, 0], max_m: [10, 10, 10]}\n" \
    "site: {latitude_deg: 40, longitude_deg: -105, time: "       \
    "2026-06-21T19:00:00Z}\n"
#define LAMP  "  - {type: point, position_m: [1, 1, 1], power_w: 1}\n"
#define SUN   "  - {type: sun}\n"
#define LIGHT "lights:\n"

static murk_stage *stage_of(const char *rest)
{
    char text[2000];
    snprintf(text, sizeof text, "%s%s", SITE, rest);
    murk_stage *stage = stage_text_create(text, NULL);
    CHECK(stage != NULL);
    return stage;
}

static void test_a_line_is_what_it_is(void)
{
    murk_stage *stage = stage_of("bands_nm: [555, 650, 850]\n" LIGHT LAMP);
    if (!stage) {
        return;
    }
    CHECK_TEXT(murk_units_of(MURK_PHOTOMETRIC).irradiance, "lux");
    CHECK_TEXT(murk_units_of(MURK_PHOTOMETRIC).power, "lm");
    CHECK_NEAR(murk_units_per_watt(MURK_PHOTOMETRIC, stage, 0, 0), 683, 1e-9);
    CHECK_NEAR(murk_units_per_watt(MURK_PHOTOMETRIC, stage, 0, 1), 683 * 0.107,
               1e-9);
    CHECK(murk_units_per_watt(MURK_PHOTOMETRIC, stage, 0, 2) == 0);
    CHECK_NEAR(murk_units_per_watt(MURK_PHOTONS, stage, 0, 0), 2.793935e18,
               5e11);
    CHECK_NEAR(murk_units_per_watt(MURK_PAR, stage, 0, 1),
               3.272176e18 / 6.02214076e17, 5e-6);
    CHECK(murk_units_per_watt(MURK_PAR, stage, 0, 2) == 0);
    CHECK(murk_units_per_watt(MURK_RADIOMETRIC, stage, 0, 2) == 1);
    stage_text_destroy(stage);
}

/* Between edges a lamp is even in wavelength: half of 600..800 nm is PAR, whose
 * mean wavelength is 650 nm. */
static void test_edges_are_means(void)
{
    murk_stage *stage = stage_of("band_edges_nm: [600, 800]\n" LIGHT LAMP);
    if (stage) {
        CHECK_NEAR(murk_units_per_watt(MURK_PAR, stage, 0, 0),
                   3.272176e18 / 6.02214076e17 / 2, 5e-6);
    }
    stage_text_destroy(stage);
}

/* Lux of a light of the stage, and its watts. */
static double lux_of(const murk_stage *stage, size_t light, double *w)
{
    double lux = 0;
    *w = 0;
    for (int b = 0; b < stage->scene->bands; ++b) {
        const double here =
            murk_sources_get(stage->lights, light)->power_w.band[b];
        *w += here;
        lux += here * murk_units_per_watt(MURK_PHOTOMETRIC, stage, light, b);
    }
    return lux;
}

#define ALL_SKY                                                           \
    SUN "  - {type: sky}\n  - {type: night_sky}\n  - {type: sky, cover: " \
        "overcast}\n"

/* One wide band holds the lux that many narrow ones hold, whatever else shines:
 * each light by its own spectrum. Steps are of 1 nm at most and spectra linear
 * over 5 nm and more, which leaves 1e-4. Taken as even, daylight in that band
 * reads 5 % (clear sky) to 12 % less: that is the teeth. */
static void test_a_wide_band_has_the_lights_own_shape(void)
{
    murk_stage *wide =
        stage_of("band_edges_nm: [380, 780]\n" LIGHT ALL_SKY LAMP);
    murk_stage *narrow = stage_of(
        "band_edges_nm: [380, 400, 420, 440, 460, 480, 500, 520, 540, 560, "
        "580, 600, 620, 640, 660, 700, 780]\n" LIGHT ALL_SKY);
    for (size_t i = 0; wide && narrow && i < 4; ++i) {
        double w, w_narrow;
        const double lux = lux_of(wide, i, &w);
        CHECK_NEAR(lux / lux_of(narrow, i, &w_narrow), 1, 1e-4);
        CHECK_NEAR(w / w_narrow, 1, 1e-9);
        const double even = murk_quantity_per_watt(MURK_PHOTOMETRIC, 380, 780);
        CHECK(w * even < .96 * lux);
    }
    if (wide) {
        CHECK_NEAR(murk_units_per_watt(MURK_PHOTOMETRIC, wide, 4, 0) /
                       murk_quantity_per_watt(MURK_PHOTOMETRIC, 380, 780),
                   1, 1e-12);
    }
    stage_text_destroy(narrow);
    stage_text_destroy(wide);
}

static void test_packets_are_worth_their_lights_factor(void)
{
    murk_stage *stage =
        stage_of("band_edges_nm: [400, 550, 700]\n" LIGHT LAMP SUN);
    if (!stage) {
        return;
    }
    const double watts[4] = {1, 2, 3, 4};
    double worth[4];
    murk_units_packets(worth, MURK_PHOTOMETRIC, stage, watts);
    for (size_t c = 0; c < 4; ++c) {
        const double factor =
            murk_units_per_watt(MURK_PHOTOMETRIC, stage, c / 2, (int)(c % 2));
        CHECK_NEAR(worth[c] / watts[c] / factor, 1, 1e-12);
    }
    CHECK(worth[2] / watts[2] != worth[0] / watts[0]);
    stage_text_destroy(stage);
}

static void test_errors_add_up(void)
{
    const murk_estimate both[] = {{1, 3}, {2, 4}};
    const murk_estimate sum = murk_units_sum(both, 2);
    CHECK_NEAR(sum.value, 3, 1e-15);
    CHECK_NEAR(sum.standard_error, 5, 1e-15);
}

static void test_dark_bands_are_noted(void)
{
    murk_scene_desc scene = {.path = "a.yaml",
                             .bands = 3,
                             .band_nm = {555, 650, 850},
                             .units = MURK_PHOTOMETRIC};
    murk_warn_to(note);
    murk_units_note(&scene);
    CHECK_TEXT(noted, "units: light of 850 nm counts 0 lux");
    noted[0] = '\0';
    scene.units = MURK_PHOTONS;
    murk_units_note(&scene);
    CHECK_TEXT(noted, "");
}

/* 8,000 lm in equal parts at 683 lm/W are 2,596 lm in three bands of the
 * visible. Nothing is said of a line near 555 nm, of watts, and of a lamp with
 * a spectrum. */
static void test_lost_lumens_are_warned_of(void)
{
    murk_luminaire lamp = {.verticals = 1};
    murk_lamp_spectrum body = {.temperature_k = 3000};
    murk_scene_light light = {
        .where = "a.yaml:3: lights.0", .luminaire = &lamp, .lumens = 8000};
    murk_scene_desc scene = {.path = "a.yaml",
                             .bands = 3,
                             .has_edges = true,
                             .band_edge_nm = {380, 500, 600, 780},
                             .units = MURK_PHOTOMETRIC,
                             .n_lights = 1,
                             .lights = &light};
    light.power_w = murk_spectrum_flat(8000 / 683. / 3, 3);
    noted[0] = '\0';
    murk_warn_to(note);
    /* With a spectrum, by watts, in watts: no warning. */
    for (int i = 0; i < 3; ++i) {
        light.spectrum = i == 0 ? &body : NULL;
        light.lumens = i == 1 ? 0 : 8000;
        scene.units = i == 2 ? MURK_RADIOMETRIC : MURK_PHOTOMETRIC;
        murk_units_note(&scene);
        CHECK_TEXT(noted, "");
    }
    scene.units = MURK_PHOTOMETRIC;
    murk_units_note(&scene);
    CHECK_MENTIONS(noted, "8000 lm count as 259");
    /* A line near 555 nm. */
    noted[0] = '\0';
    scene = (murk_scene_desc){.bands = 1,
                              .band_nm = {550},
                              .units = MURK_PHOTOMETRIC,
                              .n_lights = 1,
                              .lights = &light};
    light.power_w = murk_spectrum_flat(8000 / 683., 1);
    murk_units_note(&scene);
    CHECK_TEXT(noted, "");
    murk_warn_to(NULL);
}

int main(void)
{
    murk_warn_to(NULL);
    test_a_line_is_what_it_is();
    test_edges_are_means();
    test_a_wide_band_has_the_lights_own_shape();
    test_packets_are_worth_their_lights_factor();
    test_errors_add_up();
    test_dark_bands_are_noted();
    test_lost_lumens_are_warned_of();
    return check_done();
}
