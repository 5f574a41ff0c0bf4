/* What the domain's media take of distant light, where it can be worked out by
 * hand. Deterministic: no false alarms. */
#include "check.h"
#include "stage_text.h"
#include "world/daylight_loss.h"

#define DOWN_60 "direction: [0, 0.8660254037844386, -0.5]"

static murk_daylight_loss of(const char *yaml, size_t light)
{
    murk_daylight_loss out = {.is_known = false};
    murk_stage *stage = stage_text_create(yaml, NULL);
    CHECK(stage != NULL);
    if (stage) {
        out = murk_daylight_loss_of(stage, light);
        stage_text_destroy(stage);
    }
    return out;
}

/* 10 m of .05/m at 60 degrees from the zenith: depth 1. */
static void test_a_slab(void)
{
    const murk_daylight_loss t =
        of("murk: 1\nbands_nm: [532, 650]\n"
           "domain: {min_m: [0, 0, 0], max_m: [3, 4, 10], sides: periodic}\n"
           "media: {fog: {extinction_per_m: [0.05, 0.1], albedo: 0.9}}\n"
           "regions: [{medium: fog}]\n"
           "lights: [{type: directional, " DOWN_60
           ", irradiance_w_per_m2: [3, 1]}]\n",
           0);
    CHECK(t.is_known);
    CHECK_NEAR(t.optical_depth.band[0], 1, 1e-9);
    CHECK_NEAR(t.optical_depth.band[1], 2, 1e-9);
    CHECK_NEAR(t.transmittance.band[0], exp(-1), 1e-9);
    CHECK_NEAR(t.share, 1 - (3 * exp(-1) + exp(-2)) / 4, 1e-9);
}

/* An open domain is entered through its side, too: a ray to a floor place at a
 * distance y from the lit side has min(20, 2 y / sqrt 3) m. Teeth: it is not
 * the slab's. */
static void test_an_open_box(void)
{
    const murk_daylight_loss t = of(
        "murk: 1\nbands_nm: [532]\n"
        "domain: {min_m: [0, 0, 0], max_m: [3, 16, 10]}\n"
        "media: {fog: {extinction_per_m: 0.05, albedo: 0.9}}\n"
        "regions: [{medium: fog}]\n"
        "lights: [{type: directional, " DOWN_60 ", irradiance_w_per_m2: 1}]\n",
        0);
    double depth = 0;
    for (int i = 0; i < 16; ++i) {
        depth += 0.05 * fmin(20, (i + 0.5) * 2 / sqrt(3)) / 16;
    }
    CHECK_NEAR(t.optical_depth.band[0], depth, 1e-9);
    CHECK(1 - depth > 0.1);
}

/* A roof over half of the floor and water over all of it: light from the
 * zenith ends at 8 m or at the water's level of 2 m. */
static void test_roofs_and_water(void)
{
    const murk_daylight_loss t =
        of("murk: 1\nbands_nm: [532]\n"
           "domain: {min_m: [0, 0, 0], max_m: [4, 4, 10]}\n"
           "geometry: [{rect: {corner_m: [-1, -1, 8], edge1_m: [3, 0, 0], "
           "edge2_m: [0, 6, 0]}}]\n"
           "media: {fog: {extinction_per_m: 0.05, albedo: 0.9}, sea: "
           "{extinction_per_m: 5, albedo: 0.9}}\n"
           "regions: [{medium: fog}, {medium: sea, below_z_m: 2, ior: 1.34}]\n"
           "lights: [{type: directional, direction: [0, 0, -1], "
           "irradiance_w_per_m2: 1}, {type: point, position_m: [1, 1, 5], "
           "power_w: 1}]\n",
           0);
    CHECK_NEAR(t.optical_depth.band[0], 0.05 * (2 + 8) / 2, 1e-6);
    CHECK_NEAR(t.transmittance.band[0], (exp(-0.1) + exp(-0.4)) / 2, 1e-6);
}

/* Regions without an index are flown through, and add: a layer of 1 m in fog
 * all the way. */
static void test_regions_add(void)
{
    const murk_daylight_loss t =
        of("murk: 1\nbands_nm: [532]\n"
           "domain: {min_m: [0, 0, 0], max_m: [4, 4, 10]}\n"
           "media: {fog: {extinction_per_m: 0.05, albedo: 0.9}, layer: "
           "{extinction_per_m: 0.2, albedo: 0.9}}\n"
           "regions: [{medium: fog}, {medium: layer, box: {min_m: [0, 0, 4], "
           "max_m: [4, 4, 5]}}]\n"
           "lights: [{type: directional, direction: [0, 0, -1], "
           "irradiance_w_per_m2: 1}]\n",
           0);
    CHECK_NEAR(t.optical_depth.band[0], 0.05 * 10 + 0.2 * 1, 1e-9);
}

static void test_what_has_no_answer(void)
{
    const char *scene =
        "murk: 1\nbands_nm: [532]\n"
        "domain: {min_m: [0, 0, 0], max_m: [4, 4, 10]}\n"
        "lights: [{type: point, position_m: [1, 1, 5], power_w: 1}, "
        "{type: directional, direction: [0, 0, 1], irradiance_w_per_m2: 1}, "
        "{type: directional, direction: [0, 0, -1], irradiance_w_per_m2: 1}]\n";
    CHECK(!of(scene, 0).is_known);
    CHECK(!of(scene, 1).is_known);
    const murk_daylight_loss clear = of(scene, 2);
    CHECK(clear.is_known && clear.share == 0);
}

/* An even sky over a wide slab: the mean of exp(-tau / mu) over equal parts of
 * irradiance is 2 E3(tau), .44 at tau = .5 (E3(.5) = .22160); 4 rings are good
 * to some percent. */
static void test_a_dome(void)
{
    const murk_daylight_loss t =
        of("murk: 1\nband_edges_nm: [400, 700]\n"
           "site: {latitude_deg: 52, longitude_deg: 5, time: "
           "2026-06-21T12:00:00Z}\n"
           "domain: {min_m: [0, 0, 0], max_m: [50, 50, 10], sides: periodic}\n"
           "media: {fog: {extinction_per_m: 0.05, albedo: 0.9}}\n"
           "regions: [{medium: fog}]\n"
           "lights: [{type: sky}]\n",
           0);
    CHECK(t.is_known);
    CHECK_NEAR(t.transmittance.band[0], 2 * 0.22160, 0.02);
}

int main(void)
{
    test_a_slab();
    test_an_open_box();
    test_roofs_and_water();
    test_regions_add();
    test_what_has_no_answer();
    test_a_dome();
    return check_done();
}
