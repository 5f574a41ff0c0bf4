/* A context with two threads, messages and progress of its own; a call that is
 * cancelled; a search that would be asked to finish; and a page of results. */
#include "example.h"

#include <string.h>

/* What the functions of the context count. */
typedef struct counts {
    int warnings, steps;
} counts;

static void hear(void *user, bool is_warning, const char *where,
                 const char *text)
{
    counts *seen = user;
    seen->warnings += is_warning;
    fprintf(stderr, "%s: %s\n", where, text);
}

static void show(void *user, const murk_progress *progress)
{
    counts *seen = user;
    seen->steps += progress->total > 0 && progress->done == progress->total;
}

int main(void)
{
    counts seen = {0};
    const murk_context_options options = {.size = sizeof options,
                                          .threads = 2,
                                          .log = hear,
                                          .progress = show,
                                          .user = &seen};
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    must(murk_context_create(&context, &options, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    /* A request to stop, which usually comes from a signal handler or from
     * another thread, ends the next long call. */
    murk_context_cancel(context);
    const murk_status status = murk_light_trace(&light, world, NULL);
    printf("%s\n", murk_status_text(status));
    must(murk_light_trace(&light, world, &error), &error);
    /* Such a handler asks a search for a plan to finish, and cancels what else
     * runs. Here no search runs. */
    if (!murk_context_finish(context)) {
        printf("no search\n");
    }
    must(murk_light_save(light, "results", NULL, NULL, &error), &error);
    must(
        murk_context_write_report(context, "results", NULL, NULL, NULL, &error),
        &error);
    printf("warnings: %d\n", seen.warnings);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * interrupted
 * no search
 * warnings: 0
 */
