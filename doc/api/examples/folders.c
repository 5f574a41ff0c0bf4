/* A folder of results: what would be refused, the files and their names, and
 * the light of the folder for a scene of another seed. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_scene_set(scene, "seed", "7", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    /* Wrong options are found before any light is traced. */
    murk_save_options options = {.size = sizeof options, .exports = "clouds"};
    murk_error why = MURK_ERROR_NONE;
    const murk_status status =
        murk_world_check_save(world, "trace", 0, "results", &options, &why);
    printf("%s at %s\n", murk_status_text(status), why.where);
    /* The files of murk trace, and their names. */
    const murk_fields *fields = NULL;
    options.exports = NULL;
    must(murk_world_check_save(world, "trace", 0, "results", &options, &error),
         &error);
    must(murk_light_trace(&light, world, &error), &error);
    must(murk_light_save(light, "results", &options, &fields, &error), &error);
    for (size_t i = 0; i < murk_fields_length(fields, "saved.files"); ++i) {
        char path[64];
        const char *name = NULL;
        snprintf(path, sizeof path, "saved.files.%zu", i);
        must(murk_fields_string(fields, path, &name, &error), &error);
        printf("%s\n", name);
    }
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    /* A scene takes over the seed of the light in the folder. */
    const char *seed = NULL;
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_scene_use_light(scene, "results/light.murk", &error), &error);
    must(murk_scene_get(scene, "seed", &seed, &error), &error);
    printf("seed: %s\n", seed);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * a key, a value or an argument is not allowed at exports
 * light.murk
 * scene.resolved.yaml
 * tallies.csv
 * box.vdb
 * box_error.vdb
 * ledger.json
 * seed: 7
 */
