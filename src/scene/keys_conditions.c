/* Keys of conditions: named sets of overrides, and the weights of conditions
 * in placement. */
#include "scene/keys_rows.h"

#include <stdio.h>
#include <string.h>

#include "base/words.h"
#include "scene/override.h"
#include "scene/value.h"

#define LETTERS \
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_"

/* True if a condition must not set the key at a path: the row of the top-level
 * key in the table of the scene is not marked `may_differ`. */
static bool is_fixed(const char *path)
{
    const murk_key *key = murk_scene_keys.key;
    while (key->name && !murk_override_overlap(path, key->name)) {
        ++key;
    }
    return key->name && !key->may_differ;
}

/* The names of the top-level keys that conditions may set. */
static void list_free(char *out, size_t size)
{
    size_t n = 0;
    out[0] = '\0';
    for (const murk_key *key = murk_scene_keys.key; key->name; ++key) {
        if (key->may_differ && n < size) {
            n += (size_t)snprintf(out + n, size - n, "%s%s", n ? ", " : "",
                                  key->name);
        }
    }
}

/* Checks the characters of a name, because names appear in tables and columns
 * of result files, and that the name is no word with a meaning of its own. */
static murk_status check_name(murk_key_reader *walk, const murk_yaml *map,
                              const char *name)
{
    if (strspn(name, LETTERS) != strlen(name)) {
        return murk_walk_fail_key(
            walk, map,
            "a name of other characters than letters, digits, - and _");
    }
    if (strcmp(name, "mean") == 0 || strcmp(name, "worst") == 0 ||
        strcmp(name, "regret") == 0) {
        return murk_walk_fail_key(
            walk, map, "%s is a word of placement.over, must be another name",
            name);
    }
    if (strcmp(name, "scene") == 0) {
        return murk_walk_fail_key(walk, map,
                                  "%s is the word for the scene without a "
                                  "condition, must be another name",
                                  name);
    }
    return MURK_OK;
}

static murk_status check_condition(murk_key_reader *walk, const murk_yaml *map,
                                   void *item)
{
    murk_scene_condition *condition = item;
    condition->weight = 1;
    const murk_status status = check_name(walk, map, condition->name);
    for (size_t i = 0; !status && i < map->n; ++i) {
        const char *key = map->key[i];
        const size_t back = murk_walk_enter(walk, key);
        /* Keys of one condition must not overlap. */
        for (size_t k = 0; k < i; ++k) {
            if (murk_override_overlap(key, map->key[k])) {
                char other[MURK_SCENE_NAME_SIZE];
                murk_words_show(other, sizeof other, map->key[k]);
                return murk_walk_fail_key(
                    walk, map->child[i],
                    "one of it and %s lies within the other, must be apart",
                    other);
            }
        }
        /* Some keys are the same in all conditions. */
        if (is_fixed(key)) {
            char list[400];
            list_free(list, sizeof list);
            return murk_walk_fail_key(
                walk, map->child[i],
                "must be the same in all conditions; what may differ lies in "
                "%s",
                list);
        }
        murk_walk_leave(walk, back);
    }
    return status;
}

static const murk_key NO_ROWS[] = {END};

const murk_keys murk_condition_keys = {
    .noun = "condition",
    .is_open = true,
    .check = check_condition,
    WHERE(murk_scene_condition, where),
    ITEMS(murk_scene_desc, conditions, n_conditions),
    .name_at = offsetof(murk_scene_condition, name),
    .max_items = MURK_SCENE_CONDITIONS_MAX,
    .key = NO_ROWS,
};

/* ---- weights ---- */

static const murk_key WEIGHT = {
    .name = "weight", .kind = MURK_KEY_NUMBER, .max = 1e6, .size = 8};

static murk_status no_such_condition(murk_key_reader *walk,
                                     const murk_scene_desc *scene,
                                     const char *name, const murk_yaml *node)
{
    const char *names[MURK_SCENE_CONDITIONS_MAX];
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        names[i] = scene->conditions[i].name;
    }
    return murk_walk_fail_key(
        walk, node, "no such condition%s",
        murk_words_suggest(name, names, scene->n_conditions).text);
}

/* Reads the weights. Conditions come before placement in the key table, so
 * they are known here. */
static murk_status check_weights(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    murk_scene_desc *scene = walk->scene;
    double sum = 0;
    (void)item;
    for (size_t i = 0; i < map->n; ++i) {
        size_t k = 0;
        while (k < scene->n_conditions &&
               strcmp(scene->conditions[k].name, map->key[i]) != 0) {
            ++k;
        }
        const size_t back = murk_walk_enter(walk, map->key[i]);
        /* Each weight belongs to a condition. */
        const murk_status status =
            k < scene->n_conditions
                ? murk_value_read(walk, &WEIGHT, map->child[i],
                                  &scene->conditions[k].weight)
                : no_such_condition(walk, scene, map->key[i], map->child[i]);
        murk_walk_leave(walk, back);
        if (status) {
            return status;
        }
    }
    for (size_t k = 0; k < scene->n_conditions; ++k) {
        sum += scene->conditions[k].weight;
    }
    return scene->n_conditions == 0 || sum > 0
               ? MURK_OK
               : murk_walk_fail(walk, map,
                                "all weights are 0, one must be more than 0");
}

const murk_keys murk_condition_weight_keys = {
    .noun = "condition weight",
    .is_open = true,
    .check = check_weights,
    .key = NO_ROWS,
};

murk_status murk_check_conditions(murk_key_reader *walk, const murk_yaml *map,
                                  const murk_scene_desc *scene)
{
    if (scene->placement.over == MURK_SCENE_OBJECTIVE_NONE ||
        scene->n_conditions > 0) {
        return MURK_OK;
    }
    const murk_yaml *over =
        murk_yaml_get(murk_yaml_get(map, "placement"), "over");
    murk_walk_enter(walk, "placement.over");
    return murk_walk_fail(walk, over, "%s, but the scene has no conditions",
                          over->text);
}
