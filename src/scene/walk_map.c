/* Traverses a scene's tree by the key table (scene/walk.h): for each map it
 * checks the names of keys, finds the variant of the map, fills in defaults,
 * sorts the keys, and reads each value; lists and named items become arrays
 * of structs. */
#include "scene/walk.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "scene/value.h"
#include "scene/walk_names.h"

/* ---- the keys of one map ---- */

murk_status murk_walk_put_preset(murk_key_reader *walk, murk_yaml *map,
                                 const char *name, const char *text)
{
    murk_yaml *node = NULL;
    const char *source = walk->root->source;
    const murk_status status =
        murk_yaml_parse(&node, text, strlen(text), source, walk->err);
    if (status) {
        return status;
    }
    node->line = node->column = 0;
    for (size_t i = 0; i < node->n; ++i) { /* no default has deeper levels */
        node->child[i]->line = node->child[i]->key_line = 0;
    }
    return murk_yaml_put(map, name, node) ? MURK_OK : murk_walk_no_memory(walk);
}

static murk_status fail_missing(murk_key_reader *walk, const murk_key *key,
                                const murk_yaml *map)
{
    char allowed[MURK_ALLOWED_SIZE];
    murk_value_allowed(key, allowed);
    return murk_walk_fail(walk, map, "misses %s, must be %s", key->name,
                          allowed);
}

static murk_status find_variant(murk_key_reader *walk, const murk_keys *keys,
                                murk_yaml *map, int *variant)
{
    *variant = 0;
    if (keys->choose) {
        return keys->choose(walk, map, variant);
    }
    for (int i = 0; keys->by_key && keys->variant_names[i]; ++i) {
        if (murk_yaml_get(map, keys->variant_names[i])) {
            *variant = i;
        }
    }
    if (!keys->selector) {
        return MURK_OK;
    }
    const murk_key *key = murk_keys_find(keys, keys->selector);
    murk_yaml *node = murk_yaml_get(map, keys->selector);
    /* A default selects the variant if the key is missing. */
    if (!node && key->preset) {
        const murk_status status =
            murk_walk_put_preset(walk, map, key->name, key->preset);
        if (status) {
            return status;
        }
        node = murk_yaml_get(map, keys->selector);
    }
    if (!node) {
        return fail_missing(walk, key, map);
    }
    /* The word of the selector is the variant. */
    const size_t back = murk_walk_enter(walk, key->name);
    const murk_status status = murk_value_word(walk, key, node, variant);
    murk_walk_leave(walk, back);
    return status;
}

static bool has_group(const murk_keys *keys, const murk_yaml *map, int group)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        if (key->group == group && murk_yaml_get(map, key->name)) {
            return true;
        }
    }
    return false;
}

static murk_status put_presets(murk_key_reader *walk, const murk_keys *keys,
                               murk_yaml *map, int variant)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        if (!murk_walk_fits(key, variant) || murk_yaml_get(map, key->name) ||
            (key->group && has_group(keys, map, key->group))) {
            continue;
        }
        if (key->preset) {
            const murk_status status =
                murk_walk_put_preset(walk, map, key->name, key->preset);
            if (status) {
                return status;
            }
        } else if (key->required) {
            return fail_missing(walk, key, map);
        }
    }
    return MURK_OK;
}

static void swap_children(murk_yaml *map, size_t i, size_t k)
{
    murk_yaml *const child = map->child[i];
    map->child[i] = map->child[k];
    map->child[k] = child;
    char *const key = map->key[i];
    map->key[i] = map->key[k];
    map->key[k] = key;
}

static void sort_by_table(const murk_keys *keys, murk_yaml *map, int variant)
{
    size_t place = 0;
    for (const murk_key *key = keys->key; key->name; ++key) {
        for (size_t i = place; i < map->n && murk_walk_fits(key, variant);
             ++i) {
            if (strcmp(map->key[i], key->name) == 0) {
                swap_children(map, place++, i);
                break;
            }
        }
    }
}

static void mark_absent(const murk_keys *keys, const murk_yaml *map,
                        int variant, void *item)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        if (key->kind == MURK_KEY_REFERENCE && key->size == sizeof(int) &&
            murk_walk_fits(key, variant) && !murk_yaml_get(map, key->name)) {
            murk_value_store(item, key->at, key->size, -1);
        }
    }
}

murk_status murk_walk_map(murk_key_reader *walk, const murk_keys *keys,
                          murk_yaml *map, void *item)
{
    /* Any keys are allowed: check() reads them all. */
    if (keys->is_open) {
        if (keys->has_where) {
            murk_walk_where(map, walk->key, false,
                            (char *)item + keys->where_at);
        }
        return keys->check(walk, map, item);
    }
    /* Check the keys, then complete the map with defaults. */
    int variant = 0;
    murk_status status = murk_walk_check_names(walk, keys, map, -1);
    if (status || (status = murk_walk_check_groups(walk, keys, map)) ||
        (status = find_variant(walk, keys, map, &variant)) ||
        (status = murk_walk_check_names(walk, keys, map, variant)) ||
        (keys->complete && (status = keys->complete(walk, map))) ||
        (status = put_presets(walk, keys, map, variant))) {
        return status;
    }
    /* Canonical order; members that tell the variant and the place. */
    sort_by_table(keys, map, variant);
    mark_absent(keys, map, variant, item);
    if (keys->has_variant_at) {
        murk_value_store(item, keys->variant_at, sizeof(int), variant);
    }
    if (keys->has_where) {
        char *const where = (char *)item + keys->where_at;
        murk_walk_where(map, walk->key, false, where);
    }
    /* Read each value. */
    for (size_t i = 0; i < map->n; ++i) {
        const murk_key *key = murk_walk_find(keys, map->key[i], variant);
        assert(key);
        const size_t back = murk_walk_enter(walk, key->name);
        status = murk_walk_value(walk, key, map->child[i], item);
        murk_walk_leave(walk, back);
        if (status) {
            return status;
        }
    }
    return keys->check ? keys->check(walk, map, item) : MURK_OK;
}

/* ---- lists and names ---- */

/* Reads one item, a map. Only an item of values per band may be a word, which
 * then is the variant of the item. */
static murk_status walk_item(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *item)
{
    const murk_key one = {.name = key->name,
                          .kind = MURK_KEY_MAP,
                          .keys = key->keys,
                          .words = key->kind == MURK_KEY_PER_BAND ? key->words
                                                                  : NULL,
                          .at = key->keys->variant_at,
                          .size = sizeof(int)};
    return murk_walk_value(walk, &one, node, item);
}

/* Checks that an item of a list of bands has no values per band of its own. */
static murk_status check_one_band(murk_key_reader *walk, const murk_keys *keys,
                                  const murk_yaml *item)
{
    for (size_t i = 0; item->kind == MURK_YAML_MAP && i < item->n; ++i) {
        const murk_key *key = murk_keys_find(keys, item->key[i]);
        if (key && key->kind == MURK_KEY_SPECTRUM &&
            item->child[i]->kind == MURK_YAML_LIST) {
            murk_walk_enter(walk, key->name);
            return murk_walk_fail(walk, item->child[i],
                                  "a list inside a list of bands, must be one "
                                  "number");
        }
    }
    return MURK_OK;
}

static murk_status walk_items(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, char *items)
{
    const murk_keys *keys = key->keys;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < node->n && !status; ++i) {
        const bool is_named = node->kind == MURK_YAML_MAP;
        const size_t back = is_named ? murk_walk_enter(walk, node->key[i])
                                     : murk_walk_enter_item(walk, i);
        char *const item = items + i * keys->item_size;
        if (is_named) {
            memcpy(item + keys->name_at, node->key[i],
                   strlen(node->key[i]) + 1);
        }
        if (key->kind == MURK_KEY_PER_BAND) {
            status = check_one_band(walk, keys, node->child[i]);
        }
        if (!status) {
            status = walk_item(walk, key, node->child[i], item);
            murk_walk_leave(walk, back);
        }
    }
    return status;
}

/* Reads one item for all bands, or a list with one item per band, into an
 * array that is a member of the owner. */
static murk_status walk_bands(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *owner)
{
    char *const items = (char *)owner + key->at;
    const bool is_list = node->kind == MURK_YAML_LIST;
    const size_t n = is_list ? node->n : 1;
    if (is_list && n != (size_t)walk->scene->bands) {
        return murk_walk_fail(
            walk, node,
            "a list of %zu, must be one %s or a list of %d, one a band", n,
            key->keys->noun, walk->scene->bands);
    }
    memcpy((char *)owner + key->keys->count_at, &n, sizeof n);
    return is_list ? walk_items(walk, key, node, items)
                   : walk_item(walk, key, node, items);
}

static murk_status check_item_names(murk_key_reader *walk,
                                    const murk_yaml *node)
{
    for (size_t i = 0; i < node->n; ++i) {
        const size_t length = strlen(node->key[i]);
        if (length == 0 || length >= MURK_SCENE_NAME_SIZE) {
            murk_walk_enter(walk, node->key[i]);
            return murk_walk_fail_key(walk, node->child[i],
                                      "a name of %zu bytes, must be 1..%d",
                                      length, MURK_SCENE_NAME_SIZE - 1);
        }
    }
    return MURK_OK;
}

/* Puts the built-in name first, whether the user gave it or not. */
static murk_status put_first(murk_key_reader *walk, const murk_keys *keys,
                             murk_yaml *node)
{
    if (!murk_yaml_get(node, keys->first)) {
        const murk_status status =
            murk_walk_put_preset(walk, node, keys->first, keys->first_preset);
        if (status) {
            return status;
        }
    }
    size_t i = 0;
    while (strcmp(node->key[i], keys->first) != 0) {
        ++i;
    }
    for (; i > 0; --i) { /* the others keep their order */
        swap_children(node, i, i - 1);
    }
    return MURK_OK;
}

/* Reads a list of maps, maps by name, or a single map into an array that is
 * allocated. */
static murk_status walk_array(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *owner)
{
    const murk_keys *keys = key->keys;
    const bool is_named = key->kind == MURK_KEY_NAMED;
    const bool is_one = !is_named && node->kind == MURK_YAML_MAP;
    /* The built-in item, the number of items, and their names. */
    murk_status status =
        is_named && keys->first ? put_first(walk, keys, node) : MURK_OK;
    if (status) {
        return status;
    }
    const size_t n = is_one ? 1 : node->n;
    if (keys->needs_item && n == 0) {
        return murk_walk_fail(
            walk, node, "an empty list, must have at least one %s", keys->noun);
    }
    if (n > keys->max_items) {
        return murk_walk_fail(walk, node, "%zu items (%s), must be at most %zu",
                              n, keys->noun, keys->max_items);
    }
    if ((is_named && (status = check_item_names(walk, node))) || n == 0) {
        return status;
    }
    /* From here on the struct *owner owns the items, even if reading fails. */
    char *items = calloc(n, keys->item_size);
    if (!items) {
        return murk_walk_no_memory(walk);
    }
    memcpy((char *)owner + keys->array_at, &items, sizeof items);
    memcpy((char *)owner + keys->count_at, &n, sizeof n);
    return is_one ? walk_item(walk, key, node, items)
                  : walk_items(walk, key, node, items);
}

bool murk_walk_make_file_map(murk_yaml *node)
{
    murk_yaml *file = murk_yaml_copy(node);
    if (!file) {
        return false;
    }
    murk_yaml_clear(node);
    node->kind = MURK_YAML_MAP;
    return murk_yaml_put(node, "file", file);
}

murk_status murk_walk_value(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item)
{
    if (key->takes_file && node->kind == MURK_YAML_SCALAR &&
        node->text[0] != '\0' && !murk_yaml_is_null(node) &&
        !murk_walk_make_file_map(node)) {
        return murk_walk_no_memory(walk);
    }
    if (key->has_flag) {
        murk_value_store(item, key->flag_at, sizeof(bool), true);
    }
    /* The value is one of the words of the key. A key of a list may have words,
     * too, such as "all": its member in the struct is a list, or it has none
     * (size 0). murk_value_store() stores only in members of the size of a char
     * or an int, so it stores nothing then, and the list stays empty. */
    if (key->words && node->kind == MURK_YAML_SCALAR &&
        key->kind != MURK_KEY_PER_BAND) {
        int word = 0;
        const murk_status status = murk_value_word(walk, key, node, &word);
        if (!status) {
            murk_value_store(item, key->at, key->size, word);
        }
        return status;
    }
    const bool is_map = node->kind == MURK_YAML_MAP;
    const bool is_list = node->kind == MURK_YAML_LIST;
    switch (key->kind) {
    case MURK_KEY_PER_BAND:
        return walk_bands(walk, key, node, item);
    case MURK_KEY_MAP:
        return is_map ? murk_walk_map(walk, key->keys, node,
                                      (char *)item + key->inside)
                      : murk_value_wrong(walk, key, node);
    case MURK_KEY_SPECTRUM:
        return key->keys && is_map ? murk_walk_map(walk, key->keys, node, item)
                                   : murk_value_read(walk, key, node, item);
    case MURK_KEY_LIST:
    case MURK_KEY_MAPS:
    case MURK_KEY_NAMED:
        return (is_list && key->kind != MURK_KEY_NAMED) ||
                       (is_map && key->kind != MURK_KEY_LIST)
                   ? walk_array(walk, key, node, item)
                   : murk_value_wrong(walk, key, node);
    default:
        return murk_value_read(walk, key, node, item);
    }
}

murk_status murk_walk_root(murk_key_reader *walk, const murk_keys *keys,
                           void *item)
{
    if (walk->root->kind != MURK_YAML_MAP) {
        char found[MURK_FOUND_SIZE];
        murk_value_found(walk->root, found);
        return murk_walk_fail(walk, walk->root,
                              "%s, must be a %s: a map of keys", found,
                              keys->noun);
    }
    return murk_walk_map(walk, keys, walk->root, item);
}
