/* The best places of two sensors, for light that was traced before, with other
 * seeds, in parts, too; and the best columns of a coverage matrix. */
#include "example.h"

/* Chooses two of three columns of a matrix in memory. */
static void choose_columns(murk_context *context)
{
    static const char *const columns[] = {"north", "middle", "south"};
    static const double clarity[] = {1, .5, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
    const size_t shape[] = {4, 3};
    const murk_array rows = murk_array_of(clarity, MURK_TYPE_FLOAT64, 2, shape);
    murk_error error = MURK_ERROR_NONE;
    murk_scene *keys = NULL;
    murk_plan *plan = NULL;
    const murk_fields *fields = NULL;
    const char *first = NULL, *second = NULL;
    must(murk_scene_create(&keys, context, &error), &error);
    must(murk_scene_set(keys, "sensors.count", "2", &error), &error);
    must(murk_scene_add_table(keys, "views", columns, &rows, &error), &error);
    must(murk_plan_for_matrix(&plan, keys, "memory:views", NULL, NULL, &error),
         &error);
    must(murk_plan_fields(plan, &fields, &error), &error);
    must(murk_fields_string(fields, "sensors.0.name", &first, &error), &error);
    must(murk_fields_string(fields, "sensors.1.name", &second, &error), &error);
    printf("columns: %s, %s\n", first, second);
    murk_plan_destroy(plan);
    murk_scene_destroy(keys);
}

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    murk_plan *plan = NULL, *same = NULL;
    murk_sensors *sensors = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    must(murk_light_trace(&light, world, &error), &error);
    must(murk_plan_for_light(&plan, light, &error), &error);
    /* The sensors, and the share of the light that they see. */
    const murk_fields *fields = NULL;
    double share = 0, again = 0;
    must(murk_plan_sensors(&sensors, plan, &error), &error);
    must(murk_plan_fields(plan, &fields, &error), &error);
    must(murk_fields_double(fields, "coverage.in_sample", &share, &error),
         &error);
    printf("%zu sensors, more than half of the light: %s\n",
           murk_sensors_count(sensors), share > 0.5 ? "yes" : "no");
    /* The same job with the next seed, and the files of murk place. */
    must(murk_plan_repeat(plan, 2, &error), &error);
    must(murk_plan_save(plan, "results", NULL, &fields, &error), &error);
    int64_t runs = 0;
    must(murk_fields_int64(fields, "repeat.runs", &runs, &error), &error);
    printf("runs: %d\n", (int)runs);
    /* One call that traces and places gives the same plan. */
    must(murk_plan_make(&same, world, &error), &error);
    must(murk_plan_fields(same, &fields, &error), &error);
    must(murk_fields_double(fields, "coverage.in_sample", &again, &error),
         &error);
    printf("equal: %s\n", again == share ? "yes" : "no");
    /* The other seeds in two parts, as two machines would run them. */
    static const char *const part[] = {"1.part", "2.part"};
    must(murk_plan_repeat_part(same, 4, 1, 2, part[0], &error), &error);
    must(murk_plan_repeat_part(same, 4, 2, 2, part[1], &error), &error);
    must(murk_plan_repeat_merge(same, 4, part, 2, &error), &error);
    must(murk_plan_fields(same, &fields, &error), &error);
    must(murk_fields_int64(fields, "repeat.runs", &runs, &error), &error);
    printf("runs of parts: %d\n", (int)runs);
    choose_columns(context);
    murk_plan_destroy(same);
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
 * 2 sensors, more than half of the light: yes
 * runs: 2
 * equal: yes
 * runs of parts: 4
 * columns: north, south
 */
