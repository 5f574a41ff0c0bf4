/* A world: the box of the domain, the bands, a look over all that is in it, and
 * the events of one photon. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    double bounds_m[6];
    murk_world_bounds(world, bounds_m);
    printf("%g x %g x %g m\n", bounds_m[3] - bounds_m[0],
           bounds_m[4] - bounds_m[1], bounds_m[5] - bounds_m[2]);
    for (int i = 0; i < murk_world_bands(world); ++i) {
        printf("band %d: %g nm\n", i, murk_world_band_nm(world, i));
    }
    /* What is in the world, and what a run will take. */
    const murk_check_options check = {.size = sizeof check,
                                      .picture = "room.png"};
    const murk_fields *facts = NULL;
    double area_m2 = 0, usable = 0, emitted = 0;
    must(murk_world_check(world, &check, NULL, &facts, &error), &error);
    must(murk_fields_double(facts, "surfaces.area_m2", &area_m2, &error),
         &error);
    must(murk_fields_double(facts, "candidates.usable", &usable, &error),
         &error);
    must(murk_fields_double(facts, "forecast.emitted", &emitted, &error),
         &error);
    printf("%g m2, %g places for sensors, %g photons\n", area_m2, usable,
           emitted);
    /* The path of photon 1. */
    const murk_fields *replay = NULL;
    must(murk_world_replay(world, 1, NULL, &replay, &error), &error);
    for (size_t i = 0; i < murk_fields_length(replay, "events"); ++i) {
        char path[64];
        const char *kind = NULL;
        double path_m = 0;
        snprintf(path, sizeof path, "events.%zu.kind", i);
        must(murk_fields_string(replay, path, &kind, &error), &error);
        snprintf(path, sizeof path, "events.%zu.path_m", i);
        must(murk_fields_double(replay, path, &path_m, &error), &error);
        printf("%s after %.2f m\n", kind, path_m);
    }
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * 8 x 6 x 3 m
 * band 0: 532 nm
 * 180 m2, 24 places for sensors, 20000 photons
 * emitted after 0.00 m
 * surface after 0.20 m
 * surface after 4.49 m
 * medium after 2.97 m
 * surface after 1.57 m
 */
