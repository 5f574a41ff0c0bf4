/* Coverage by photons that are tested while they are traced and not stored,
 * against that of the same photons in maps: all values but those that need the
 * rows, for photons by `emit` and by `store`, several chunks of records,
 * weights, redundancy and at_least. Sums of power are added in another order,
 * so values may differ by rounding: of sums of 1e6 doubles by less than 1e6
 * times 2^-53 of the value, and of whole-number weights by one unit in 2^20.
 * The results are the same bits for any number of threads. */
#include "check.h"
#include "plan/plan.h"
#include "stage_text.h"

#include <string.h>

#define ROUNDING (1e6 * 0x1p-53)

static const char scene_text[] =
    "murk: 1\n"
    "bands_nm: [450, 650]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry: [{box: {min_m: [0.01, 0.01, 0.01], max_m: [3.99, 3.99, 2.99]},"
    " material: wall}, {box: {min_m: [2, 0, 0], max_m: [2.1, 3, 2.5]}, "
    "material: wall}]\n"
    "materials: {wall: {diffuse: [0.5, 0.7]}}\n"
    "media: {fog: {extinction_per_m: [0.3, 0.4], albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 2.5], power_w: [8, 3]}\n"
    "  - {type: point, position_m: [3, 3, 2.5], power_w: [1, 2]}\n"
    "photons: {emit: 80000}\n"
    "sensors: {types: [{name: node, range_m: 3}], candidates: {}, count: 1}\n";

enum { SENSORS = 3 };
static const murk_pose sensor[SENSORS] = {{.position = {1, 1, 1}},
                                          {.position = {3, 2, 2}},
                                          {.position = {1.5, 3.5, 0.5}}};

static murk_coverage_result streamed(const murk_stage *stage, size_t expected,
                                     unsigned threads)
{
    murk_error err = {0};
    murk_coverage_result out = {0};
    double trace_s = 0;
    CHECK(murk_plan_measure_streamed(
              &out, &trace_s, stage, MURK_HELD_OUT_STREAM, sensor, SENSORS,
              expected, NULL, NULL, threads, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    CHECK(trace_s > 0);
    return out;
}

static murk_coverage_result stored(const murk_stage *stage, size_t *photons)
{
    murk_error err = {0};
    murk_coverage_result out = {0};
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    CHECK(murk_plan_trace_stream(&traced, stage, MURK_HELD_OUT_STREAM, 2,
                                 &err) == MURK_OK);
    CHECK(murk_plan_sight(&sight, stage, traced, 2, &err) == MURK_OK);
    CHECK(murk_coverage_result_measure(&out, sight, sensor, SENSORS, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    *photons = murk_sight_photons(sight);
    murk_sight_destroy(sight);
    murk_traced_destroy(traced);
    return out;
}

static void near(double a, double b)
{
    CHECK_NEAR(a, b, 0x1p-20 * fabs(b) * 1e-3 + ROUNDING * fabs(b));
}

static void near_both(murk_estimate a, murk_estimate b)
{
    if (!isnan(b.value)) {
        near(a.value, b.value);
        near(a.standard_error, b.standard_error);
    } else {
        CHECK(isnan(a.value) && isnan(a.standard_error));
    }
}

static void compare(const char *one, const char *two)
{
    const char *const overrides[] = {one, two, NULL};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    CHECK(murk_plan_can_stream(stage));
    size_t photons = 0;
    murk_coverage_result a = streamed(stage, 0, 1), b = stored(stage, &photons),
                         c = streamed(stage, 500000, 3);
    /* Several chunks. */
    CHECK(photons > 150000);
    CHECK(a.total.value > 0.1 && a.total.value < 0.9);
    near_both(a.total, b.total);
    near_both(a.surface, b.surface);
    near_both(a.volume, b.volume);
    near_both(a.at_least, b.at_least);
    for (int p = 0; p < 2; ++p) {
        CHECK(a.map[p].photons == b.map[p].photons);
        near(a.map[p].weight, b.map[p].weight);
        near(a.map[p].standard_error, b.map[p].standard_error);
    }
    for (size_t k = 0; k < SENSORS; ++k) {
        near(a.only_it_covers[k], b.only_it_covers[k]);
        near(a.seen_by_at_least[k], b.seen_by_at_least[k]);
        CHECK(a.only_it_covers[k] == c.only_it_covers[k]);
        CHECK(isnan(a.covers[k]));
    }
    /* Threads. */
    CHECK(memcmp(&a.total, &c.total, sizeof a.total) == 0);
    CHECK(memcmp(&a.surface, &c.surface, sizeof a.surface) == 0);
    CHECK(memcmp(&a.volume, &c.volume, sizeof a.volume) == 0);
    CHECK(memcmp(a.map, c.map, sizeof a.map) == 0);
    murk_coverage_result_release(&a);
    murk_coverage_result_release(&b);
    murk_coverage_result_release(&c);
    stage_text_destroy(stage);
}

static void expect_maps(const char *one, const char *two)
{
    const char *const overrides[] = {one, two, NULL};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    CHECK(!murk_plan_can_stream(stage));
    stage_text_destroy(stage);
}

int main(void)
{
    compare(NULL, NULL);
    compare("photons.store=200000", NULL);
    compare("placement.redundancy=2",
            "placement.weights={surface: 1, volume: 2}");
    compare("sensors={types: [{name: node, range_m: 3}], candidates: {}, "
            "target: 0.5}",
            "placement.at_least=2");
    compare("photons.store_when=hit", NULL);
    /* All that needs the photons themselves has maps. */
    expect_maps("placement.detection=independent", NULL);
    expect_maps("placement.targets={surfaces: {points: 100}}", NULL);
    expect_maps("placement.interest=[{name: a, weight: 2, box: {min_m: [0, 0, "
                "0], max_m: [1, 1, 1]}}]",
                NULL);
    return check_done();
}
