/* Writes values of free keys into a scene: builds a list of changes
 * (scene/variant.h) and reads the scene file with them. Also chooses the values
 * around a value for differences. */
#include "calibrate/free_keys.h"

#include "base/log.h"
#include "base/number.h"
#include "scene/variant.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void murk_free_keys_destroy(murk_free_keys *keys)
{
    if (!keys) {
        return;
    }
    for (size_t k = 0; k < keys->n; ++k) {
        murk_yaml **list = keys->key[k].list;
        for (size_t c = 0; list && c < keys->conditions; ++c) {
            murk_yaml_destroy(list[c]);
        }
    }
    murk_arena_release(&keys->arena);
    free(keys);
}

/* The changes of a scene. */
typedef struct changes {
    murk_key_change *change; /* [n]; owned: the new values */
    murk_yaml **node;        /* [n] owned: their values */
    size_t n;
} changes;

static void release(changes *all)
{
    for (size_t i = 0; all->node && i < all->n; ++i) {
        murk_yaml_destroy(all->node[i]);
    }
    free(all->node);
    free(all->change);
}

static bool set_number(murk_yaml *node, double value)
{
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, value);
    return murk_yaml_set_text(node, text);
}

/* The list that an earlier key of the same list has changed, or NULL. */
static murk_yaml *find_list(const changes *all, const char *put)
{
    for (size_t i = 0; i < all->n; ++i) {
        if (strcmp(all->change[i].path, put) == 0) {
            return all->node[i];
        }
    }
    return NULL;
}

/* Adds the change of one key. Keys of the same list change one copy of the
 * list. */
static bool add_change(changes *all, const murk_free_key *key, size_t c,
                       double value)
{
    const murk_yaml *list = key->list[c];
    murk_yaml *there = list ? find_list(all, key->put) : NULL;
    if (there) {
        return set_number(there->child[key->index], value);
    }
    murk_yaml *node = list ? murk_yaml_copy(list)
                           : murk_yaml_make(MURK_YAML_SCALAR, key->source);
    if (!node) {
        return false;
    }
    all->node[all->n] = node;
    all->change[all->n++] = (murk_key_change){
        .path = key->put, .value = node, .where = key->source};
    return set_number(list ? node->child[key->index] : node, value);
}

/* Fails if the scene file changed since the fit began. */
static murk_status check_file(const murk_free_keys *keys,
                              const murk_scene_desc *scene, murk_error *err)
{
    return keys->sha256[0] == '\0' || strcmp(keys->sha256, scene->sha256) == 0
               ? MURK_OK
               : murk_fail(err, MURK_BAD_FILE, keys->desc.scene_path,
                           "changed while it was fitted, must stay as it is");
}

murk_status murk_free_scene(murk_scene_desc **out, const murk_free_keys *keys,
                            size_t c, const double *value, murk_error *err)
{
    const murk_free_desc *desc = &keys->desc;
    changes all = {calloc(keys->n + 1, sizeof *all.change),
                   calloc(keys->n + 1, sizeof *all.node), 0};
    bool is_whole = all.change && all.node;
    /* Collect the changes. */
    for (size_t k = 0; is_whole && value && k < keys->n; ++k) {
        const murk_free_key *key = &keys->key[k];
        if (key->is_in[c] && key->gain == SIZE_MAX) {
            is_whole = add_change(&all, key, c, value[k]);
        }
    }
    const murk_variant variant = {
        keys->condition_name[c][0] ? keys->condition_name[c] : NULL, all.change,
        all.n};
    /* Read the scene with the changes, without warnings. */
    murk_scene_desc *scene = NULL;
    const bool was_silent = murk_warn_quiet(true);
    murk_status status = is_whole
                             ? murk_scene_desc_read_variant(
                                   &scene, desc->scene_path, desc->overrides,
                                   desc->n_overrides, &variant, err)
                             : murk_no_memory(err, keys->desc.scene_path,
                                              "for a variant of the scene");
    murk_warn_quiet(was_silent);
    status = status ? status : check_file(keys, scene, err);
    release(&all);
    if (status) {
        murk_scene_desc_destroy(scene);
        return status;
    }
    *out = scene;
    return MURK_OK;
}

murk_status murk_free_optics(murk_optics **out, const murk_free_keys *keys,
                             size_t c, const double *value, murk_error *err)
{
    murk_scene_desc *scene = NULL;
    const murk_imported_stages *imported = keys->desc.imported;
    const murk_fillings *fillings =
        imported
            ? murk_imported_stage_of(imported, keys->condition[c])->fillings
            : NULL;
    const murk_status status = murk_free_scene(&scene, keys, c, value, err);
    return status ? status
                  : murk_optics_create(out, scene, keys->desc.domain, fillings,
                                       keys->power_w ? keys->power_w[c] : NULL,
                                       err);
}

/* Symmetric values if the range leaves more than a quarter of the full distance
 * on both sides, otherwise `value` and one value on the side with more
 * space. */
void murk_free_key_beside(const murk_free_key *key, double step, double value,
                          double *low, double *high)
{
    const double range = key->upper - key->lower;
    const double size = key->is_log ? value : fmax(fabs(value), fmin(1, range));
    const double h = step * size;
    const double below = value - key->lower, above = key->upper - value;
    const double even = fmin(fmin(below, above), h);
    if (even > h / 4) {
        *low = value - even;
        *high = value + even;
    } else if (above >= below) {
        *low = value;
        *high = fmin(value + h, key->upper);
    } else {
        *low = fmax(value - h, key->lower);
        *high = value;
    }
}

void murk_free_key_around(const murk_free_keys *keys, size_t k, double value,
                          double *low, double *high)
{
    murk_free_key_beside(&keys->key[k], keys->key[k].step, value, low, high);
}
