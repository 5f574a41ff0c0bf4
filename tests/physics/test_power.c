/* Detection by power: a plate of known radiance gives the coverage worked out
 * by hand, and what is judged is the place, not the packet: with 4 times as
 * many photons coverage moves by no more than its error.
 *
 * The checks share a 1e-6 chance of a false alarm (Sidak); seeds are fixed. */
#include "base/log.h"
#include "base/stats.h"
#include "check.h"
#include "plan/plan.h"
#include "sensing/power.h"
#include "stage_text.h"

#include <stdlib.h>

#define CHECKS 5

static double limit(void)
{
    return murk_sidak_limit(1e-6, CHECKS);
}

static murk_estimate measure(const char *text, const murk_pose *pose, size_t n,
                             const char *const *overrides)
{
    murk_estimate out = {NAN, NAN};
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    murk_coverage_result coverage = {0};
    murk_stage *stage = stage_text_create(text, overrides);
    const bool is_measured =
        stage && !murk_lightmap_trace(&traced, stage, 0, 2, &err) &&
        !murk_plan_sight(&sight, stage, traced, 2, &err) &&
        !murk_coverage_result_measure(&coverage, sight, pose, n, &err);
    CHECK(is_measured);
    if (is_measured) {
        out = coverage.total;
    } else {
        printf("%s: %s\n", err.where, err.text);
    }
    murk_coverage_result_release(&coverage);
    murk_sight_destroy(sight);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return out;
}

/* ---- the plate ---- */

/* 400 m2 under 3 W/m2 from above, of which .5 leave by the cosine law: each
 * place's radiance is 1.5 / pi. No other surface, no medium. */
static const char plate_text[] =
    "murk: 1\n"
    "bands_nm: [500]\n"
    "domain: {min_m: [0, 0, 0], max_m: [20, 20, 10]}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 1], edge1_m: [20, 0, 0], edge2_m: [0, 20, "
    "0]}, material: plate}\n"
    "materials: {plate: {diffuse: 0.5}}\n"
    "lights:\n"
    "  - {type: directional, direction: [0, 0, -1], irradiance_w_per_m2: 3}\n"
    "photons: {emit: 200000}\n"
    "sensors: {types: [{name: eye, range_m: 7, aperture_m2: 0.01,\n"
    "  quantum_efficiency: 0.25, exposure_s: 1e-14, target_m2: 0.6}]}\n"
    "placement: {detection: power, power_radius_m: 0.6}\n";

#define HEIGHT 3.
#define EMIT   200000.
#define STEPS  20000

/* The sensor's mean count of the target at a place so far from below it; the
 * factor makes it wrong. */
static double counts(double rho, double factor)
{
    const double planck = 6.62607015e-34, light = 299792458;
    const double per_j = 1e-14 * 0.25 * 500e-9 / (planck * light);
    const double d2 = rho * rho + HEIGHT * HEIGHT, cosine = HEIGHT / sqrt(d2);
    const double radiance = 3 * 0.5 / MURK_PI;
    return factor * per_j * radiance * 0.6 * cosine * 0.01 /
           (d2 + 0.01 / MURK_PI);
}

/* Coverage is the mean over the plate of 1 - exp(-x), x the counts. A photon
 * more adds itself and raises the x of those around it: its share in the
 * variance is that of 1 - exp(-x) + x exp(-x). */
static double coverage_of_plate(double factor, double *sigma)
{
    const double max = sqrt(7 * 7 - HEIGHT * HEIGHT);
    double mean = 0, first = 0, second = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double rho = (i + .5) * max / STEPS, x = counts(rho, factor);
        const double share = 2 * MURK_PI * rho * max / STEPS / 400;
        const double f = 1 - exp(-x) + x * exp(-x);
        mean += share * (1 - exp(-x));
        first += share * f;
        second += share * f * f;
    }
    *sigma = sqrt((second - first * first) / EMIT);
    return mean;
}

static void test_a_plate_is_noticed_by_its_radiance(void)
{
    const murk_pose eye = {.position = {10, 10, 1 + HEIGHT}};
    double sigma, ignored;
    const double want = coverage_of_plate(1, &sigma);
    const double got = measure(plate_text, &eye, 1, NULL).value;
    printf("plate: %.5f, want %.5f +- %.5f\n", got, want, sigma);
    CHECK(want > 0.05 && want < 0.3);
    CHECK_WITHIN(limit(), got, want, sigma);
    CHECK(sigmas_off(got, coverage_of_plate(1.06, &ignored), sigma) > limit());
    CHECK(sigmas_off(got, coverage_of_plate(0.94, &ignored), sigma) > limit());
}

/* ---- more photons ---- */

#define SEEDS 8

static const char hall_text[] =
    "murk: 1\n"
    "bands_nm: [450, 550]\n"
    "domain: {min_m: [0, 0, 0], max_m: [10, 8, 4]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0.01, 0.01, 0.01], max_m: [9.99, 7.99, 3.99]},"
    " material: wall}\n"
    "  - {box: {min_m: [4.4, 0.02, 0.02], max_m: [4.6, 5, 3.98]},"
    " material: wall}\n"
    "materials: {wall: {diffuse: 0.6}}\n"
    "media: {fog: {extinction_per_m: 0.1, albedo: 0.9, phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [2, 7, 3], power_w: 10}\n"
    "sensors: {types: [{name: eye, range_m: 20, aperture_m2: 1e-4,\n"
    "  quantum_efficiency: 0.5, exposure_s: 4e-11, target_m2: 0.04,\n"
    "  target_m3: 0.1}]}\n"
    "placement: {detection: power, power_radius_m: 0.7}\n";

/* Much the same hall, and nothing said of apertures, times or radii. */
static const char default_text[] =
    "murk: 1\n"
    "bands_nm: [550]\n"
    "domain: {min_m: [0, 0, 0], max_m: [10, 8, 4]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0.01, 0.01, 0.01], max_m: [9.99, 7.99, 3.99]},"
    " material: wall}\n"
    "  - {box: {min_m: [4.4, 0.02, 0.02], max_m: [4.6, 5, 3.98]},"
    " material: wall}\n"
    "materials: {wall: {diffuse: 0.6}}\n"
    "media: {fog: {extinction_per_m: 0.1, albedo: 0.9, phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [2, 7, 3], power_w: 10}\n"
    "sensors: {types: [{name: eye, range_m: 4}]}\n"
    "placement: {detection: power}\n";

static const murk_pose sensors[2] = {{.position = {2, 6, 2}},
                                     {.position = {8, 3, 2}}};

/* The mean over seeds, with its error. */
static murk_estimate mean_of(const char *emit, const char *exposure)
{
    murk_estimate mean = {0, 0};
    for (unsigned seed = 1; seed <= SEEDS; ++seed) {
        char seed_text[32];
        snprintf(seed_text, sizeof seed_text, "seed=%u", seed);
        const char *const overrides[] = {emit, seed_text, exposure, NULL};
        const murk_estimate one = measure(hall_text, sensors, 2, overrides);
        mean.value += one.value / SEEDS;
        mean.standard_error += one.standard_error * one.standard_error;
    }
    mean.standard_error = sqrt(mean.standard_error) / SEEDS;
    return mean;
}

static void test_more_photons_change_nothing_but_the_error(void)
{
    const char *const few_text = "photons.emit=2000";
    const char *const many_text = "photons.emit=8000";
    const murk_estimate few = mean_of(few_text, NULL);
    const murk_estimate many = mean_of(many_text, NULL);
    const murk_estimate longer =
        mean_of(many_text, "sensors.types.0.exposure_s=4.6e-11");
    const double error = hypot(few.standard_error, many.standard_error);
    printf(
        "hall: %.5f +- %.5f with 2000, %.5f +- %.5f with 8000, %.5f longer\n",
        few.value, few.standard_error, many.value, many.standard_error,
        longer.value);
    CHECK(few.value > 0.2 && few.value < 0.8);
    CHECK_WITHIN(limit(), few.value, many.value, error);
    CHECK(sigmas_off(few.value, longer.value, error) > limit());
}

/* ---- at the defaults ---- */

#define DEFAULT_SEEDS 16

typedef struct spread {
    double mean, error; /* as the seeds scatter, of the mean */
} spread;

static spread spread_of(const char *emit, const char *radius)
{
    double sum = 0, sum2 = 0;
    for (unsigned seed = 1; seed <= DEFAULT_SEEDS; ++seed) {
        char seed_text[32];
        snprintf(seed_text, sizeof seed_text, "seed=%u", seed);
        const char *const overrides[] = {emit, seed_text, radius, NULL};
        const double one = measure(default_text, sensors, 2, overrides).value;
        sum += one;
        sum2 += one * one;
    }
    const double mean = sum / DEFAULT_SEEDS;
    const double variance = (sum2 - sum * mean) / (DEFAULT_SEEDS - 1);
    return (spread){mean, sqrt(variance / DEFAULT_SEEDS)};
}

/* The errors of both come from 16 seeds each, 30 degrees of freedom: the
 * normal limit is widened as Student's law is (Peiser, 1943, doi:
 * 10.1214/aoms/1177731544). */
static double widened(double z)
{
    const double freedom = 2. * (DEFAULT_SEEDS - 1);
    return z + (z * z * z + z) / (4 * freedom) +
           (5 * pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * freedom * freedom);
}

static void test_the_defaults_judge_the_place_and_not_the_packet(void)
{
    const char *const few_text = "photons.emit=2500";
    const char *const many_text = "photons.emit=10000";
    const char *const small = "placement.power_radius_m=0.2";
    const spread few = spread_of(few_text, NULL);
    const spread many = spread_of(many_text, NULL);
    const spread few_small = spread_of(few_text, small);
    const spread many_small = spread_of(many_text, small);
    const double error = hypot(few.error, many.error);
    printf("defaults: %.5f +- %.5f with 2500, %.5f +- %.5f with 10000; within "
           ".2 m %.5f and %.5f\n",
           few.mean, few.error, many.mean, many.error, few_small.mean,
           many_small.mean);
    CHECK(few.mean > 0.2 && few.mean < 0.9);
    CHECK_WITHIN(widened(limit()), few.mean, many.mean, error);
    /* Teeth: within a small radius few photons lie when few are traced. */
    CHECK(sigmas_off(few_small.mean, many_small.mean,
                     hypot(few_small.error, many_small.error)) >
          widened(limit()));
}

int main(void)
{
    /* of small radii, which are asked for here */
    murk_warn_to(NULL);
    test_a_plate_is_noticed_by_its_radiance();
    test_more_photons_change_nothing_but_the_error();
    test_the_defaults_judge_the_place_and_not_the_packet();
    return check_done();
}
