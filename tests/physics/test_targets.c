/* Targets in a dark room are covered as far as geometry and Beer's law say.
 *
 * No light is stored: walls are black. One sensor looks at a wall past a
 * screen: by similar triangles the screen's shadow is a rectangle of known
 * area. In a gas, coverage is the mean of exp(-k d), here by Gauss-Legendre
 * quadrature over the wall. In the volume, what is within range of a sensor in
 * the middle is a ball. CHECKS z-tests share a chance of 1e-6 of a false alarm
 * per seed (Sidak); the seed is fixed, so the verdict repeats. */
#include "base/stats.h"
#include "cases/condition_plans.h"
#include "check.h"
#include "plan/plan.h"
#include "stage_text.h"

#include <stdlib.h>

#define CHECKS 9
#define BUDGET 1e-6

/* The sensor at (1, 2, 1.5), a screen 1 m wide from floor to ceiling 1.5 m in
 * front of it, and 1.5 m behind that the wall in question: so 2 m of its 4 are
 * hidden. The gas is in the second band only. */
static const char SCENE[] =
    "murk: 1\n"
    "bands_nm: [450, 650]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: black}\n"
    "  - {rect: {corner_m: [2.5, 1.5, 0], edge1_m: [0, 1, 0], edge2_m: "
    "[0, 0, 3]}, material: black}\n"
    "  - {rect: {corner_m: [3.999, 0, 0], edge1_m: [0, 4, 0], edge2_m: "
    "[0, 0, 3]}, material: far}\n"
    "materials: {black: {}, far: {}}\n"
    "media: {gas: {extinction_per_m: [0, 0.5], albedo: 0}}\n"
    "regions: [{medium: gas}]\n"
    "lights: [{type: point, position_m: [0.5, 0.5, 2.5], power_w: 1}]\n"
    "photons: {emit: 1000}\n"
    "sensors: {types: [{name: node, range_m: 9}], count: 1, candidates: "
    "{grid: {min_m: [1, 2, 1.5], max_m: [1, 2, 1.5], size: [1, 1, 1]}}}\n";

#define WALL_X 2.999 /* from the sensor to the wall in question */
#define SHADOW (0.5 * WALL_X / 1.5) /* half its width, in y */

static const char *seed_text = "seed=1";

/* The one plan there is. */
static murk_plan_result plan_of(const char *targets, const char *more)
{
    char text[512];
    murk_error err = {0};
    murk_plan_result plan = {0};
    murk_traced *traced = NULL;
    snprintf(text, sizeof text, "placement.targets=%s", targets);
    const char *const overrides[] = {text, more ? more : seed_text, seed_text,
                                     NULL};
    murk_stage *stage = stage_text_create(SCENE, overrides);
    CHECK(stage && !murk_plan_prepare(&plan, stage, 2, &err) &&
          !murk_lightmap_trace(&traced, stage, 0, 2, &err) &&
          !murk_plan_for_scene(&plan, stage, traced, 2, &err));
    CHECK_TEXT(err.text, "");
    CHECK(!traced || murk_photon_map_count(traced->surface) == 0);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return plan;
}

static void check_coverage(murk_estimate got, double want, double wrong)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    CHECK_WITHIN(limit, got.value, want, got.standard_error);
    /* Teeth. */
    CHECK(sigmas_off(got.value, wrong, got.standard_error) > 2 * limit);
}

/* In sample, and by the second draw. */
static void check_both(const char *targets, const char *more, double want,
                       double wrong)
{
    murk_plan_result plan = plan_of(targets, more);
    check_coverage(plan.in_sample.total, want, wrong);
    CHECK(plan.has_held_out);
    check_coverage(plan.held_out, want, wrong);
    CHECK(plan.held_out.value != plan.in_sample.total.value);
    murk_plan_result_release(&plan);
}

static void test_a_shadow_on_the_wall(void)
{
    const char *far = "{surfaces: {materials: [far], points: 40000}}";
    const double seen = 1 - 2 * SHADOW / 4;
    check_both(far, NULL, seen, 1 - 1.15 * 2 * SHADOW / 4);
    /* The error of a share of independent points is known. */
    murk_plan_result plan = plan_of(far, NULL);
    CHECK_NEAR(plan.in_sample.total.standard_error,
               sqrt(seen * (1 - seen) / 40000), 5e-5);
    CHECK(plan.targets.points == 40000);
    CHECK(plan.place.curve_points >= 1);
    CHECK(plan.place.proven_optimal);
    murk_plan_result_release(&plan);
}

/* ---- through gas ---- */

/* Nodes and weights of the ten-point rule on (-1, 1), the positive half. */
static const double NODE[5] = {0.1488743389816312, 0.4333953941292472,
                               0.6794095682990244, 0.8650633666889845,
                               0.9739065285171717};
static const double WEIGHT[5] = {0.2955242247147529, 0.2692667193099963,
                                 0.2190863625159820, 0.1494513491505806,
                                 0.0666713443086881};

/* Mean of exp(-k d) over y in (a, b) from the sensor's, z in (-1.5, 1.5). */
static double mean_through_gas(double k, double a, double b)
{
    double sum = 0;
    for (int i = 0; i < 10; ++i) {
        for (int j = 0; j < 10; ++j) {
            const double u = (i % 2 ? -1 : 1) * NODE[i / 2];
            const double v = (j % 2 ? -1 : 1) * NODE[j / 2];
            const double y = (a + b) / 2 + (b - a) / 2 * u, z = 1.5 * v;
            const double d = sqrt(WALL_X * WALL_X + y * y + z * z);
            sum += WEIGHT[i / 2] * WEIGHT[j / 2] / 4 * exp(-k * d);
        }
    }
    return sum;
}

/* In the band of the targets, not in another. */
static void test_the_wall_through_gas(void)
{
    const double lit = 1 - 2 * SHADOW / 4;
    check_both("{surfaces: {materials: [far], points: 40000}, band_nm: 650}",
               NULL, lit * mean_through_gas(0.5, SHADOW, 2),
               lit * mean_through_gas(0.55, SHADOW, 2));
}

/* A region of interest is measured by itself, whatever it weighs. */
static void test_a_region_of_the_wall(void)
{
    murk_plan_result plan =
        plan_of("{surfaces: {materials: [far], points: 40000}}",
                "placement.interest=[{name: right, weight: 4, box: {min_m: "
                "[0, 1, 0], max_m: [4, 4, 3]}}]");
    const double dark = 2 * SHADOW; /* all of it in the region's 3 m */
    check_coverage(plan.in_sample.region[0].coverage, (3 - dark) / 3,
                   (3 - 1.1 * dark) / 3);
    check_coverage(plan.held_out_region[0].coverage, (3 - dark) / 3,
                   (3 - 1.1 * dark) / 3);
    check_coverage(plan.in_sample.total, (4 * (3 - dark) + 1) / 13,
                   (4 - dark) / 4);
    murk_plan_result_release(&plan);
}

/* A ball of 1 m about the sensor, short of all walls. */
static void test_within_range(void)
{
    const double box = 4 * 4 * 3;
    check_both("{volume: {points: 60000}}", "sensors.types.0.range_m=1",
               4 / 3.0 * MURK_PI / box, 1.2 * 4 / 3.0 * MURK_PI / box);
}

int main(int argc, char **argv)
{
    char text[32];
    snprintf(text, sizeof text, "seed=%s", argc > 1 ? argv[1] : "1");
    seed_text = text;
    test_a_shadow_on_the_wall();
    test_the_wall_through_gas();
    test_a_region_of_the_wall();
    test_within_range();
    return check_done();
}
