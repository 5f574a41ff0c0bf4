/* What a scene's `units` make of a watt in each band, how bands add up, and
 * what is said of bands that count nothing. Nothing is random. */
#include "study/units.h"

#include "base/log.h"
#include "check.h"
#include "light/solar_spectrum.h"

#include <string.h>

static char noted[400];

static void note(const char *where, const char *text)
{
    (void)where;
    snprintf(noted, sizeof noted, "%s", text);
}

static murk_scene lines(murk_quantity quantity)
{
    return (murk_scene){.path = "a.yaml",
                        .bands = 3,
                        .band_nm = {555, 650, 850},
                        .units = quantity};
}

static void test_a_line_is_what_it_is(void)
{
    murk_scene scene = lines(MURK_PHOTOMETRIC);
    const murk_units lux = murk_units_of(&scene);
    CHECK_TEXT(lux.irradiance, "lux");
    CHECK_TEXT(lux.power, "lm");
    CHECK_NEAR(lux.per_watt.band[0], 683, 1e-9);
    CHECK_NEAR(lux.per_watt.band[1], 683 * 0.107, 1e-9);
    CHECK(lux.per_watt.band[2] == 0);
    scene = lines(MURK_PHOTONS);
    CHECK_NEAR(murk_units_of(&scene).per_watt.band[0], 2.793935e18, 5e11);
    scene = lines(MURK_PAR);
    const murk_units par = murk_units_of(&scene);
    CHECK_NEAR(par.per_watt.band[1], 3.272176e18 / 6.02214076e17, 5e-6);
    CHECK(par.per_watt.band[2] == 0);
    scene = lines(MURK_RADIOMETRIC);
    CHECK(murk_units_of(&scene).per_watt.band[2] == 1);
}

/* Between edges light is even in wavelength: half of 600..800 nm is PAR, whose
 * mean wavelength is 650 nm. */
static void test_edges_are_means(void)
{
    const murk_scene scene = {.path = "a.yaml",
                              .bands = 1,
                              .has_edges = true,
                              .band_nm = {700},
                              .band_edge_nm = {600, 800},
                              .units = MURK_PAR};
    CHECK_NEAR(murk_units_of(&scene).per_watt.band[0],
               3.272176e18 / 6.02214076e17 / 2, 5e-6);
}

/* Daylight in one band from 380 to 780 nm: the standard spectrum AM 1.5 of
 * 1000.4 W/m2 is 109495 lux, as others integrate it with V in steps of 10 nm
 * (.2 % for that). Light even in wavelength reads 11 % less. */
static void test_daylight_has_the_suns_shape(void)
{
    murk_scene_light sun = {.type = MURK_SCENE_LIGHT_SUN};
    murk_scene scene = {.path = "a.yaml",
                        .bands = 1,
                        .has_edges = true,
                        .band_nm = {580},
                        .band_edge_nm = {380, 780},
                        .lights = &sun,
                        .n_lights = 1,
                        .units = MURK_PHOTOMETRIC};
    const double w_per_m2 =
        1000.371 * murk_spectrum_share(MURK_SPECTRUM_AM15_GLOBAL, 380, 780);
    const double lux = w_per_m2 * murk_units_of(&scene).per_watt.band[0];
    CHECK_NEAR(lux / 109495.1, 1, 0.002);
    sun.type = MURK_SCENE_LIGHT_POINT;
    const double even = w_per_m2 * murk_units_of(&scene).per_watt.band[0];
    CHECK(even < 0.95 * lux);
}

static void test_errors_go_along(void)
{
    const murk_scene scene = lines(MURK_PHOTOMETRIC);
    const murk_units units = murk_units_of(&scene);
    const murk_estimate one =
        murk_units_convert(&units, 0, (murk_estimate){2, 0.5});
    CHECK_NEAR(one.value, 1366, 1e-9);
    CHECK_NEAR(one.standard_error, 341.5, 1e-9);
    const murk_estimate both[] = {{1, 3}, {2, 4}};
    const murk_estimate sum = murk_units_sum(both, 2);
    CHECK_NEAR(sum.value, 3, 1e-15);
    CHECK_NEAR(sum.standard_error, 5, 1e-15);
}

static void test_dark_bands_are_noted(void)
{
    murk_warn_to(note);
    murk_scene scene = lines(MURK_PHOTOMETRIC);
    murk_units_note(&scene);
    CHECK_TEXT(noted, "units: light of 850 nm counts 0 lux");
    noted[0] = '\0';
    scene = lines(MURK_PHOTONS);
    murk_units_note(&scene);
    CHECK_TEXT(noted, "");
}

int main(void)
{
    test_a_line_is_what_it_is();
    test_edges_are_means();
    test_daylight_has_the_suns_shape();
    test_errors_go_along();
    test_dark_bands_are_noted();
    return check_done();
}
