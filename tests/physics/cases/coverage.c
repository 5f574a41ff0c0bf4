/* Coverage that is known by hand, and whether stated errors are true.
 *
 * A lamp in the middle of a sphere of radius R lights its wall evenly, directly
 * and by diffuse reflection, and so it does through fog that only absorbs. A
 * sensor at the distance a from the middle sees what lies within its range r:
 * the share (1 - c) / 2 of the wall, c = (R^2 + a^2 - r^2) / (2 R a), the
 * cosine at the middle. In fog of extinction s each photon counts by its
 * transmittance, so the coverage is the integral of exp(-s l) l / (2 R a) over
 * the distances l from R - a to r. Two sensors whose caps do not overlap see
 * the sum.
 *
 * Stated errors: over many seeds the mean of ((value - truth) / error)^2 is 1,
 * of the coverage and of a tally of the fluence rate (whose truth is that of
 * the integrating sphere, enclosures.c). Few of its digits are noise: the
 * spread of such a mean over S seeds is sqrt(2 / S). */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/vector.h"
#include "cases/groups.h"
#include "cases/reference.h"
#include "lightmap/lightmap.h"
#include "plan/plan.h"
#include "stage_text.h"

#define BY_HAND "closed form"

#define RADIUS      2.0
#define OFFSET      1.2 /* of the sensors from the middle */
#define DIFFUSE     .6
#define BALL        .5
#define PHOTONS     UINT64_C(2000000)
#define QUICK       UINT64_C(200000)
#define OF_A_SEED   2000 /* photons: enough for errors near normal */
#define SEEDS       1000
#define SEEDS_QUICK 200

static const char SCENE[] =
    "murk: 1\n"
    "domain: {min_m: [-3, -3, -3], max_m: [3, 3, 3]}\n"
    "geometry: [{sphere: {center_m: [0, 0, 0], radius_m: 2}, material: wall}]\n"
    "materials: {wall: {diffuse: 0.6}}\n"
    "media: {fog: {extinction_per_m: %g, albedo: 0}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n"
    "photons: {emit: %" PRIu64 "}\n"
    "tallies: [{name: ball, type: sphere, center_m: [0, 0, 0],"
    " radius_m: 0.5}]\n"
    "sensors: {types: [{name: node, range_m: %g}]}\n";

typedef struct measured {
    murk_estimate coverage, fluence;
} measured;

static measured measure(const validation *v, double fog_per_m, double range_m,
                        size_t sensors, uint64_t photons, uint32_t seed)
{
    static const murk_pose pose[2] = {{.position = {OFFSET, 0, 0}},
                                      {.position = {-OFFSET, 0, 0}}};
    /* The scene with this fog, range and seed. */
    char text[1200], seed_text[40];
    snprintf(text, sizeof text, SCENE, fog_per_m, photons, range_m);
    snprintf(seed_text, sizeof seed_text, "seed=%" PRIu32, seed);
    const char *const overrides[] = {seed_text, NULL};
    measured out = {{NAN, NAN}, {NAN, NAN}};
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    murk_coverage_result coverage = {0};
    /* Trace, and measure the coverage of the sensors and the fluence rate. */
    murk_stage *stage = stage_text_create(text, overrides);
    if (stage &&
        !murk_lightmap_trace(&traced, stage, 0, validation_threads(v), &err) &&
        !murk_plan_sight(&sight, stage, traced, validation_threads(v), &err) &&
        !murk_coverage_result_measure(&coverage, sight, pose, sensors, &err)) {
        out.coverage = coverage.total;
        out.fluence =
            murk_tallies_read(traced->tallies, 0, 0, 0, traced->ledger->emitted,
                              traced->packet_w);
    } else {
        printf("%s: %s\n", err.where, err.text);
    }
    murk_coverage_result_release(&coverage);
    murk_sight_destroy(sight);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return out;
}

/* ---- coverage by hand ---- */

static double share_in_clear_air(double range_m)
{
    const double cosine =
        (RADIUS * RADIUS + OFFSET * OFFSET - range_m * range_m) /
        (2 * RADIUS * OFFSET);
    return (1 - fmax(-1, cosine)) / 2;
}

/* The antiderivative of exp(-s l) l is -exp(-s l) (l / s + 1 / s^2). */
static double share_in_fog(double range_m, double s)
{
    const double first = RADIUS - OFFSET, last = fmin(range_m, RADIUS + OFFSET);
    const double below = exp(-s * first) * (first / s + 1 / (s * s));
    const double above = exp(-s * last) * (last / s + 1 / (s * s));
    return (below - above) / (2 * RADIUS * OFFSET);
}

static void by_hand(validation *v, const char *name, const char *is_wrong,
                    double fog_per_m, double range_m, size_t sensors,
                    double want)
{
    if (!validation_wants(v, name)) {
        return;
    }
    const uint64_t photons = validation_is_quick(v) ? QUICK : PHOTONS;
    const measured m = measure(v, fog_per_m, range_m, sensors, photons,
                               validation_seed(v) + 1);
    /* transmittances are stored in steps of 1 / 65535 */
    validation_check(v, name, BY_HAND, is_wrong,
                     &(validation_reference){"coverage", want, 7.7e-6},
                     m.coverage, photons);
}

/* ---- stated errors ---- */

typedef struct squares {
    double coverage, fluence;
} squares;

static squares over_seeds(const validation *v, int seeds, double error_factor)
{
    const double area = 4 * MURK_PI * RADIUS * RADIUS;
    const double coverage = share_in_clear_air(2);
    const double fluence =
        3 / (4 * MURK_PI * BALL * BALL) + 4 * DIFFUSE / (area * (1 - DIFFUSE));
    squares sum = {0, 0};
    for (int k = 0; k < seeds; ++k) {
        const measured m = measure(v, 0, 2, 1, OF_A_SEED,
                                   validation_seed(v) + 100 + (uint32_t)k);
        const double c = (m.coverage.value - coverage) /
                         (error_factor * m.coverage.standard_error);
        const double f = (m.fluence.value - fluence) /
                         (error_factor * m.fluence.standard_error);
        sum.coverage += c * c / seeds;
        sum.fluence += f * f / seeds;
    }
    return sum;
}

static void stated_errors(validation *v, const char *is_wrong,
                          double error_factor)
{
    const char *name = "stated errors over seeds";
    if (!validation_wants(v, name)) {
        return;
    }
    const int seeds = validation_is_quick(v) ? SEEDS_QUICK : SEEDS;
    const squares s = over_seeds(v, seeds, error_factor);
    const double spread = sqrt(2. / seeds);
    const uint64_t photons = (uint64_t)seeds * OF_A_SEED;
    const char *why = "a mean of as many squares as seeds";
    validation_check(
        v, name, BY_HAND, is_wrong,
        &(validation_reference){"coverage, mean square in errors", 1, 0},
        (murk_estimate){s.coverage, spread}, photons);
    validation_mark_short(v, why);
    validation_check(
        v, name, BY_HAND, is_wrong,
        &(validation_reference){"fluence rate, mean square in errors", 1, 0},
        (murk_estimate){s.fluence, spread}, photons);
    validation_mark_short(v, why);
}

void cases_coverage(validation *v)
{
    const double cap = share_in_clear_air(2), far = share_in_clear_air(2.6);
    by_hand(v, "one sensor, range 2 m", NULL, 0, 2, 1, cap);
    by_hand(v, "one sensor, range 2.6 m", NULL, 0, 2.6, 1, far);
    by_hand(v, "two sensors, caps apart", NULL, 0, 2, 2, 2 * cap);
    by_hand(v, "fog .5 1/m, range 2.6 m", NULL, .5, 2.6, 1,
            share_in_fog(2.6, .5));
    by_hand(v, "fog .5 1/m, no end of range", NULL, .5, 10, 1,
            share_in_fog(10, .5));
    stated_errors(v, NULL, 1);
    by_hand(v, "one sensor, range 2 m", "range 2.02 m", 0, 2.02, 1, cap);
    by_hand(v, "fog .5 1/m, range 2.6 m", "fog .51 1/m", .51, 2.6, 1,
            share_in_fog(2.6, .5));
    stated_errors(v, "errors twice as large", 2);
}
