/* Coverage where several views of a photon combine, and where transmittance has
 * a threshold: against a plain twin in double precision, and against the plan
 * that placement makes of the same looks. Nothing is random but a fixed
 * seed. */
#include "base/rng.h"
#include "placement/place.h"
#include "sensing/sight.h"
#include "world.h"

#define SURFACE 240
#define VOLUME  160
#define EMITTED 150
#define SENSORS 5
#define PER_M   0.3
#define TAU     0.2

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 8, 4}}};
static const murk_vec3 up = {0, 0, 1}, none = {0, 0, 0};
static const murk_vec3 sensor[SENSORS] = {
    {1, 1, 3}, {2, 6, 3.5}, {5, 4, 3.9}, {9, 1, 2.5}, {9, 7, 3}};

static const struct mode {
    const char *name;
    double threshold;
    murk_combining combining;
    unsigned redundancy;
} modes[] = {
    {"weighted", 0, MURK_COMBINE_CLEAREST, 1},
    {"two clearest", 0, MURK_COMBINE_CLEAREST, 2},
    {"seven clearest", 0, MURK_COMBINE_CLEAREST, 7},
    {"independent", 0, MURK_COMBINE_INDEPENDENT, 1},
    {"threshold", TAU, MURK_COMBINE_CLEAREST, 0},
    {"threshold, two", TAU, MURK_COMBINE_CLEAREST, 2},
    {"threshold, independent", TAU, MURK_COMBINE_INDEPENDENT, 1},
};
#define MODES (sizeof modes / sizeof modes[0])

typedef struct world {
    murk_photon photon[SURFACE + VOLUME];
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *surface_map, *volume_map;
    murk_sight *sight;
} world;

static world *build(const struct mode *mode, double per_m, bool is_balanced)
{
    /* A hall with a floor. */
    world *w = calloc(1, sizeof *w);
    const murk_surface_desc below =
        a_rect(none, murk_vec(10, 0, 0), murk_vec(0, 8, 0), WALL);
    const murk_sensor_type far = all_round(6);
    /* Random records on a level plane, of equal or of different power. */
    for (uint32_t i = 0; i < SURFACE + VOLUME; ++i) {
        const murk_random4 r = murk_random(3, MURK_TEST, i, 0, 0);
        const murk_vec3 p = {10 * r.u[0], 8 * r.u[1], 1};
        w->photon[i] =
            a_photon(p, i < SURFACE ? up : none, (uint32_t)(EMITTED * r.u[2]));
        w->photon[i].power_w = is_balanced ? 0.5f + (float)(i % 7) : 1;
    }
    /* Surfaces, mist or clear air, and both maps. */
    w->surfaces = surfaces_of(&below, 1);
    w->media = per_m > 0 ? mist(&hall, per_m, per_m) : clear_air(&hall);
    w->surface_map = map_of(w->photon, SURFACE);
    w->volume_map = map_of(w->photon + SURFACE, VOLUME);
    /* A sight that combines views in the given mode. */
    const murk_sight_desc desc = {
        .surfaces = w->surfaces,
        .media = w->media,
        .domain = hall,
        .surface_map = w->surface_map,
        .volume_map = w->volume_map,
        .photons_emitted = EMITTED,
        .type = &far,
        .types = 1,
        .weights = {.balanced = is_balanced, .surface = 1, .volume = 1},
        .detection = mode->threshold > 0 ? MURK_DETECTION_THRESHOLD
                                         : MURK_DETECTION_WEIGHTED,
        .threshold = mode->threshold,
        .combining = mode->combining,
        .redundancy = mode->redundancy,
        .threads = 2};
    murk_error err = {0};
    CHECK(murk_sight_create(&w->sight, &desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return w;
}

static void tear_down(world *w)
{
    murk_sight_destroy(w->sight);
    murk_photon_map_destroy(w->surface_map);
    murk_photon_map_destroy(w->volume_map);
    murk_media_destroy(w->media);
    murk_surfaces_destroy(w->surfaces);
    free(w);
}

static murk_coverage_result measure(world *w, const murk_pose *pose, size_t n)
{
    murk_coverage_result c = {0};
    murk_error err = {0};
    CHECK(murk_coverage_result_measure(&c, w->sight, pose, n, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return c;
}

/* ---- the twin ---- */

static double transmittance(const murk_photon *p, murk_vec3 from, double per_m)
{
    const murk_vec3 at = {(double)p->position_m[0], (double)p->position_m[1],
                          (double)p->position_m[2]};
    const double d = murk_length(murk_sub(from, at));
    return d <= 6 ? exp(-per_m * d) : 0;
}

static double seen_of(const struct mode *mode, const murk_photon *p,
                      double per_m)
{
    double through[SENSORS], miss = 1, sum = 0;
    for (int j = 0; j < SENSORS; ++j) {
        through[j] = transmittance(p, sensor[j], per_m);
        if (mode->threshold > 0) { /* none so near that rounding may tell */
            CHECK(fabs(through[j] - mode->threshold) > 1e-5);
            through[j] = through[j] >= mode->threshold ? 1 : 0;
        }
        miss *= 1 - through[j];
    }
    if (mode->combining == MURK_COMBINE_INDEPENDENT) {
        return 1 - miss;
    }
    const unsigned combined = mode->redundancy > 1 ? mode->redundancy : 1;
    for (unsigned k = 0; k < combined && k < SENSORS; ++k) {
        int best = 0;
        for (int j = 1; j < SENSORS; ++j) {
            best = through[j] > through[best] ? j : best;
        }
        sum += through[best];
        through[best] = 0;
    }
    return sum / combined;
}

/* A stored clarity is off by half a unit, and by the step off a surface, far
 * less than that again; a worth of chances is rounded down by one more. */
static double storage_error(const struct mode *mode)
{
    const double unit = 1.0 / MURK_CLEAR;
    return mode->threshold > 0 ? 1e-6 /* of weights */
           : mode->combining == MURK_COMBINE_INDEPENDENT
               ? (SENSORS + 1.2) * unit
               : unit;
}

static void test_against_the_twin(void)
{
    for (size_t k = 0; k < MODES; ++k) {
        const struct mode *mode = &modes[k];
        world *w = build(mode, PER_M, true);
        murk_coverage_result c =
            measure(w, partial_at(sensor, SENSORS), SENSORS);
        double x[2][EMITTED] = {{0}}, y[2][EMITTED] = {{0}}, power[2] = {0, 0};
        double seen_by[SENSORS + 1] = {0};
        for (size_t i = 0; i < SURFACE + VOLUME; ++i) {
            const murk_photon *p = &w->photon[i];
            const double power_w = (double)p->power_w;
            const int m = i >= SURFACE;
            x[m][p->emitted] += power_w * seen_of(mode, p, PER_M);
            y[m][p->emitted] += power_w;
            power[m] += power_w;
        }
        for (size_t i = 0; i < SURFACE + VOLUME; ++i) {
            int by = 0;
            for (int j = 0; j < SENSORS; ++j) {
                const double t = transmittance(&w->photon[i], sensor[j], PER_M);
                by += t > 0 && t >= mode->threshold;
            }
            for (int n = 1; n <= by; ++n) {
                seen_by[n - 1] +=
                    (double)w->photon[i].power_w / power[i >= SURFACE] / 2;
            }
        }
        const murk_estimate want[2] = {
            murk_ratio_estimate(x[0], y[0], EMITTED, EMITTED),
            murk_ratio_estimate(x[1], y[1], EMITTED, EMITTED)};
        double squares = 0, sizes = 0;
        for (int e = 0; e < EMITTED; ++e) {
            double r = 0;
            for (int m = 0; m < 2; ++m) {
                sizes += y[m][e] * y[m][e] / power[m] / power[m];
                r += (x[m][e] - want[m].value * y[m][e]) / power[m] / 2;
            }
            squares += r * r;
        }
        const double error = storage_error(mode), small = error * sqrt(sizes);
        const double total = (want[0].value + want[1].value) / 2;
        CHECK_NEAR(c.total.value, total, error);
        CHECK_NEAR(c.surface.value, want[0].value, error);
        CHECK_NEAR(c.volume.value, want[1].value, error);
        CHECK_NEAR(c.total.standard_error,
                   sqrt((double)EMITTED / (EMITTED - 1) * squares), small);
        CHECK_NEAR(c.surface.standard_error, want[0].standard_error, small);
        CHECK_NEAR(c.volume.standard_error, want[1].standard_error, small);
        for (int n = 0; n < SENSORS; ++n) {
            CHECK_NEAR(c.seen_by_at_least[n], seen_by[n], 1e-6);
        }
        /* Teeth: extinction off by 1 in 1000 is told apart. */
        double off = 0;
        for (size_t i = 0; i < SURFACE + VOLUME && mode->threshold == 0; ++i) {
            off += (double)w->photon[i].power_w / power[i >= SURFACE] / 2 *
                   seen_of(mode, &w->photon[i], PER_M * 1.001);
        }
        CHECK(mode->threshold > 0 || fabs(off - total) > 2 * error);
        murk_coverage_result_release(&c);
        tear_down(w);
    }
}

/* In clear air: min(k, sensors that see it) of k, counted. */
static void test_clear_air_is_a_count(void)
{
    for (size_t k = 0; k < MODES; ++k) {
        const struct mode *mode = &modes[k];
        const unsigned combined = mode->redundancy > 1 ? mode->redundancy : 1;
        world *w = build(mode, 0, false);
        murk_coverage_result c =
            measure(w, partial_at(sensor, SENSORS), SENSORS);
        unsigned count = 0;
        for (size_t i = 0; i < SURFACE + VOLUME; ++i) {
            unsigned by = 0;
            for (int j = 0; j < SENSORS; ++j) {
                by += transmittance(&w->photon[i], sensor[j], 0) > 0;
            }
            count += by < combined ? by : combined;
        }
        /* whole numbers below 2^63, told as a double */
        CHECK_NEAR(c.total.value,
                   (double)count / (combined * (SURFACE + VOLUME)), 0x1p-52);
        murk_coverage_result_release(&c);
        tear_down(w);
    }
}

/* The value of a plan in placement is the coverage that is measured, to the
 * last bit. The coverage by each sensor alone, and the coverage by no other
 * sensor, are differences of such totals. */
static void test_a_plans_value_is_its_coverage(void)
{
    for (size_t k = 0; k < MODES; ++k) {
        /* A plan of three sensors in each mode. */
        world *w = build(&modes[k], PER_M, true);
        const murk_pose *pose = partial_at(sensor, SENSORS);
        murk_sight_problem seen;
        murk_sight_problem_init(&seen, w->sight, pose, SENSORS);
        murk_place_desc desc = murk_place_defaults();
        desc.count = 3;
        murk_place_result plan = {0};
        murk_error err = {0};
        CHECK(murk_place_sensors(&plan, &seen.problem, NULL, &desc, &err) ==
              MURK_OK);
        /* The coverage of the same sensors is the value of the plan. */
        murk_pose chosen[3], others[2];
        for (size_t i = 0; i < 3; ++i) {
            chosen[i] = pose[plan.sensor[i]];
        }
        murk_coverage_result c = measure(w, chosen, 3);
        CHECK(c.total.value == (double)plan.value / (double)plan.whole);
        for (size_t i = 0; i < 3; ++i) {
            /* Coverage by one sensor alone, and loss without this sensor,
             * are differences of such totals. */
            others[0] = chosen[(i + 1) % 3];
            others[1] = chosen[(i + 2) % 3];
            murk_coverage_result alone = measure(w, &chosen[i], 1);
            murk_coverage_result rest = measure(w, others, 2);
            CHECK(c.covers[i] == alone.total.value);
            CHECK_NEAR(c.only_it_covers[i], c.total.value - rest.total.value,
                       1e-15);
            CHECK(c.only_it_covers[i] > 0);
            murk_coverage_result_release(&alone);
            murk_coverage_result_release(&rest);
        }
        murk_coverage_result_release(&c);
        murk_place_release(&plan);
        tear_down(w);
    }
}

static void check_refusal(double threshold, murk_combining combining,
                          unsigned redundancy, const char *where,
                          const char *text)
{
    const struct mode mode = {"", 0, MURK_COMBINE_CLEAREST, 1};
    world *w = build(&mode, 0, true);
    murk_sight_desc desc = *murk_sight_described(w->sight);
    const murk_sensor_type far = all_round(6);
    desc.type = &far;
    desc.detection =
        threshold > 0 ? MURK_DETECTION_THRESHOLD : MURK_DETECTION_WEIGHTED;
    desc.threshold = threshold;
    desc.combining = combining;
    desc.redundancy = redundancy;
    murk_sight *sight = NULL;
    murk_error err = {0};
    CHECK(murk_sight_create(&sight, &desc, &err) == MURK_BAD_VALUE);
    CHECK(sight == NULL);
    CHECK_TEXT(err.where, where);
    CHECK_TEXT(err.text, text);
    tear_down(w);
}

static void test_refusals(void)
{
    check_refusal(NAN, MURK_COMBINE_CLEAREST, 1, "placement.threshold",
                  "nan, must be 0..1");
    check_refusal(1.5, MURK_COMBINE_CLEAREST, 1, "placement.threshold",
                  "1.5, must be 0..1");
    check_refusal(0, MURK_COMBINE_CLEAREST, 17, "placement.redundancy",
                  "17, must be 1..16");
    check_refusal(0, MURK_COMBINE_INDEPENDENT, 2, "placement.redundancy",
                  "2, must be 1..1");
}

int main(void)
{
    test_against_the_twin();
    test_clear_air_is_a_count();
    test_a_plans_value_is_its_coverage();
    test_refusals();
    return check_done();
}
