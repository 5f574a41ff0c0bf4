/* Plans through murk.h in ranks: a context of a thread that belongs to a rank
 * divides its work with the contexts of the other ranks, and all have the
 * fields of a plan of one rank. An exchange that loses a rank's
 * sums is noticed. Seeds are fixed. */
#include "check.h"
#include "murk.h"
#include "thread_ranks.h"

#include <stdlib.h>
#include <string.h>

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}\n"
    "geometry: [{box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}]\n"
    "materials: {default: {diffuse: 0.5}}\n"
    "media: {fog: {extinction_per_m: 0.2, albedo: 0.9, phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [2, 3, 2], power_w: 2}]\n"
    "photons: {emit: 3000}\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 3}]\n"
    "  candidates: {grid: {min_m: [1, 1, 1], max_m: [7, 5, 2],"
    " size: [4, 3, 2]}}\n"
    "  count: 2\n";

static const char *const known[] = {"placement.knowledge", "known"};
static const char *const unknown[] = {"placement.knowledge", "unknown"};
static const char *const chance[] = {"placement.detection", "independent"};
static const char *const greedy[] = {"placement.method", "greedy"};
static const char *const over[] = {
    "conditions", "{thin: {}, thick: {media.fog.extinction_per_m: 0.5}}"};

typedef struct job {
    const char *const *setting; /* key and value */
    unsigned threads;
    char *json[THREAD_RANKS_MAX];
} job;

static murk_status plan(void *user, unsigned number, murk_error *error)
{
    job *j = user;
    const murk_context_options options = {.size = sizeof options,
                                          .threads = j->threads};
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_plan *made = NULL;
    const murk_fields *fields = NULL;
    /* One handle after the other, down to the plan. */
    *error = (murk_error)MURK_ERROR_NONE;
    murk_status status = murk_context_create(&context, &options, error);
    if (!status) {
        status =
            murk_scene_parse(&scene, context, scene_text, "room.yaml", error);
    }
    if (!status) {
        status = murk_scene_set(scene, j->setting[0], j->setting[1], error);
    }
    if (!status) {
        status = murk_world_create(&world, scene, error);
    }
    if (!status) {
        status = murk_plan_make(&made, world, error);
    }
    if (!status) {
        status = murk_plan_fields(made, &fields, error);
    }
    if (!status) {
        j->json[number] = strdup(murk_fields_json(fields));
    }
    murk_plan_destroy(made);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return status;
}

/* True if all ranks have the plan of one. */
static bool plans_are_the_same(const char *const *setting, unsigned count,
                               unsigned threads, thread_ranks_defect defect)
{
    job one = {.setting = setting, .threads = 1};
    job all = {.setting = setting, .threads = threads};
    thread_ranks_end end = thread_ranks_run(1, THREAD_RANKS_SOUND, plan, &one);
    CHECK(thread_ranks_succeeded(&end, 1));
    CHECK_TEXT(end.error[0].text, "");
    CHECK(one.json[0] && strstr(one.json[0], "\"coverage\""));
    end = thread_ranks_run(count, defect, plan, &all);
    bool is_same = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        is_same = is_same && all.json[r] && one.json[0] &&
                  strcmp(all.json[r], one.json[0]) == 0;
        free(all.json[r]);
    }
    free(one.json[0]);
    return is_same;
}

int main(void)
{
    const char *const *const settings[] = {known, unknown, chance, greedy,
                                           over};
    for (size_t i = 0; i < sizeof settings / sizeof *settings; ++i) {
        CHECK(plans_are_the_same(settings[i], 2, 1, THREAD_RANKS_SOUND));
        CHECK(plans_are_the_same(settings[i], 3, 2, THREAD_RANKS_SOUND));
    }
    CHECK(plans_are_the_same(known, 5, 1, THREAD_RANKS_SOUND));
    CHECK(!plans_are_the_same(known, 3, 1, THREAD_RANKS_LOSE_WORDS));
    return check_done();
}
