/* Compares two scenes: prints the resolved scenes without optics and light
 * sources, prints the shapes of the light sources, and compares the texts; then
 * compares optics and powers by value. */
#include "calibrate/key_effect.h"

#include "preset/words.h"
#include "scene/keys.h"
#include "scene/print.h"
#include "world/source_shapes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "to compare two scenes");
}

/* ---- the world ---- */

/* True for top-level keys of a scene that the light depends on, except `lights`
 * and `site`: light sources are compared by their shapes. */
static bool is_of_world(const char *key)
{
    const murk_key *row = murk_keys_find(&murk_scene_keys, key);
    return row && row->lights && strcmp(key, "lights") != 0 &&
           strcmp(key, "site") != 0;
}

/* Removes the keys of a medium that determine optics. */
static void drop_optics(murk_yaml *medium)
{
    const murk_yaml *albedo = murk_yaml_get(medium, "albedo");
    if (albedo && albedo->kind != MURK_YAML_MAP) { /* a map names a grid */
        murk_yaml_remove(medium, "albedo");
    }
    murk_yaml_remove(medium, "extinction_per_m");
    murk_yaml_remove(medium, "phase");
    murk_yaml_remove(medium, "effective_variance");
    for (int i = 0; i < MURK_WORDS; ++i) {
        murk_yaml_remove(medium, murk_word_rows[i].name);
    }
}

/* Prints the world without optics and light sources; NULL when out of memory.
 */
static char *print_world(const murk_scene_desc *scene)
{
    murk_yaml *root = NULL;
    if (murk_yaml_parse(&root, scene->resolved, strlen(scene->resolved),
                        scene->path, NULL)) {
        return NULL; /* cannot fail: murk printed this text */
    }
    murk_yaml *media = murk_yaml_get(root, "media");
    for (size_t i = 0; media && media->kind == MURK_YAML_MAP && i < media->n;
         ++i) {
        drop_optics(media->child[i]);
    }
    char *text = murk_print_file(root, is_of_world);
    murk_yaml_destroy(root);
    return text;
}

static murk_status print_lights(char **out, const murk_scene_desc *scene,
                                murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return no_memory(err);
    }
    murk_status status = murk_source_shapes_print(to, scene, err);
    *out = murk_print_finish(to, &text);
    return status || *out ? status : no_memory(err);
}

/* True if the worlds or the shapes of the light sources differ. */
static murk_status compare_worlds(bool *differs, const murk_scene_desc *a,
                                  const murk_scene_desc *b, murk_error *err)
{
    const murk_scene_desc *const scene[] = {a, b};
    char *world[2] = {NULL, NULL}, *lights[2] = {NULL, NULL};
    murk_status status = MURK_OK;
    for (int i = 0; i < 2 && !status; ++i) {
        world[i] = print_world(scene[i]);
        status =
            world[i] ? print_lights(&lights[i], scene[i], err) : no_memory(err);
    }
    if (!status) {
        *differs = strcmp(world[0], world[1]) != 0 ||
                   strcmp(lights[0], lights[1]) != 0 ||
                   a->n_media != b->n_media || a->n_lights != b->n_lights ||
                   a->bands != b->bands;
    }
    for (int i = 0; i < 2; ++i) {
        free(world[i]);
        free(lights[i]);
    }
    return status;
}

/* ---- optics ---- */

/* Compares the optics of each medium in each band. */
static void compare_media(murk_key_effect *effect, const murk_optics *a,
                          const murk_optics *b)
{
    for (size_t i = 0; i < a->media; ++i) {
        for (int k = 0; k < a->bands; ++k) {
            const bool turns = !murk_optics_turn_alike(a, b, i, k);
            effect->phase = effect->phase || turns;
            effect->tables =
                effect->tables ||
                (turns && a->phases->medium[i][k].kind == MURK_PHASE_TABLE);
            effect->optics = effect->optics || turns ||
                             a->extinction_per_m[i].band[k] !=
                                 b->extinction_per_m[i].band[k] ||
                             a->albedo[i].band[k] != b->albedo[i].band[k];
        }
    }
}

murk_status murk_key_effect_add(murk_key_effect *effect, const murk_optics *a,
                                const murk_optics *b, murk_error *err)
{
    bool differs = false;
    const murk_status status =
        compare_worlds(&differs, a->scene, b->scene, err);
    if (status) {
        return status;
    }
    effect->world = effect->world || differs;
    if (differs) {
        return MURK_OK; /* media and light sources need not correspond */
    }
    compare_media(effect, a, b);
    for (size_t c = 0; c < a->channels; ++c) {
        effect->power = effect->power || a->power_w[c] != b->power_w[c];
    }
    return MURK_OK;
}

static double scattering(const murk_optics *o, size_t medium, int band)
{
    return o->extinction_per_m[medium].band[band] *
           o->albedo[medium].band[band];
}

bool murk_key_effect_from_nothing(char *key, size_t size, const murk_optics *a,
                                  const murk_optics *b)
{
    for (size_t i = 0; i < a->media; ++i) {
        for (int k = 0; k < a->bands; ++k) {
            const bool had_extinction = a->extinction_per_m[i].band[k] > 0;
            const bool has_extinction = b->extinction_per_m[i].band[k] > 0;
            if ((!had_extinction && has_extinction) ||
                (!(scattering(a, i, k) > 0) && scattering(b, i, k) > 0)) {
                snprintf(key, size, "media.%s", a->scene->media[i].name);
                return true;
            }
        }
    }
    for (size_t c = 0; c < a->channels; ++c) {
        if (!(a->power_w[c] > 0) && b->power_w[c] > 0) {
            snprintf(key, size, "lights.%zu",
                     a->scene->lights[c / (size_t)a->bands].item);
            return true;
        }
    }
    return false;
}
