/* The progress that a context tells: the steps of a plan and of a coverage
 * count all that they do. A receiver is told about the end of each outermost
 * step, whatever the speed of the machine. */
#include "check.h"
#include "murk.h"

#include <stdio.h>
#include <string.h>

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}\n"
    "geometry: [{box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}]\n"
    "materials: {default: {diffuse: 0.5}}\n"
    "media: {fog: {extinction_per_m: 0.2, albedo: 0.9, phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [2, 3, 2], power_w: 2}]\n"
    "photons: {emit: 20000}\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 3}]\n"
    "  candidates: {grid: {min_m: [1, 1, 1], max_m: [7, 5, 2],"
    " size: [2, 2, 1]}}\n"
    "  count: 2\n";

#define STEPS_MAX 64

/* The last state of each outermost step, in order. */
typedef struct steps {
    struct {
        char name[32], unit[32];
        uint64_t done, total;
    } step[STEPS_MAX];
    size_t n;
} steps;

static void hear(void *user, const murk_progress *p)
{
    steps *s = user;
    const bool is_same = s->n > 0 &&
                         strcmp(s->step[s->n - 1].name, p->step) == 0 &&
                         p->done >= s->step[s->n - 1].done;
    s->n += !is_same && s->n < STEPS_MAX;
    snprintf(s->step[s->n - 1].name, sizeof s->step[0].name, "%s", p->step);
    snprintf(s->step[s->n - 1].unit, sizeof s->step[0].unit, "%s", p->unit);
    s->step[s->n - 1].done = p->done;
    s->step[s->n - 1].total = p->total;
}

/* Checks that a step of that name was told with this state. Of a step inside of
 * another one the end is not always told. */
static void check_reported(const steps *s, const char *name, const char *unit,
                           uint64_t done, uint64_t total)
{
    bool is_found = false;
    for (size_t i = 0; i < s->n; ++i) {
        is_found |= strcmp(s->step[i].name, name) == 0 &&
                    strcmp(s->step[i].unit, unit) == 0 &&
                    s->step[i].done == done && s->step[i].total == total;
    }
    CHECK(is_found);
    for (size_t i = 0; !is_found && i < s->n; ++i) {
        printf("%s %llu of %llu %s\n", s->step[i].name,
               (unsigned long long)s->step[i].done,
               (unsigned long long)s->step[i].total, s->step[i].unit);
    }
}

static murk_world *make_world(murk_context *context, const char *const *keys,
                              const char *const *values, size_t n)
{
    murk_error error = MURK_ERROR_NONE;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    CHECK(!murk_scene_parse(&scene, context, scene_text, "room", &error));
    for (size_t i = 0; i < n; ++i) {
        CHECK(!murk_scene_set(scene, keys[i], values[i], &error));
    }
    CHECK(!murk_world_create(&world, scene, &error));
    if (error.code) {
        printf("%s: %s\n", error.where, error.text);
    }
    murk_scene_destroy(scene);
    return world;
}

/* Held-out light of `lights` conditions, after the light that chose the
 * plan. */
static void test_a_plan_with_held_out_light(const char *const *keys,
                                            const char *const *values, size_t n,
                                            uint64_t lights)
{
    steps s = {0};
    const murk_context_options options = {
        .size = sizeof options, .threads = 2, .progress = hear, .user = &s};
    murk_context *context = NULL;
    murk_plan *plan = NULL;
    CHECK(!murk_context_create(&context, &options, NULL));
    murk_world *world = make_world(context, keys, values, n);
    CHECK(!murk_plan_make(&plan, world, NULL));
    check_reported(&s, "trace", "photons", 20000, 20000);
    check_reported(&s, "maps", "maps", 2, 2);
    check_reported(&s, "sense", "sensors", 2, 2);
    check_reported(&s, "hold out", "lights", lights, 0);
    murk_plan_destroy(plan);
    murk_world_destroy(world);
    murk_context_destroy(context);
}

/* In two passes over the sensors, which detection probabilities need. */
static void test_coverage_in_two_passes(void)
{
    static const char *const keys[] = {"placement.detection"},
                             *const values[] = {"independent"};
    steps s = {0};
    const murk_context_options options = {
        .size = sizeof options, .progress = hear, .user = &s};
    const murk_sensor node = {
        .size = sizeof node, .type = "node", .position_m = {3, 3, 1}};
    murk_context *context = NULL;
    murk_light *light = NULL;
    murk_sensors *sensors = NULL;
    murk_coverage *coverage = NULL;
    CHECK(!murk_context_create(&context, &options, NULL));
    murk_world *world = make_world(context, keys, values, 1);
    CHECK(!murk_light_trace(&light, world, NULL));
    CHECK(!murk_sensors_create(&sensors, world, NULL));
    /* Three sensors, each of which is looked from twice. */
    for (int i = 0; i < 3; ++i) {
        CHECK(!murk_sensors_add(sensors, &node, NULL));
    }
    CHECK(!murk_coverage_measure(&coverage, light, sensors, NULL));
    check_reported(&s, "sense", "sensors", 6, 6);
    murk_coverage_destroy(coverage);
    murk_sensors_destroy(sensors);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_context_destroy(context);
}

int main(void)
{
    static const char *const keys[] = {"conditions", "placement.over"},
                             *const values[] = {
                                 "{clear: {media.fog.extinction_per_m: 0.01},"
                                 " thick: {media.fog.extinction_per_m: 0.4}}",
                                 "mean"};
    test_a_plan_with_held_out_light(NULL, NULL, 0, 1);
    test_a_plan_with_held_out_light(keys, values, 2, 2);
    test_coverage_in_two_passes();
    return check_done();
}
