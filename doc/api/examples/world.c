/* A world: the box of the domain and the bands. */
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
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * 8 x 6 x 3 m
 * band 0: 532 nm
 */
