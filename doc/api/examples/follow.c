/* A timeline: two plans, before and after the lamp has moved across the room;
 * then each of them as a part, as two machines would make them, and both parts
 * put together.
 */
#include "example.h"

/* Makes the steps that are asked for, and writes the files. */
static void finish(murk_follow *follow)
{
    murk_error error = MURK_ERROR_NONE;
    const murk_fields *row = NULL;
    must(murk_follow_next(follow, &row, &error), &error);
    while (row) {
        must(murk_follow_next(follow, &row, &error), &error);
    }
    must(murk_follow_save(follow, NULL, &error), &error);
}

/* Makes one of two parts of the steps in a folder. */
static void make_part(murk_scene *scene, const char *folder, uint32_t number)
{
    murk_error error = MURK_ERROR_NONE;
    murk_follow *follow = NULL;
    must(murk_follow_create(&follow, scene, folder, NULL, &error), &error);
    must(murk_follow_shard(follow, number, 2, &error), &error);
    finish(follow);
    murk_follow_destroy(follow);
}

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_follow *follow = NULL;
    const murk_fields *row = NULL, *fields = NULL;
    int64_t steps = 0;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room", &error), &error);
    must(murk_scene_set(scene, "timeline",
                        "{times_s: [0, 10], tracks: [{key: lights.0.center_m, "
                        "keyframes: [{t_s: 0, value: [1, 3, 2.8]}, {t_s: 10, "
                        "value: [7, 3, 2.8]}]}]}",
                        &error),
         &error);
    must(murk_follow_create(&follow, scene, "steps-of-room", NULL, &error),
         &error);
    must(murk_follow_next(follow, &row, &error), &error);
    while (row) {
        double t_s = 0, coverage = 0;
        must(murk_fields_double(row, "t_s", &t_s, &error), &error);
        must(murk_fields_double(row, "coverage", &coverage, &error), &error);
        printf("%2.0f s: %.1f\n", t_s, coverage);
        must(murk_follow_next(follow, &row, &error), &error);
    }
    must(murk_follow_fields(follow, &fields, &error), &error);
    must(murk_fields_int64(fields, "steps_done", &steps, &error), &error);
    printf("%d steps\n", (int)steps);
    must(murk_follow_save(follow, NULL, &error), &error);
    murk_follow_destroy(follow);
    /* Steps that do not depend on each other, as parts. */
    static const char *const part[] = {"part-1", "part-2"};
    must(murk_scene_set(scene, "timeline.search_from", "start_plan", &error),
         &error);
    make_part(scene, part[0], 1);
    make_part(scene, part[1], 2);
    must(murk_follow_create(&follow, scene, "merged-steps", NULL, &error),
         &error);
    must(murk_follow_merge(follow, part, 2, &error), &error);
    finish(follow);
    must(murk_follow_fields(follow, &fields, &error), &error);
    must(murk_fields_int64(fields, "steps_done", &steps, &error), &error);
    printf("%d steps of two parts\n", (int)steps);
    murk_follow_destroy(follow);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 *  0 s: 0.8
 * 10 s: 0.8
 * 2 steps
 * 2 steps of two parts
 */
