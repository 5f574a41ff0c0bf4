/* Case follow, light alone: murk_light_update() against murk_light_trace() of
 * the same world. follow-light-moved: the load of the smoke hall moves on by
 * 1 m; follow-light-even: the haze that fills the hall gets denser, so that no
 * photon stays as it was.
 *
 *   bench_update SCENE THREADS PHOTONS PHOTONS_EVEN
 */
#include "times.h"

#include <murk.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A timeline without tracks: photons then start by the rules of a scene that
 * changes. */
#define TIMELINE "{from_s: 0, to_s: 0, every_s: 1}"

#define LOAD "1" /* its number among the items of the geometry */

static void must(murk_status status, const murk_error *error)
{
    if (status) {
        fprintf(stderr, "bench_update: %s: %s\n", error->where, error->text);
        exit(1);
    }
}

static murk_world *world_of(murk_scene *scene)
{
    murk_error error = {.size = sizeof error};
    murk_world *world;
    must(murk_world_create(&world, scene, &error), &error);
    return world;
}

/* The world of step i, for which the caller destroys `before`. */
static murk_world *moved(murk_scene *scene, murk_world *before, int i)
{
    murk_error error = {.size = sizeof error};
    murk_world *world;
    (void)scene;
    must(murk_world_move(&world, before, LOAD, (const double[]){i, 0, 0}, NULL,
                         &error),
         &error);
    return world;
}

static murk_world *denser(murk_scene *scene, murk_world *before, int i)
{
    murk_error error = {.size = sizeof error};
    char text[32];
    (void)before;
    snprintf(text, sizeof text, "%g", .01 + .001 * i);
    must(murk_scene_set(scene, "media.haze.extinction_per_m", text, &error),
         &error);
    return world_of(scene);
}

/* The first update traces all photons and notes their paths, so it is not
 * timed. */
static void bench(const char *name, murk_scene *scene, unsigned threads,
                  const char *photons,
                  murk_world *(*step)(murk_scene *, murk_world *, int))
{
    murk_error error = {.size = sizeof error};
    murk_light *light = NULL;
    bench_times ours = {0}, theirs = {0};
    must(murk_scene_set(scene, "photons.emit", photons, &error), &error);
    murk_world *world = world_of(scene);
    must(murk_light_trace(&light, world, &error), &error);
    /* Each step from the one before, beside a trace of its world. */
    for (int i = -1; i < BENCH_REPEATS; ++i) {
        murk_world *next = step(scene, world, i + 2);
        murk_light *updated, *traced;
        bench_moment begun = bench_now();
        must(murk_light_update(&updated, light, next, &error), &error);
        if (i >= 0) {
            bench_add(&ours, i, begun);
            begun = bench_now();
            must(murk_light_trace(&traced, next, &error), &error);
            bench_add(&theirs, i, begun);
            murk_light_destroy(traced);
        }
        murk_light_destroy(light);
        murk_world_destroy(world);
        light = updated;
        world = next;
    }
    murk_light_destroy(light);
    murk_world_destroy(world);
    bench_print(&(bench_row){.name = name,
                             .unit = "s",
                             .reference = "murk_light_trace()",
                             .threads = threads,
                             .ours = &ours,
                             .theirs = &theirs});
}

int main(int argc, char **argv)
{
    if (argc != 5) {
        fprintf(stderr, "usage: bench_update SCENE THREADS PHOTONS "
                        "PHOTONS_EVEN\n");
        return 2;
    }
    murk_error error = {.size = sizeof error};
    murk_context *context;
    murk_scene *scene;
    const unsigned threads = (unsigned)atoi(argv[2]);
    const murk_context_options options = {.size = sizeof options,
                                          .threads = threads};
    must(murk_context_create(&context, &options, &error), &error);
    must(murk_scene_read(&scene, context, argv[1], &error), &error);
    must(murk_scene_set(scene, "timeline", TIMELINE, &error), &error);
    bench("follow-light-moved", scene, threads, argv[3], moved);
    bench("follow-light-even", scene, threads, argv[4], denser);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}
