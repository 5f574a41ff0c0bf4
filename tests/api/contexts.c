/* Three contexts in three threads, side by side. Each has its own progress and
 * its own request to stop: one is cancelled, and the two others get the results
 * that one context alone gets. Then a context whose search for a plan is asked
 * to finish. */
#include "checks.h"

#include <pthread.h>
#include <string.h>

/* A lamp in fog, with places for two sensors. */
static const char fog[] =
    "murk: 1\n"
    "bands_nm: [532]\n"
    "domain: {min_m: [0, 0, 0], max_m: [10, 10, 5]}\n"
    "media: {fog: {extinction_per_m: 0.2, albedo: 0.9, phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [5, 5, 4], power_w: 10}]\n"
    "photons: {emit: 60000}\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 6}]\n"
    "  candidates: {grid: {min_m: [1, 1, 1], max_m: [9, 9, 4], "
    "size: [5, 5, 2]}}\n"
    "  count: 2\n";

typedef struct job {
    unsigned threads;
    int steps; /* calls of progress */
    char *json;
} job;

static void progress(void *user, const murk_progress *state)
{
    job *j = user;
    CHECK(state->size == sizeof *state && state->step[0]);
    CHECK(state->total == 0 || state->done <= state->total);
    ++j->steps;
}

/* The whole chain, in a context of its own; the plan's JSON. */
static void *plan(void *argument)
{
    job *j = argument;
    const murk_context_options options = {.size = sizeof options,
                                          .threads = j->threads,
                                          .progress = progress,
                                          .user = j};
    /* One handle after the other, down to the plan. */
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_plan *made = NULL;
    const murk_fields *fields = NULL;
    CHECK(murk_context_create(&context, &options, &error) == MURK_OK);
    CHECK(murk_scene_parse(&scene, context, fog, "fog.yaml", &error) ==
          MURK_OK);
    CHECK(murk_world_create(&world, scene, &error) == MURK_OK);
    CHECK(murk_plan_make(&made, world, &error) == MURK_OK);
    CHECK(murk_plan_fields(made, &fields, &error) == MURK_OK);
    j->json = strdup(murk_fields_json(fields));
    CHECK(j->json);
    murk_plan_destroy(made);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return NULL;
}

/* A context that is cancelled while the other one works. */
static void *cancelled(void *argument)
{
    murk_context *context = argument;
    murk_error error = MURK_ERROR_NONE;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    CHECK(murk_scene_parse(&scene, context, fog, NULL, &error) == MURK_OK);
    CHECK(murk_scene_set(scene, "photons.emit", "4000000000", &error) ==
          MURK_OK);
    CHECK(murk_scene_set(scene, "photons.maps", "none", &error) == MURK_OK);
    CHECK(murk_world_create(&world, scene, &error) == MURK_OK);
    CHECK(murk_light_trace(&light, world, &error) == MURK_INTERRUPTED);
    CHECK(!light && error.code == MURK_INTERRUPTED);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    return NULL;
}

/* What a caller that asks the search to finish has seen. */
typedef struct asking {
    murk_context *context;
    int taken, refused;
} asking;

/* Asks at each call: the request is taken once, and only by the search. */
static void ask_to_finish(void *user, const murk_progress *state)
{
    asking *a = user;
    const bool is_search = !strcmp(state->step, "place");
    const bool is_taken = murk_context_finish(a->context);
    CHECK(!is_taken || (is_search || !strcmp(state->step, "weigh")));
    CHECK(!is_taken || a->taken == 0);
    a->taken += is_taken;
    a->refused += !is_taken;
}

/* A search that would take some minutes is asked to finish, and the call gives
 * a plan of the wanted number that says so. */
static void check_finish(void)
{
    asking a = {0};
    const murk_context_options options = {
        .size = sizeof options, .progress = ask_to_finish, .user = &a};
    murk_error error = MURK_ERROR_NONE;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_plan *made = NULL;
    const murk_fields *fields = NULL;
    const char *cut_by = NULL;
    /* Without a search there is nothing to finish. */
    CHECK(!murk_context_finish(NULL));
    CHECK(murk_context_create(&a.context, &options, &error) == MURK_OK);
    CHECK(!murk_context_finish(a.context));
    CHECK(murk_scene_parse(&scene, a.context, fog, "fog.yaml", &error) ==
          MURK_OK);
    CHECK(murk_scene_set(scene, "sensors.count", "12", &error) == MURK_OK);
    CHECK(murk_scene_set(scene, "placement.detection", "independent", &error) ==
          MURK_OK);
    CHECK(murk_scene_set(scene, "placement.nodes", "1e15", &error) == MURK_OK);
    CHECK(murk_world_create(&world, scene, &error) == MURK_OK);
    CHECK(murk_plan_make(&made, world, &error) == MURK_OK);
    /* The plan is whole and marked. */
    CHECK(a.taken == 1 && a.refused > 1);
    CHECK(murk_plan_fields(made, &fields, &error) == MURK_OK);
    CHECK(murk_fields_length(fields, "sensors") == 12);
    CHECK(murk_fields_string(fields, "placement.cut_by", &cut_by, &error) ==
          MURK_OK);
    CHECK(cut_by && !strcmp(cut_by, "interrupt"));
    CHECK(!murk_context_finish(a.context));
    murk_plan_destroy(made);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(a.context);
}

int main(void)
{
    job alone = {.threads = 2}, first = {.threads = 1}, second = {.threads = 2};
    pthread_t thread[3];
    murk_context *stopped = NULL;
    (void)plan(&alone);
    CHECK(murk_context_create(&stopped, NULL, NULL) == MURK_OK);
    CHECK(pthread_create(&thread[0], NULL, plan, &first) == 0);
    CHECK(pthread_create(&thread[1], NULL, plan, &second) == 0);
    CHECK(pthread_create(&thread[2], NULL, cancelled, stopped) == 0);
    CHECK(pthread_join(thread[0], NULL) == 0);
    CHECK(pthread_join(thread[1], NULL) == 0);
    murk_context_cancel(stopped);
    CHECK(pthread_join(thread[2], NULL) == 0);
    murk_context_destroy(stopped);
    CHECK(strcmp(alone.json, first.json) == 0);
    CHECK(strcmp(alone.json, second.json) == 0);
    CHECK(first.steps > 0 && second.steps > 0);
    free(alone.json);
    free(first.json);
    free(second.json);
    check_finish();
    return 0;
}
