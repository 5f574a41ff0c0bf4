/* murk trace: traces the light of a scene and writes the maps, the ledger and
 * the tallies. */
#include "app/given.h"
#include "app/part.h"
#include "app/show.h"
#include "base/file.h"
#include "base/ranks.h"

#include <stdlib.h>
#include <string.h>

/* light.part begins with the mark of light.murk. */
static const murk_part_result light_part = {"light.part", "\x8dmurk"};

/* Traces a part of the light, and writes the part. */
static murk_status trace_part(murk_world *world, const murk_options *options,
                              murk_error *err)
{
    char *path = NULL;
    murk_status status = murk_part_begin(&path, options, &light_part, err);
    if (!status) {
        status = murk_light_trace_part(world, options->shard.number,
                                       options->shard.count, path, err);
    }
    if (!status) {
        status = murk_part_end(options, err);
    }
    free(path);
    return status;
}

/* Seconds between two checkpoints, if none are given. */
#define CHECKPOINT_S 600

/* *path: the file of checkpoints, for free(); NULL without a folder. Fails if
 * the file there is not of murk. */
static murk_status name_checkpoint(char **path, const murk_options *options,
                                   murk_error *err)
{
    *path = NULL;
    if (!options->out || options->merges) {
        return MURK_OK;
    }
    const murk_status status =
        murk_part_path(path, options->out, "checkpoint.part", err);
    return status ? status
                  : murk_file_check_owner(*path, light_part.mark,
                                          strlen(light_part.mark),
                                          options->force, err);
}

/* The light, from parts or traced, with checkpoints if there is a folder. */
static murk_status make_light(murk_light **out, murk_world *world,
                              const char *checkpoint,
                              const murk_options *options, murk_error *err)
{
    if (checkpoint) {
        const uint64_t every_s =
            murk_option_number(options, "--checkpoint", CHECKPOINT_S);
        return murk_light_trace_resume(out, world, checkpoint, (double)every_s,
                                       err);
    }
    if (!options->merges) {
        return murk_light_trace(out, world, err);
    }
    char **paths = NULL;
    murk_status status = murk_part_paths(&paths, options, light_part.name, err);
    if (!status) {
        status = murk_light_merge(out, world, (const char *const *)paths,
                                  options->merges->inputs.n, err);
    }
    murk_part_paths_release(paths, options);
    return status;
}

murk_status murk_command_trace(const murk_options *options, murk_error *err)
{
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    char *checkpoint = NULL;
    murk_given_save save = {.exports = NULL};
    const murk_fields *saved = NULL;
    /* Make the world, and check all that can be refused before light is
     * traced. */
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_world_create(&world, scene, err);
    }
    if (!status && options->shard.count) {
        status = trace_part(world, options, err);
        murk_world_destroy(world);
        murk_scene_destroy(scene);
        return status;
    }
    if (!status) {
        status = murk_given_save_begin(&save, options, err);
    }
    if (!status) {
        status = murk_world_check_save(world, "trace", 0, options->out,
                                       &save.options, err);
    }
    if (!status) {
        status = name_checkpoint(&checkpoint, options, err);
    }
    /* The light and its files. */
    if (!status) {
        status = make_light(&light, world, checkpoint, options, err);
    }
    /* If an export alone fails, the light is saved. */
    if (!status && murk_ranks_keeps()) {
        status =
            murk_light_save(light, options->out, &save.options, &saved, err);
    }
    if (saved && checkpoint && murk_ranks_number() == 0) {
        (void)remove(checkpoint); /* rank 0 has written the light */
    }
    free(checkpoint);
    murk_show(options, saved);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_given_save_end(&save);
    return status;
}
