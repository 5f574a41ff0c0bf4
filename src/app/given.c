/* Turns a command line into a scene of the library with keys that are set, and
 * into options of saving: the words of all --export, and what the results
 * follow from beside the scene. */
#include "app/given.h"

#include "app/identity.h"

#include <stdlib.h>
#include <string.h>

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for the options");
}

/* ---- the scene ---- */

/* Sets the key of "KEY=VALUE". */
static murk_status set_key(murk_scene *scene, const char *text, murk_error *err)
{
    const char *equals = strchr(text, '=');
    char *key = strndup(text, (size_t)(equals - text));
    const murk_status status =
        key ? murk_scene_set(scene, key, equals + 1, err) : no_memory(err);
    free(key);
    return status;
}

murk_status murk_given_keys(murk_scene *scene, const murk_options *options,
                            murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < options->n_overrides && !status; ++i) {
        status = set_key(scene, options->overrides[i].text, err);
    }
    return status;
}

/* Fails with `unread`, the reason why the light cannot be read; but if the
 * scene is wrong, with the error of the scene. Returns MURK_OK if the scene has
 * conditions to place over, because --light is then refused later, whatever the
 * file contains. */
static murk_status refuse_light(murk_scene *scene, const murk_error *unread,
                                murk_error *err)
{
    const char *over = NULL;
    const murk_status status =
        murk_scene_get(scene, "placement.over", &over, err);
    return status || strcmp(over, "null") != 0
               ? status
               : murk_fail(err, unread->code, unread->where, "%s",
                           unread->text);
}

murk_status murk_given_scene(murk_scene **out, const murk_options *options,
                             murk_error *err)
{
    murk_status status =
        murk_scene_read(out, options->context, options->input, err);
    if (!status) {
        status = murk_given_keys(*out, options, err);
    }
    murk_error unread = {0};
    if (!status && options->light &&
        murk_scene_use_light(*out, options->light, &unread)) {
        status = refuse_light(*out, &unread, err);
    }
    return status;
}

murk_status murk_given_light(murk_light **out, murk_world *world,
                             const murk_options *options, murk_error *err)
{
    return options->light ? murk_light_read(out, world, options->light, err)
                          : murk_light_trace(out, world, err);
}

/* ---- saving ---- */

/* Joins the words of all options of a name by commas; NULL if there are none,
 * or when out of memory. */
static char *words_of(const murk_options *options, const char *name)
{
    char *all = NULL;
    for (size_t i = 0; i < options->n_given; ++i) {
        const murk_given *given = &options->given[i];
        if (strcmp(given->option->name, name) != 0) {
            continue;
        }
        const size_t length = all ? strlen(all) : 0;
        char *grown = realloc(all, length + strlen(given->value) + 2);
        if (!grown) {
            free(all);
            return NULL;
        }
        all = grown;
        strcpy(all + length, length ? "," : "");
        strcat(all, given->value);
    }
    return all;
}

murk_status murk_given_save_begin(murk_given_save *out,
                                  const murk_options *options, murk_error *err)
{
    *out = (murk_given_save){.exports = words_of(options, "--export")};
    if (options->exports && !out->exports) {
        return no_memory(err);
    }
    const murk_status status = murk_identity_asked(&out->asked, options, err);
    out->options = (murk_save_options){.size = sizeof out->options,
                                       .exports = out->exports,
                                       .voxel_m = options->voxel,
                                       .replaces = options->force,
                                       .command = options->typed,
                                       .asked = out->asked};
    return status;
}

void murk_given_save_end(murk_given_save *save)
{
    free(save->exports);
    free(save->asked);
    *save = (murk_given_save){0};
}
