/* Luminaires, spectra and arrays of lamps in a scene: power per band, places,
 * and refusals. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "base/log.h"
#include "base/photometry.h"
#include "refusals.h"

/* Even below, and dark above: 2 pi cd at 1 cd; the file declares 9 lm. */
#define IES                                                                  \
    "IESNA91\n[LUMCAT] half\nTILT=INCLUDE\n1\n2\n0 90\n1 .5\n1 9 1 2 1 1 2 " \
    ".4 .6 0\n1 1 3\n0 90\n0\n1 1\n"
#define LAMP_AT "{type: luminaire, file: a.ies, position_m: [1, 2, 3]"

static const double HALF = 2 * MURK_PI;

static murk_scene_desc *scene_with(const char *head, const char *lights)
{
    char text[1000];
    murk_scene_desc *scene = NULL;
    murk_error err;
    snprintf(text, sizeof text, HEAD "%slights:\n%s", head, lights);
    scene_of(&scene, text, NULL, 0, &err);
    CHECK_TEXT(err.where, "");
    CHECK_TEXT(err.text, "");
    return scene;
}

static double power(const murk_scene_desc *scene, size_t light)
{
    double sum = 0;
    for (int b = 0; scene && b < scene->bands; ++b) {
        sum += scene->lights[light].power_w.band[b];
    }
    return sum;
}

/* ---- the flux ---- */

static void test_flux(void)
{
    murk_scene_desc *scene =
        scene_with("bands_nm: [450, 650]\n",
                   "  - " LAMP_AT "}\n"
                   "  - " LAMP_AT ", lumens: 100}\n"
                   "  - " LAMP_AT ", power_w: [3, 4]}\n"
                   "  - " LAMP_AT ", aim: [2, 0, 0]}\n"
                   "  - " LAMP_AT ", aim: [1, 0, -1], lumens: 10}\n"
                   "  - " LAMP_AT ", lumens: 0}\n");
    if (scene) {
        /* Without a spectrum 683 lm are a watt, in equal parts. */
        CHECK_NEAR(power(scene, 0), HALF / 683, 1e-15);
        CHECK(scene->lights[0].power_w.band[0] ==
              scene->lights[0].power_w.band[1]);
        CHECK_NEAR(power(scene, 1), 100 / 683., 1e-15);
        CHECK(scene->lights[2].power_w.band[1] == 4);
        /* Level: the TILT data halve the flux of the file, not lumens. */
        CHECK_NEAR(power(scene, 3), HALF / 2 / 683, 1e-15);
        CHECK_NEAR(power(scene, 4), 10 / 683., 1e-15);
        CHECK(power(scene, 5) == 0);
        CHECK(scene->lights[0].luminaire->declared_lumens == 9);
        /* Equal files are read once. */
        CHECK(scene->lights[0].luminaire->intensity ==
              scene->lights[3].luminaire->intensity);
    }
    murk_scene_desc_destroy(scene);
}

/* ---- spectra ---- */

/* Bands over all of the visible have all lumens, with the efficacy of each
 * band. */
static void test_lumens_with_a_spectrum(void)
{
    murk_scene_desc *scene =
        scene_with("band_edges_nm: [380, 500, 600, 780]\n",
                   "  - " LAMP_AT ", lumens: 1000, temperature_k: 3000}\n"
                   "  - " LAMP_AT ", lumens: 1000, spectrum: s.csv}\n");
    for (size_t i = 0; scene && i < 2; ++i) {
        double lumens = 0;
        for (int b = 0; b < scene->bands; ++b) {
            lumens += scene->lights[i].power_w.band[b] *
                      murk_quantity_per_watt_of(
                          MURK_PHOTOMETRIC, scene->band_edge_nm[b],
                          scene->band_edge_nm[b + 1], murk_lamp_spectrum_at,
                          scene->lights[i].spectrum);
        }
        CHECK_NEAR(lumens, 1000, 0.02);
    }
    murk_scene_desc_destroy(scene);
    /* Lines stand for the whole. */
    scene = scene_with("bands_nm: [500, 600]\n",
                       "  - " LAMP_AT ", lumens: 1000, spectrum: s.csv}\n");
    if (scene) {
        const murk_spectrum *w = &scene->lights[0].power_w;
        CHECK_NEAR(w->band[1] / w->band[0], 3, 1e-12);
        CHECK_NEAR(683 * (w->band[0] * murk_luminous_efficiency(500) +
                          w->band[1] * murk_luminous_efficiency(600)),
                   1000, 1e-9);
    }
    murk_scene_desc_destroy(scene);
}

/* A total is shared by the spectrum; a list stays. */
static void test_watts_with_a_spectrum(void)
{
    murk_scene_desc *scene = scene_with(
        "band_edges_nm: [500, 550, 600]\n"
        "domain: {min_m: [0, 0, 0], max_m: [9, 9, 9]}\n",
        "  - {type: point, position_m: [1, 1, 1], power_w: 8, spectrum: "
        "s.csv}\n"
        "  - {type: directional, direction: [0, 0, -1], "
        "irradiance_w_per_m2: 8, spectrum: s.csv}\n"
        "  - {type: point, position_m: [1, 1, 1], power_w: [1, 2], "
        "spectrum: s.csv}\n"
        "  - {type: point, position_m: [1, 1, 1], power_w: 8}\n");
    for (size_t i = 0; scene && i < 2; ++i) {
        /* 1 at 500 nm, 3 at 600 nm: means 1.5 and 2.5 */
        CHECK_NEAR(scene->lights[i].power_w.band[0], 3, 1e-12);
        CHECK_NEAR(scene->lights[i].power_w.band[1], 5, 1e-12);
    }
    CHECK(scene && scene->lights[2].power_w.band[0] == 1);
    CHECK(scene && scene->lights[3].power_w.band[0] == 4);
    murk_scene_desc_destroy(scene);
}

/* ---- arrays ---- */

static void test_arrays(void)
{
    murk_scene_desc *scene = scene_with(
        "", "  - {type: point, position_m: [0, 0, 0], power_w: 7}\n"
            "  - " LAMP_AT ", spectrum: s.csv, array: {count: [2, 3], "
            "step1_m: [10, 0, 0], step2_m: [0, 1, .5]}}\n"
            "  - {type: point, position_m: [5, 5, 5], power_w: 1, array: "
            "{count: [1, 2], step1_m: [0, 0, 0], step2_m: [1, 0, 0]}}\n");
    if (scene) {
        CHECK(scene->n_lights == 9);
        for (size_t k = 0; k < 6; ++k) {
            const murk_scene_light *l = &scene->lights[1 + k];
            CHECK(l->type == MURK_SOURCE_LUMINAIRE && l->item == 1);
            CHECK(l->position.x == 1 + 10. * (double)(k / 3));
            CHECK(l->position.y == 2 + (double)(k % 3));
            CHECK(l->position.z == 3 + .5 * (double)(k % 3));
            CHECK_NEAR(power(scene, 1 + k), power(scene, 1), 0);
        }
        CHECK(scene->lights[7].item == 2 && scene->lights[8].item == 2);
        CHECK(scene->lights[8].position.x == 6 && power(scene, 8) == 1);
        CHECK(scene->lights[0].item == 0 && power(scene, 0) == 7);
    }
    murk_scene_desc_destroy(scene);
}

/* ---- refusals ---- */

static void test_refusals(void)
{
    /* Keys of the light. */
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", c0: [0, 0, 3]}]\n", VALUE,
                  "fog.yaml:2:10: lights.0",
                  "c0 is zero or along the aim, must point aside");
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", power_w: 1, lumens: 2}]\n", VALUE,
                  "fog.yaml:2:10: lights.0",
                  "has power_w and lumens, must have one of them");
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", aim: [0, 0, 0]}]\n", VALUE,
                  "fog.yaml:2:10: lights.0",
                  "aim is [0, 0, 0], must point somewhere");
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", array: {count: [1, 2], step1_m: "
                       "[1, 0, 0]}}]\n",
                  VALUE, "fog.yaml:2:64: lights.0.array",
                  "step2_m is [0, 0, 0], must point somewhere for 2 lamps");
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", array: {count: [100, 3], "
                       "step1_m: [1, 0, 0], step2_m: [0, 1, 0]}}]\n",
                  VALUE, "fog.yaml:2:1: lights",
                  "300 lights with the lamps of arrays and the parts of "
                  "daylight, must be at most 256");
    CHECK_REFUSED(HEAD "bands_nm: [900]\nlights: [" LAMP_AT
                       ", temperature_k: 3000}]\n",
                  VALUE, "fog.yaml:3:10: lights.0",
                  "its spectrum has no visible light at the wavelengths of the "
                  "bands, so lumens give no power: must have power_w");
    CHECK_REFUSED(HEAD "bands_nm: [900]\nlights: [" LAMP_AT
                       ", power_w: 3, spectrum: s.csv}]\n",
                  VALUE, "fog.yaml:3:10: lights.0",
                  "its spectrum has no power in the bands");
    /* Files. */
    write_text("b.ies", "IESNA91\nTILT=NONE\n1 1 1 2 1 1 2 0 0 0\n1 1 1\n0 9 "
                        "8\n");
    CHECK_REFUSED(HEAD "lights: [{type: luminaire, file: b.ies, position_m: "
                       "[0, 0, 0]}]\n",
                  MURK_BAD_FILE, "b.ies:5",
                  "horizontal angles 8..8, must be 0, 0..90, 0..180, 90..270 "
                  "or 0..360");
    write_text("bad.csv", "wavelength_nm,power_per_nm\n500,1\n400,2\n");
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", spectrum: bad.csv}]\n", VALUE,
                  "bad.csv:3",
                  "wavelength_nm is 400, must be 1..1e+07 nm and rise");
    write_text("bad.csv", "nm,power_per_nm\n500,1\n");
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", spectrum: bad.csv}]\n",
                  MURK_BAD_FILE, "bad.csv",
                  "misses column wavelength_nm, must have wavelength_nm and "
                  "power_per_nm");
    write_text("bad.csv", "wavelength_nm,power_per_nm\n500,0\n600,0\n");
    CHECK_REFUSED(HEAD "lights: [" LAMP_AT ", spectrum: bad.csv}]\n",
                  MURK_BAD_FILE, "bad.csv",
                  "0 rows with power, must be 2..100000, and not all 0");
}

int main(void)
{
    static const char *const files[] = {"fog.yaml", "a.ies",   "b.ies",
                                        "s.csv",    "bad.csv", NULL};
    if (!folder_enter()) {
        return 1;
    }
    murk_warn_to(NULL);
    write_text("a.ies", IES);
    write_text("s.csv", "wavelength_nm,power_per_nm\n380,1\n500,1\n600,3\n780,"
                        "3\n");
    test_flux();
    test_lumens_with_a_spectrum();
    test_watts_with_a_spectrum();
    test_arrays();
    test_refusals();
    folder_leave(files);
    return check_done();
}
