/* Targets: how much area and volume lies in free space, which side they are
 * seen from, what is in which medium, and lists.
 *
 * Areas and volumes are known, and their errors are the estimates' own: CHECKS
 * z-tests share a chance of 1e-6 of a false alarm per seed (Sidak). The seed is
 * fixed, so the verdict repeats. */
#include "base/file.h"
#include "base/stats.h"
#include "check.h"
#include "plan/targets.h"
#include "stage_text.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

#define CHECKS 12
#define BUDGET 1e-6

/* A room of 4 x 4 x 3 m on whose floor stands a crate of 1 x 1 x 1 m; a sheet
 * hangs free; smoke in a ball and, twice as thick, in a box of 2 x 1 x 1 m that
 * fills half of the crate's neighbourhood. Two bands: the mist is in the second
 * alone. */
static const char SCENE[] =
    "murk: 1\n"
    "bands_nm: [450, 650]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}\n"
    "  - {box: {min_m: [1, 1, 0], max_m: [2, 2, 1]}, material: crate}\n"
    "  - {rect: {corner_m: [3, 1, 1], edge1_m: [0, 2, 0], edge2_m: [0, 0, 1]},"
    " material: sheet}\n"
    "  - {sphere: {center_m: [3.3, 3.3, 2.4], radius_m: 0.4}, material: ball}\n"
    "materials: {wall: {}, crate: {}, sheet: {}, ball: {}, gold: {}}\n"
    "media:\n"
    "  smoke: {extinction_per_m: 1, albedo: 0.5}\n"
    "  soot: {extinction_per_m: 2, albedo: 0.5}\n"
    "  mist: {extinction_per_m: [0, 0.1], albedo: 1}\n"
    "regions:\n"
    "  - {medium: mist, box: {min_m: [0, 0, 2], max_m: [4, 4, 3]}}\n"
    "  - {medium: smoke, sphere: {center_m: [1, 3, 2], radius_m: 0.5}}\n"
    "  - {medium: soot, box: {min_m: [1, 1, 0], max_m: [3, 2, 1]}}\n"
    "lights: [{type: point, position_m: [0.5, 0.5, 2.5], power_w: 1}]\n"
    "photons: {emit: 10, maps: none}\n"
    "sensors: {types: [{name: node, range_m: 9}], count: 1}\n";

#define WALLS  (2 * (16 + 12 + 12.0))
#define CRATE  5.0 /* its bottom stands on the floor */
#define FLOOR  1.0 /* under it */
#define SHEET  (2 * 2.0)
#define BALL   (4 * MURK_PI * 0.16)
#define INSIDE (48.0 - 1 - 4 / 3.0 * MURK_PI * 0.064)
#define SMOKE  (4 / 3.0 * MURK_PI * 0.125)
#define SOOT   1.0 /* outside of the crate */

static const char *seed_text = "seed=1";

static murk_stage *stage_with(const char *targets)
{
    char text[512];
    snprintf(text, sizeof text, "placement.targets=%s", targets);
    const char *const overrides[] = {text, seed_text, NULL};
    murk_stage *stage = stage_text_create(SCENE, overrides);
    CHECK(stage != NULL);
    return stage;
}

static murk_target_facts facts_of(const char *targets)
{
    murk_targets t = {0};
    murk_error err = {0};
    murk_stage *stage = stage_with(targets);
    CHECK(murk_targets_create(&t, stage, 0, 2, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    const murk_target_facts facts = t.facts;
    CHECK(facts.surface == murk_photon_map_count(t.surface));
    CHECK(facts.volume == murk_photon_map_count(t.volume));
    CHECK(t.independent == facts.points);
    murk_targets_release(&t);
    stage_text_destroy(stage);
    return facts;
}

static void check_size(const char *targets, double want, double wrong)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    const murk_target_facts facts = facts_of(targets);
    const murk_estimate got =
        isfinite(facts.area_m2.value) ? facts.area_m2 : facts.volume_m3;
    CHECK_WITHIN(limit, got.value, want, got.standard_error);
    /* Teeth. */
    CHECK(sigmas_off(got.value, wrong, got.standard_error) > 2 * limit);
}

static void test_areas_in_free_space(void)
{
    check_size("{surfaces: {points: 60000}}",
               WALLS + CRATE - FLOOR + SHEET + BALL,
               WALLS + CRATE + SHEET + BALL);
    check_size("{surfaces: {spacing_m: 0.035}}",
               WALLS + CRATE - FLOOR + SHEET + BALL,
               WALLS + 1 + CRATE - FLOOR + SHEET + BALL);
    check_size("{surfaces: {materials: [crate], points: 4000}}", CRATE, 6);
    check_size("{surfaces: {materials: [crate, ball], points: 4000}}",
               CRATE + BALL, CRATE + 2 * BALL);
    /* both sides of it, so nothing is left to chance */
    const murk_target_facts sheet =
        facts_of("{surfaces: {materials: [sheet], points: 1000}}");
    CHECK(sheet.surface == 2000 && sheet.points == 1000);
    CHECK_NEAR(sheet.area_m2.value, SHEET, 1e-4);
    CHECK_NEAR(sheet.area_m2.standard_error, 0, 1e-6);
    CHECK(isnan(sheet.volume_m3.value));
}

static void test_volumes_in_free_space(void)
{
    check_size("{volume: {points: 40000}}", INSIDE, 48);
    check_size("{volume: {spacing_m: 0.1}}", INSIDE, INSIDE + 1);
    check_size("{volume: {box: {min_m: [0, 0, 0], max_m: [2, 2, 2]}}}", 7, 8);
    check_size("{volume: {sphere: {center_m: [1, 3, 2], radius_m: 0.5}}}",
               SMOKE, 1);
    check_size("{volume: {medium: smoke}}", SMOKE, 1);
    check_size("{volume: {medium: soot}}", SOOT, 2);
    check_size("{volume: {medium: smoke, box: {min_m: [1, 0, 0], max_m: "
               "[4, 4, 3]}}}",
               SMOKE / 2, SMOKE);
    /* of one cube, cut at the domain */
    const murk_target_facts cut =
        facts_of("{volume: {box: {min_m: [3, -1, 2], max_m: [9, 1, 8]}, "
                 "points: 500}}");
    CHECK_NEAR(cut.volume_m3.value, 1, 1e-6);
    CHECK(isnan(cut.area_m2.value));
}

static void test_a_medium_by_its_band(void)
{
    murk_error err = {0};
    murk_stage *stage = stage_with("{volume: {medium: mist}}");
    CHECK(murk_targets_check(stage, 1, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "lies in free space");
    CHECK_MENTIONS(err.where, "placement.targets.volume");
    stage_text_destroy(stage);
    const murk_target_facts facts =
        facts_of("{volume: {medium: mist, points: 1000}, band_nm: 650}");
    CHECK(facts.points == 1000);
    check_size("{volume: {medium: mist, points: 1000}, band_nm: 650}",
               16 - 4 / 3.0 * MURK_PI * 0.064, 32);
}

/* Normals point into free space, and each record has the band, number and
 * material of the point that it stands for. */
static void test_records(void)
{
    /* Points on all surfaces and in all free air, in the second band. */
    murk_error err = {0};
    murk_targets t = {0};
    murk_stage *stage = stage_with("{surfaces: {points: 3000}, volume: "
                                   "{points: 3000}, band_nm: 650}");
    CHECK(murk_targets_create(&t, stage, 0, 2, &err) == MURK_OK);
    /* Normals of the walls point into the room, those of the crate away
     * from the crate. */
    size_t walls = 0, soot = 0, mist = 0;
    const murk_photon *p = murk_photon_map_photons(t.surface);
    for (size_t i = 0; i < t.facts.surface; ++i) {
        const murk_vec3 at = {(double)p[i].position_m[0],
                              (double)p[i].position_m[1],
                              (double)p[i].position_m[2]};
        const murk_vec3 n = murk_direction_unpack(p[i].normal);
        const murk_vec3 in = murk_sub(murk_vec(2, 2, 1.5), at);
        CHECK(p[i].band == 1 && !murk_photon_is_volume(&p[i]));
        CHECK(p[i].emitted < t.independent);
        if (p[i].material == 1) {
            ++walls;
            CHECK(murk_dot(n, in) > 0);
        } else if (p[i].material == 2) {
            const murk_vec3 out = murk_sub(at, murk_vec(1.5, 1.5, 0.5));
            CHECK(murk_dot(n, out) > 0);
        }
    }
    /* Points in the air name the medium: soot in the box, and never none
     * within the mist. */
    p = murk_photon_map_photons(t.volume);
    for (size_t i = 0; i < t.facts.volume; ++i) {
        CHECK(p[i].band == 1 && murk_photon_is_volume(&p[i]));
        CHECK(p[i].emitted >= 3000 && p[i].emitted < 6000);
        const float *x = p[i].position_m;
        const bool is_soot =
            x[0] > 1 && x[0] < 3 && x[1] > 1 && x[1] < 2 && x[2] < 1;
        CHECK((p[i].material == 1) == is_soot);
        CHECK(!(p[i].material == UINT8_MAX && x[2] > 2));
        soot += is_soot;
        mist += p[i].material == 2;
    }
    /* Enough points of each kind were checked. */
    CHECK(walls > 2000 && soot > 20 && mist > 500);
    murk_targets_release(&t);
    stage_text_destroy(stage);
}

/* Another stream gives other points; another number of threads gives the
 * same points. */
static void test_streams_and_threads(void)
{
    /* The same targets with one thread, with five, and with another stream. */
    murk_error err = {0};
    murk_targets t[3] = {{0}};
    murk_stage *stage = stage_with("{surfaces: {points: 30000}, volume: "
                                   "{points: 2000}}");
    for (int k = 0; k < 3; ++k) {
        CHECK(murk_targets_create(&t[k], stage, k == 2 ? 1 : 0, k == 1 ? 5 : 1,
                                  &err) == MURK_OK);
    }
    /* The number of threads changes nothing. */
    const size_t n = t[0].facts.surface;
    CHECK(memcmp(&t[0].facts, &t[1].facts, sizeof t[0].facts) == 0);
    /* Another stream changes the points. */
    CHECK(memcmp(murk_photon_map_photons(t[0].surface),
                 murk_photon_map_photons(t[1].surface),
                 n * sizeof(murk_photon)) == 0);
    CHECK(memcmp(murk_photon_map_photons(t[0].volume),
                 murk_photon_map_photons(t[1].volume),
                 2000 * sizeof(murk_photon)) == 0);
    CHECK(memcmp(murk_photon_map_photons(t[0].surface),
                 murk_photon_map_photons(t[2].surface),
                 sizeof(murk_photon)) != 0);
    for (int k = 0; k < 3; ++k) {
        murk_targets_release(&t[k]);
    }
    stage_text_destroy(stage);
}

/* ---- lists ---- */

static char list_path[] = "/tmp/murk_test_targets_XXXXXX";

static murk_status read_list(murk_targets *t, const char *text, murk_error *err)
{
    char settings[128];
    write_text(list_path, text);
    snprintf(settings, sizeof settings, "{points: %s}", list_path);
    murk_stage *stage = stage_with(settings);
    const murk_status status = murk_targets_create(t, stage, 0, 2, err);
    stage_text_destroy(stage);
    return status;
}

static void test_a_list(void)
{
    murk_targets t = {0};
    murk_error err = {0};
    CHECK(read_list(&t,
                    "name,x_m,y_m,z_m,normal_x,normal_y,normal_z,weight\n"
                    "a,3,1.5,1.5,-7,0,0,2\nb,2.5,1.5,0.5,,,,0.5\n"
                    "c,0.5,0.5,2.5,0,0,0,\n",
                    &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    CHECK(t.facts.points == 3 && t.facts.surface == 1 && t.facts.volume == 2);
    CHECK(t.independent == 1);
    CHECK(isnan(t.facts.area_m2.value) && isnan(t.facts.volume_m3.value));
    const murk_photon *wall = murk_photon_map_photons(t.surface);
    CHECK(wall->power_w == 2 && wall->material == 3);
    CHECK(murk_direction_unpack(wall->normal).x == -1);
    double weight = 0;
    for (size_t i = 0; i < 2; ++i) {
        const murk_photon *p = &murk_photon_map_photons(t.volume)[i];
        weight += (double)p->power_w;
        CHECK(p->material == (p->power_w < 1 ? 1 : UINT8_MAX));
    }
    CHECK(weight == 1.5);
    murk_targets_release(&t);
}

static void expect_refusal(const char *text, const char *part)
{
    murk_targets t = {0};
    murk_error err = {0};
    CHECK(read_list(&t, text, &err) != MURK_OK);
    CHECK_MENTIONS(err.text, part);
    CHECK_MENTIONS(err.where, list_path);
    murk_targets_release(&t);
}

static void test_bad_lists(void)
{
    expect_refusal("x_m,y_m\n1,1\n", "misses column z_m");
    expect_refusal("x_m,y_m,z_m,normal_x\n1,1,2,1\n", "all three or none");
    expect_refusal("x_m,y_m,z_m\n", "0 targets");
    expect_refusal("x_m,y_m,z_m\n5,1,1\n", "outside of the domain");
    expect_refusal("x_m,y_m,z_m\nnan,1,1\n", "nan");
    expect_refusal("x_m,y_m,z_m,weight\n1,1,2,-1\n", "must be 0..1e6");
    expect_refusal("x_m,y_m,z_m,weight\n1,1,2,0\n", "a weight above 0");
    expect_refusal("x_m,y_m,z_m\n1.5,1.5,1\n", "lies on a surface");
    expect_refusal("x_m,y_m,z_m,normal_x,normal_y,normal_z\n1,1,1,1e308,1e308,"
                   "1e308\n",
                   "of finite length");
}

int main(int argc, char **argv)
{
    char text[32];
    snprintf(text, sizeof text, "seed=%s", argc > 1 ? argv[1] : "1");
    seed_text = text;
    const int fd = mkstemp(list_path);
    CHECK(fd >= 0);
    test_areas_in_free_space();
    test_volumes_in_free_space();
    test_a_medium_by_its_band();
    test_records();
    test_streams_and_threads();
    test_a_list();
    test_bad_lists();
    if (fd >= 0) {
        close(fd);
        unlink(list_path);
    }
    return check_done();
}
