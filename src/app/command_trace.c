/* murk trace: traces the light of a scene and writes the maps, the ledger and
 * the tallies. */
#include "app/given.h"
#include "app/show.h"

murk_status murk_command_trace(const murk_options *options, murk_error *err)
{
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    murk_given_save save = {.exports = NULL};
    const murk_fields *saved = NULL;
    /* Make the world, and check all that can be refused before light is
     * traced. */
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_world_create(&world, scene, err);
    }
    if (!status) {
        status = murk_given_save_begin(&save, options, err);
    }
    if (!status) {
        status = murk_world_check_save(world, "trace", 0, options->out,
                                       &save.options, err);
    }
    /* The light and its files. */
    if (!status) {
        status = murk_light_trace(&light, world, err);
    }
    if (!status) { /* if an export alone fails, the light is saved */
        status =
            murk_light_save(light, options->out, &save.options, &saved, err);
    }
    murk_show(options, saved);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_given_save_end(&save);
    return status;
}
