/* What a sensor of the program sees of traced light: the coverage and its
 * error, and the row of the coverage matrix. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    murk_sensors *sensors = NULL;
    murk_coverage *coverage = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    must(murk_light_trace(&light, world, &error), &error);
    const murk_sensor node = {
        .size = sizeof node, .type = "node", .position_m = {1, 3, 2}};
    must(murk_sensors_create(&sensors, world, &error), &error);
    must(murk_sensors_add(sensors, &node, &error), &error);
    must(murk_coverage_measure(&coverage, light, sensors, &error), &error);
    /* The share of the light that the sensor sees, by name. */
    const murk_fields *fields = NULL;
    double share = 0, share_error = 0;
    must(murk_coverage_fields(coverage, &fields, &error), &error);
    must(murk_fields_double(fields, "coverage.in_sample", &share, &error),
         &error);
    must(murk_fields_double(fields, "coverage.standard_error", &share_error,
                            &error),
         &error);
    printf("coverage %.1f, known to 1 %%: %s\n", share,
           share_error < 0.01 ? "yes" : "no");
    /* Element (i, k) of the matrix is the clarity of record k for sensor i. */
    murk_array matrix = {.size = sizeof matrix};
    must(murk_coverage_matrix(coverage, &matrix, &error), &error);
    const uint16_t *row = matrix.data;
    size_t seen = 0;
    for (size_t k = 0; k < matrix.shape[1]; ++k) {
        seen += row[k] > 0;
    }
    printf("a row of the matrix; some records are seen: %s\n",
           seen > 0 && seen < matrix.shape[1] ? "yes" : "no");
    must(murk_coverage_save(coverage, "results", NULL, NULL, &error), &error);
    murk_coverage_destroy(coverage);
    murk_sensors_destroy(sensors);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * coverage 0.6, known to 1 %: yes
 * a row of the matrix; some records are seen: yes
 */
