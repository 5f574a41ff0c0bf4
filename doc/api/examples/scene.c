/* Scenes from text, from a file and from keys; their values, and the place of
 * an error. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL, *empty = NULL, *read = NULL;
    const char *value = NULL, *text = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    /* Text, and a key that is changed. */
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_scene_set(scene, "media.fog.extinction_per_m", "0.2", &error),
         &error);
    must(murk_scene_get(scene, "media.fog.extinction_per_m", &value, &error),
         &error);
    printf("extinction_per_m: %s\n", value);
    /* The resolved scene as a file, which is read again. */
    must(murk_scene_resolved(scene, &text, &error), &error);
    FILE *file = fopen("resolved.yaml", "w");
    if (!file || fputs(text, file) < 0 || fclose(file) != 0) {
        return 1;
    }
    must(murk_scene_read(&read, context, "resolved.yaml", &error), &error);
    must(murk_scene_check(read, &error), &error);
    /* A wrong value is found by the check of the whole scene. */
    must(murk_scene_set(read, "photons.emit", "many", &error), &error);
    const murk_status status = murk_scene_check(read, &error);
    printf("%s at %s\n", murk_status_text(status), error.key);
    /* A scene of keys alone. */
    must(murk_scene_create(&empty, context, &error), &error);
    must(murk_scene_set(empty, "seed", "7", &error), &error);
    murk_scene_destroy(empty);
    murk_scene_destroy(read);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * extinction_per_m: 0.2
 * a key, a value or an argument is not allowed at photons.emit
 */
