/* murk check: reads and builds a scene, and reports surfaces, media, lights,
 * candidates, sensors, cameras, doubtful points and the memory that a run
 * takes, alone or shared by ranks. */
#include "app/given.h"
#include "app/show.h"

murk_status murk_command_check(const murk_options *options, murk_error *err)
{
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_given_save save = {.exports = NULL};
    const murk_fields *fields = NULL;
    const murk_check_options check = {
        .size = sizeof check,
        .picture = murk_option_text(options, "--picture"),
        .pixels = {options->render.pixels[0], options->render.pixels[1]},
        .cut_m = options->section.has_cut ? options->section.cut_m : NULL,
        .ranks = (size_t)murk_option_number(options, "--ranks", 0)};
    /* The scene, its world, and the options of the results. */
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_world_create(&world, scene, err);
    }
    if (!status) {
        status = murk_given_save_begin(&save, options, err);
    }
    if (!status) {
        status = murk_world_check(world, &check, &save.options, &fields, err);
    }
    if (!status) {
        murk_show_results(options, fields);
    }
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_given_save_end(&save);
    return status;
}
