/* murk place: traces, senses and places for a scene or for its conditions,
 * repeats the job with other seeds if asked for, all of them or those of a
 * shard, and writes the results or the part. A coverage matrix from a file is
 * handled in place_matrix.c. */
#include "app/given.h"
#include "app/part.h"
#include "app/place_matrix.h"
#include "app/show.h"

#include <stdlib.h>
#include <string.h>

/* repeat.part begins with the mark of light.murk. */
static const murk_part_result repeat_part = {"repeat.part", "\x8dmurk"};

/* Parts divide the further seeds of --repeat, and nothing else. */
static murk_status check_shard(const murk_options *options, murk_error *err)
{
    const uint64_t seeds = murk_option_number(options, "--repeat", 0);
    if (!options->shard.count && !options->merges) {
        return MURK_OK;
    }
    return seeds >= 2 && !options->matrix
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "--shard",
                           "divides the seeds of --repeat N; must come with a "
                           "scene and --repeat 2 or more");
}

/* Makes the world, and checks all that can be refused before light is
 * traced. */
static murk_status prepare(murk_world **world, const murk_options *options,
                           murk_given_save *save, murk_error *err)
{
    murk_scene *scene = NULL;
    const char *over = "null";
    /* The scene and its world. */
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_world_create(world, scene, err);
    }
    /* Check the options against the scene, then the folder. */
    if (!status && options->light) {
        status = murk_scene_get(scene, "placement.over", &over, err);
    }
    if (!status && strcmp(over, "null") != 0) {
        status = murk_fail(err, MURK_BAD_VALUE, "--light",
                           "not over conditions: each condition has its own "
                           "light; placement.over must be null");
    }
    if (!status) {
        status = murk_given_save_begin(save, options, err);
    }
    if (!status) {
        status = murk_world_check_save(
            *world, "place", murk_option_number(options, "--repeat", 0),
            options->shard.count ? NULL : options->out, &save->options, err);
    }
    murk_scene_destroy(scene);
    return status;
}

/* The plan for given light, or for light that is traced. */
static murk_status make_plan(murk_plan **plan, murk_world *world,
                             const murk_options *options, murk_error *err)
{
    if (!options->light) {
        return murk_plan_make(plan, world, err);
    }
    murk_light *light = NULL;
    murk_status status = murk_light_read(&light, world, options->light, err);
    if (!status) {
        status = murk_plan_for_light(plan, light, err);
    }
    murk_light_destroy(light);
    return status;
}

/* Takes the plans of other seeds from parts, and makes those that are missing.
 * Fails if the parts are refused; a later failure is left in *late. Nothing is
 * saved before, because refused parts leave no results. */
static murk_status merge(murk_plan *plan, const murk_options *options,
                         murk_error *late, murk_error *err)
{
    const uint64_t seeds = murk_option_number(options, "--repeat", 0);
    const murk_fields *fields = NULL;
    char **paths = NULL;
    murk_error why = {0};
    murk_status status =
        murk_part_paths(&paths, options, repeat_part.name, err);
    if (!status) {
        (void)murk_plan_repeat_merge(plan, seeds, (const char *const *)paths,
                                     options->merges->inputs.n, &why);
        status = murk_plan_fields(plan, &fields, err);
    }
    /* A plan that is not repeated after a failure refused the parts. */
    if (!status && why.code &&
        murk_fields_kind(fields, "repeat") != MURK_FIELD_OBJECT) {
        status = murk_fail(err, why.code, why.where, "%s", why.text);
    } else {
        *late = why;
    }
    murk_part_paths_release(paths, options);
    return status;
}

/* With -o, saves the plan before other seeds are run, because these may take
 * hours and then fail or be interrupted. If the search for the plan was
 * interrupted, no other seeds are run. A failure of the other seeds is not
 * returned: *late receives it, and the command fails with it after the results
 * are saved. */
static murk_status repeat(murk_plan *plan, const murk_options *options,
                          const murk_given_save *save, murk_error *late,
                          murk_error *err)
{
    const uint64_t seeds = murk_option_number(options, "--repeat", 0);
    const murk_fields *fields = NULL;
    murk_status status =
        seeds > 0 ? murk_plan_fields(plan, &fields, err) : MURK_OK;
    if (seeds == 0 || status || murk_show_check_search(fields, NULL)) {
        return status;
    }
    if (options->merges) {
        return merge(plan, options, late, err);
    }
    if (options->out) {
        status = murk_plan_save(plan, options->out, &save->options, NULL, err);
    }
    if (!status) {
        (void)murk_plan_repeat(plan, seeds, late);
    }
    return status;
}

/* Makes the plan and those of the seeds of a shard, and writes the part. */
static murk_status place_part(murk_world *world, const murk_options *options,
                              murk_error *err)
{
    const uint64_t seeds = murk_option_number(options, "--repeat", 0);
    const murk_fields *fields = NULL;
    murk_plan *plan = NULL;
    char *path = NULL;
    murk_status status = murk_part_begin(&path, options, &repeat_part, err);
    /* The plan; one that an interrupt has cut short has no parts. */
    if (!status) {
        status = make_plan(&plan, world, options, err);
    }
    if (!status) {
        status = murk_plan_fields(plan, &fields, err);
    }
    if (!status) {
        status = murk_show_check_search(fields, err);
    }
    /* The other seeds. */
    if (!status) {
        status = murk_plan_repeat_part(plan, seeds, options->shard.number,
                                       options->shard.count, path, err);
    }
    if (!status) {
        status = murk_part_end(options, err);
    }
    murk_plan_destroy(plan);
    free(path);
    return status;
}

murk_status murk_command_place(const murk_options *options, murk_error *err)
{
    murk_world *world = NULL;
    murk_plan *plan = NULL;
    murk_given_save save = {.exports = NULL};
    murk_error late = {0};
    const murk_fields *saved = NULL;
    murk_status status = check_shard(options, err);
    if (!status && options->matrix) {
        return murk_place_matrix(options, err);
    }
    if (!status) {
        status = prepare(&world, options, &save, err);
    }
    if (!status && options->shard.count) {
        status = place_part(world, options, err);
        murk_world_destroy(world);
        murk_given_save_end(&save);
        return status;
    }
    if (!status) {
        status = make_plan(&plan, world, options, err);
    }
    if (!status) {
        status = repeat(plan, options, &save, &late, err);
    }
    if (!status) { /* if an export alone fails, the plan is saved */
        status = murk_plan_save(plan, options->out, &save.options, &saved, err);
    }
    murk_show(options, saved);
    if (!status) {
        status = murk_fail(err, late.code, late.where, "%s", late.text);
    }
    if (!status) {
        status = murk_show_check_search(saved, err);
    }
    murk_plan_destroy(plan);
    murk_world_destroy(world);
    murk_given_save_end(&save);
    return status;
}
