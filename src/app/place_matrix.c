/* murk place --matrix: columns of a coverage matrix from a file, without any
 * scene. */
#include "app/place_matrix.h"

#include "app/given.h"
#include "app/show.h"

#include <string.h>

/* True if the command line sets the key. */
static bool is_set(const murk_options *options, const char *key)
{
    const size_t length = strlen(key);
    for (size_t i = 0; i < options->n_overrides; ++i) {
        const char *text = options->overrides[i].text;
        if (strncmp(text, key, length) == 0 && text[length] == '=') {
            return true;
        }
    }
    return false;
}

/* Fails unless the options have a meaning for a matrix and give one goal; a
 * scene would refuse two goals by the words of scenes. */
static murk_status check_options(const murk_options *options, murk_error *err)
{
    if (options->light) {
        return murk_fail(err, MURK_BAD_VALUE, "--light",
                         "a matrix has no light; leave it out with --matrix");
    }
    if (murk_option_text(options, "--repeat")) {
        return murk_fail(err, MURK_BAD_VALUE, "--repeat",
                         "a matrix is one sample, other seeds have no other; "
                         "leave it out with --matrix");
    }
    const int goals = is_set(options, "sensors.count") +
                      is_set(options, "sensors.target") +
                      is_set(options, "sensors.budget");
    return goals == 1
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "--matrix",
                           "needs one of --count N, --target C and --budget B, "
                           "%d are given",
                           goals);
}

murk_status murk_place_matrix(const murk_options *options, murk_error *err)
{
    murk_scene *scene = NULL;
    murk_plan *plan = NULL;
    murk_given_save save = {.exports = NULL};
    const murk_fields *saved = NULL;
    /* The keys of the command line. */
    murk_status status = check_options(options, err);
    if (!status) {
        status = murk_scene_create(&scene, options->context, err);
    }
    if (!status) {
        status = murk_given_keys(scene, options, err);
    }
    if (!status) {
        status = murk_given_save_begin(&save, options, err);
    }
    /* The choice. */
    if (!status) {
        status = murk_plan_for_matrix(&plan, scene, options->matrix,
                                      options->out, &save.options, err);
    }
    if (!status) { /* if an export alone fails, the plan is saved */
        status = murk_plan_save(plan, options->out, &save.options, &saved, err);
    }
    murk_show(options, saved);
    if (!status) {
        status = murk_show_check_search(saved, err);
    }
    murk_plan_destroy(plan);
    murk_scene_destroy(scene);
    murk_given_save_end(&save);
    return status;
}
