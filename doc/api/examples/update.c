/* A box on the floor of the room moves away from the lamp: light, coverage and
 * plan are updated from step to step. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    murk_plan *plan = NULL;
    murk_sensors *sensors = NULL;
    murk_coverage *coverage = NULL;
    const murk_fields *fields = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room", &error), &error);
    must(murk_scene_set(scene, "geometry",
                        "[{box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}, "
                        "{name: crate, box: {min_m: [0, 0, 0], "
                        "max_m: [1, 1, 1]}, translate_m: [2, 2, 0.1]}]",
                        &error),
         &error);
    must(murk_world_create(&world, scene, &error), &error);
    must(murk_light_trace(&light, world, &error), &error);
    must(murk_plan_for_light(&plan, light, &error), &error);
    must(murk_plan_sensors(&sensors, plan, &error), &error);
    must(murk_coverage_measure(&coverage, light, sensors, &error), &error);
    for (int step = 1; step <= 3; ++step) {
        const double place[3] = {2 + step, 2, 0.1};
        murk_world *moved = NULL;
        murk_light *lit = NULL;
        murk_coverage *seen = NULL;
        murk_plan *next = NULL;
        double kept = 0, planned = 0;
        must(murk_world_move(&moved, world, "crate", place, NULL, &error),
             &error);
        must(murk_light_update(&lit, light, moved, &error), &error);
        must(murk_coverage_update(&seen, coverage, lit, &error), &error);
        must(murk_plan_update(&next, plan, lit, &error), &error);
        must(murk_coverage_fields(seen, &fields, &error), &error);
        must(murk_fields_double(fields, "coverage.in_sample", &kept, &error),
             &error);
        must(murk_plan_fields(next, &fields, &error), &error);
        must(murk_fields_double(fields, "coverage.in_sample", &planned, &error),
             &error);
        printf("%d m: %.1f with the first sensors, %s\n", step, kept,
               planned >= kept ? "no less after an update" : "less");
        /* The next step begins here. */
        murk_coverage_destroy(seen);
        murk_plan_destroy(plan);
        murk_light_destroy(light);
        murk_world_destroy(world);
        world = moved;
        light = lit;
        plan = next;
    }
    murk_coverage_destroy(coverage);
    murk_sensors_destroy(sensors);
    murk_plan_destroy(plan);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * 1 m: 0.8 with the first sensors, no less after an update
 * 2 m: 0.8 with the first sensors, no less after an update
 * 3 m: 0.8 with the first sensors, no less after an update
 */
