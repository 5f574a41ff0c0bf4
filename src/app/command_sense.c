/* murk sense: measures the coverage of given sensors on the light of a scene,
 * and writes the results. */
#include "app/given.h"
#include "app/show.h"

/* Makes the world and its sensors, and checks all that can be refused before
 * light is traced. */
static murk_status prepare(murk_world **world, murk_sensors **sensors,
                           const murk_options *options, murk_given_save *save,
                           murk_error *err)
{
    murk_scene *scene = NULL;
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_world_create(world, scene, err);
    }
    if (!status) {
        status = murk_given_save_begin(save, options, err);
    }
    if (!status) {
        status = murk_sensors_read(sensors, *world, options->sensors, err);
    }
    if (!status) {
        status = murk_world_check_save(*world, "sense", 0, options->out,
                                       &save->options, err);
    }
    murk_scene_destroy(scene);
    return status;
}

murk_status murk_command_sense(const murk_options *options, murk_error *err)
{
    murk_world *world = NULL;
    murk_light *light = NULL;
    murk_sensors *sensors = NULL;
    murk_coverage *coverage = NULL;
    murk_given_save save = {.exports = NULL};
    const murk_fields *saved = NULL;
    if (!options->sensors) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "sense needs --sensors FILE, a sensors.csv or a "
                         "plan.json");
    }
    murk_status status = prepare(&world, &sensors, options, &save, err);
    if (!status) {
        status = murk_given_light(&light, world, options, err);
    }
    if (!status) {
        status = murk_coverage_measure(&coverage, light, sensors, err);
    }
    if (!status) { /* if an export alone fails, the coverage is saved */
        status = murk_coverage_save(coverage, options->out, &save.options,
                                    &saved, err);
    }
    murk_show(options, saved);
    murk_coverage_destroy(coverage);
    murk_light_destroy(light);
    murk_sensors_destroy(sensors);
    murk_world_destroy(world);
    murk_given_save_end(&save);
    return status;
}
