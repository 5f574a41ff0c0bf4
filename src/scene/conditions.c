/* Conditions of a scene: a condition is the scene with some keys changed.
 * The tree of a condition is made from the tree of the scene by putting each
 * key of the condition in place, with the checks of scene/override.h. */
#include "scene/conditions.h"

#include "base/words.h"
#include "scene/override.h"
#include "scene/scene.h"
#include "scene/walk.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Removes all keys about conditions from the tree, and returns a copy of the
 * map of the condition `name`, which must exist. Returns NULL if `name` is NULL
 * or when out of memory. */
static murk_yaml *take_out(murk_yaml *root, const char *name)
{
    const murk_yaml *all = murk_yaml_get(root, "conditions");
    murk_yaml *map = name ? murk_yaml_copy(murk_yaml_get(all, name)) : NULL;
    murk_yaml_remove(root, "conditions");
    murk_yaml *placement = murk_yaml_get(root, "placement");
    if (placement && placement->kind == MURK_YAML_MAP) {
        murk_yaml_remove(placement, "over");
        murk_yaml_remove(placement, "condition_weights");
    }
    return map;
}

murk_status murk_condition_apply(murk_condition_values *out, murk_yaml *root,
                                 const char *name, murk_error *err)
{
    murk_yaml *map = take_out(root, name);
    murk_yaml **value = map ? calloc(map->n + 1, sizeof *value) : NULL;
    murk_status status = MURK_OK;
    if (!value) {
        status = murk_no_memory(err, root->source, "for condition %s", name);
    }
    /* Put each value at its path. Values put before must not be replaced. */
    for (size_t i = 0; !status && i < map->n; ++i) {
        char key[MURK_WALK_KEY_SIZE];
        murk_scene_where where;
        snprintf(key, sizeof key, "conditions.%s.%s", name, map->key[i]);
        murk_walk_where(map->child[i], key, true, where);
        value[i] = map->child[i];
        map->child[i] = NULL;
        status = murk_override_put(root, map->key[i], value[i], where, value, i,
                                   err);
    }
    if (status) {
        free(value);
    } else {
        *out = (murk_condition_values){value, map->n};
    }
    murk_yaml_destroy(map);
    return status;
}

static murk_status unknown(const murk_yaml *root, const murk_yaml *all,
                           const char *name, murk_error *err)
{
    char shown[MURK_SCENE_NAME_SIZE];
    murk_words_show(shown, sizeof shown, name);
    return murk_fail(
        err, MURK_BAD_VALUE, root->source, "conditions: %s is none of them%s",
        shown,
        murk_words_suggest(name, all ? (const char *const *)all->key : NULL,
                           all ? all->n : 0)
            .text);
}

murk_status murk_condition_leave(murk_yaml *root, const char *name,
                                 murk_error *err)
{
    murk_condition_values values = {0};
    const murk_yaml *all = murk_yaml_get(root, "conditions");
    const murk_yaml *map = name && all ? murk_yaml_get(all, name) : NULL;
    if (!name) {
        murk_yaml_destroy(take_out(root, NULL));
        return MURK_OK;
    }
    if (!map || map->kind != MURK_YAML_MAP) {
        return unknown(root, all && all->kind == MURK_YAML_MAP ? all : NULL,
                       name, err);
    }
    const murk_status status = murk_condition_apply(&values, root, name, err);
    free(values.value);
    return status;
}

bool murk_condition_put_back(murk_yaml *root, const char *name,
                             const murk_condition_values *values)
{
    murk_yaml *map = murk_yaml_get(murk_yaml_get(root, "conditions"), name);
    assert(map && map->n == values->n);
    for (size_t i = 0; i < values->n; ++i) {
        murk_yaml *copy = murk_yaml_copy(values->value[i]);
        if (!copy) {
            return false;
        }
        murk_yaml_destroy(map->child[i]);
        map->child[i] = copy;
    }
    return true;
}
