/* Lists of sensors, one by one and from a file. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_sensors *sensors = NULL, *read = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    /* Two sensors, one by one; and a list from a file. */
    const murk_sensor west = {
        .size = sizeof west, .type = "node", .position_m = {1, 3, 2}};
    murk_sensor east = west;
    east.position_m[0] = 7;
    must(murk_sensors_create(&sensors, world, &error), &error);
    must(murk_sensors_add(sensors, &west, &error), &error);
    must(murk_sensors_add(sensors, &east, &error), &error);
    FILE *file = fopen("sensors.csv", "w");
    if (!file || fputs("type,x_m,y_m,z_m\nnode,4,3,2\n", file) < 0 ||
        fclose(file) != 0) {
        return 1;
    }
    must(murk_sensors_read(&read, world, "sensors.csv", &error), &error);
    murk_sensor third = {.size = sizeof third};
    must(murk_sensors_get(read, 0, &third, &error), &error);
    printf("%s at %g %g %g\n", third.type, third.position_m[0],
           third.position_m[1], third.position_m[2]);
    must(murk_sensors_add(sensors, &third, &error), &error);
    printf("%zu sensors\n", murk_sensors_count(sensors));
    murk_sensors_destroy(read);
    murk_sensors_destroy(sensors);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * node at 4 3 2
 * 3 sensors
 */
