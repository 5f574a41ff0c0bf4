/* The library as a program of a user calls it: reads a scene, traces its light,
 * and writes no file.
 *
 *   bench_library SCENE THREADS KEY=VALUE...
 *
 * Prints ledger.json's fields, as `murk trace --format json` does. */
#include <murk.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void must(murk_status status, const murk_error *error)
{
    if (status) {
        fprintf(stderr, "bench_library: %s: %s\n", error->where, error->text);
        exit(1);
    }
}

int main(int argc, char **argv)
{
    if (argc < 3) {
        fprintf(stderr, "usage: bench_library SCENE THREADS KEY=VALUE...\n");
        return 2;
    }
    /* The scene, with the keys of the command line. */
    murk_error error = {.size = sizeof error};
    murk_context *context;
    murk_scene *scene;
    murk_world *world;
    murk_light *light;
    const murk_fields *fields;
    const murk_context_options options = {.size = sizeof options,
                                          .threads = (unsigned)atoi(argv[2])};
    must(murk_context_create(&context, &options, &error), &error);
    must(murk_scene_read(&scene, context, argv[1], &error), &error);
    for (int i = 3; i < argc; ++i) {
        char *value = strchr(argv[i], '=');
        if (!value) {
            fprintf(stderr, "bench_library: %s is not KEY=VALUE\n", argv[i]);
            return 2;
        }
        *value++ = '\0';
        must(murk_scene_set(scene, argv[i], value, &error), &error);
    }
    /* Trace, and print the ledger. */
    must(murk_world_create(&world, scene, &error), &error);
    must(murk_light_trace(&light, world, &error), &error);
    must(murk_light_fields(light, &fields, &error), &error);
    puts(murk_fields_json(fields));
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}
