/* The stated standard error of a held-out coverage is the true one.
 *
 * In 200 seeds the coverage lies within one stated sigma of the value of a map
 * 100 times as large as often as a normal distribution does: sqrt(1.01) sigma
 * of the difference, so with probability erf(1 / sqrt(2.02)) = .6803. The
 * counts are binomial; the checks share a 1e-6 false-alarm budget. The seeds
 * are fixed, so the verdict repeats.
 *
 * Teeth: in dense fog the many events of one photon see or miss the sensors
 * together, and the binomial error, which takes them for independent, must be
 * seen to fail. */
#include "base/stats.h"
#include "check.h"
#include "plan/plan.h"
#include "stage_text.h"

#include <stdlib.h>

#define SEEDS  200
#define CHECKS 3

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [10, 8, 4]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0.01, 0.01, 0.01], max_m: [9.99, 7.99, 3.99]},"
    " material: wall}\n"
    "  - {box: {min_m: [4.4, 0.02, 0.02], max_m: [4.6, 6.5, 3.98]},"
    " material: wall}\n"
    "materials: {wall: {diffuse: 0.9}}\n"
    "media: {fog: {extinction_per_m: 0.4, albedo: 0.999, phase: isotropic}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [4.5, 7.2, 2], power_w: 10}\n"
    "photons: {emit: 300}\n"
    "sensors: {types: [{name: node, range_m: 3}]}\n";

static const murk_pose sensors[2] = {{.position = {2, 6, 2}},
                                     {.position = {2, 2, 2}}};

typedef struct measured {
    murk_estimate coverage;
    double binomial_error;
} measured;

static measured measure(const char *extinction, const char *emit, unsigned seed)
{
    char seed_text[32];
    snprintf(seed_text, sizeof seed_text, "seed=%u", seed);
    const char *const overrides[] = {extinction, emit, seed_text, NULL};
    measured out = {{NAN, NAN}, NAN};
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    murk_coverage_result coverage = {0};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    const bool is_measured =
        stage && !murk_lightmap_trace(&traced, stage, 1, 1, &err) &&
        !murk_plan_sight(&sight, stage, traced, 1, &err) &&
        !murk_coverage_result_measure(&coverage, sight, sensors, 2, &err);
    CHECK(is_measured);
    if (is_measured) {
        /* balanced: the mean of two fractions, each of independent records */
        const double s = coverage.surface.value, v = coverage.volume.value;
        const double n_s = (double)murk_photon_map_count(traced->surface);
        const double n_v = (double)murk_photon_map_count(traced->volume);
        out.coverage = coverage.total;
        out.binomial_error =
            n_v > 0 ? sqrt(s * (1 - s) / n_s + v * (1 - v) / n_v) / 2
                    : sqrt(s * (1 - s) / n_s);
    } else {
        printf("%s: %s\n", err.where, err.text);
    }
    murk_coverage_result_release(&coverage);
    murk_sight_destroy(sight);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return out;
}

/* Of SEEDS coverages, how many lie within one sigma of the large map's. */
static void count_hits(const char *extinction, double *by_photon,
                       double *binomial)
{
    const measured truth = measure(extinction, "photons.emit=30000", 100000);
    *by_photon = *binomial = 0;
    for (unsigned seed = 1; seed <= SEEDS; ++seed) {
        const measured m = measure(extinction, "photons.emit=300", seed);
        const double off = fabs(m.coverage.value - truth.coverage.value);
        *by_photon += off < m.coverage.standard_error;
        *binomial += off < m.binomial_error;
    }
    printf("%s: %g of %d within one stated sigma, %g within one binomial "
           "sigma\n",
           extinction, *by_photon, SEEDS, *binomial);
}

int main(void)
{
    const double p = erf(1 / sqrt(2.02));
    const double sigma = sqrt(SEEDS * p * (1 - p));
    const double limit = murk_sidak_limit(1e-6, CHECKS);
    double by_photon, binomial;

    count_hits("media.fog.extinction_per_m=0", &by_photon, &binomial);
    CHECK_WITHIN(limit, by_photon, SEEDS * p, sigma);
    count_hits("media.fog.extinction_per_m=0.4", &by_photon, &binomial);
    CHECK_WITHIN(limit, by_photon, SEEDS * p, sigma);
    CHECK(sigmas_off(binomial, SEEDS * p, sigma) > limit);
    return check_done();
}
