/* Traverses a scene's tree by the key table (scene/walk.h): for each map it
 * checks the names of keys, finds the variant of the map, fills in defaults,
 * sorts the keys, and reads each value; lists and named items become arrays
 * of structs. */
#include "scene/walk.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/value.h"
#include "scene/walk_bands.h"
#include "scene/walk_names.h"
#include "scene/words.h"

#define PLACE_SIZE (MURK_SCENE_WHERE_SIZE - MURK_WALK_KEY_SIZE)

/* ---- places and messages ---- */

size_t murk_walk_enter(murk_key_reader *walk, const char *part)
{
    const size_t length = strlen(walk->key);
    char shown[MURK_SCENE_NAME_SIZE];
    murk_words_show(shown, sizeof shown, part);
    snprintf(walk->key + length, sizeof walk->key - length, "%s%s",
             length ? "." : "", shown);
    return length;
}

void murk_walk_leave(murk_key_reader *walk, size_t length)
{
    walk->key[length] = '\0';
}

/* True if an option names the key itself: --set KEY=VALUE, or --seed 3. */
static bool names_key(const char *source, const char *key)
{
    const size_t length = strlen(key);
    if (strncmp(source, "--set ", 6) != 0) {
        return strncmp(source, "--", 2) == 0;
    }
    return strncmp(source + 6, key, length) == 0 && source[6 + length] == '=';
}

void murk_walk_where(const murk_yaml *node, const char *key, bool at_key,
                     murk_scene_where out)
{
    char place[PLACE_SIZE];
    if (at_key || node->kind != MURK_YAML_SCALAR) {
        murk_yaml_key_place(node, place, sizeof place);
    } else {
        murk_yaml_place(node, place, sizeof place);
    }
    const bool is_said = key[0] == '\0' || names_key(node->source, key);
    snprintf(out, MURK_SCENE_WHERE_SIZE, "%s%s%.*s", place, is_said ? "" : ": ",
             is_said ? 0 : MURK_WALK_KEY_SIZE, key);
}

murk_status murk_walk_fail(murk_key_reader *walk, murk_status status,
                           const murk_yaml *node, bool at_key,
                           const char *format, ...)
{
    murk_scene_where where;
    char text[512];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    murk_walk_where(node, walk->key, at_key, where);
    return murk_fail(walk->err, status, where, "%s", text);
}

murk_status murk_walk_no_memory(murk_key_reader *walk)
{
    return murk_fail(walk->err, MURK_NO_MEMORY, walk->scene->path,
                     "no memory to read it");
}

/* ---- the keys of one map ---- */

/* Adds a default to a map. Defaults are parsed from text, so that they are
 * read like the values of the user. */
static murk_status put_preset(murk_key_reader *walk, murk_yaml *map,
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

static murk_status find_variant(murk_key_reader *walk, const murk_keys *keys,
                                murk_yaml *map, int *variant)
{
    *variant = 0;
    if (keys->choose) {
        return keys->choose(walk, map, variant);
    }
    if (!keys->selector) {
        return MURK_OK;
    }
    const murk_key *key = murk_keys_find(keys, keys->selector);
    murk_yaml *node = murk_yaml_get(map, keys->selector);
    /* A default selects the variant if the key is missing. */
    if (!node && key->preset) {
        const murk_status status =
            put_preset(walk, map, key->name, key->preset);
        if (status) {
            return status;
        }
        node = murk_yaml_get(map, keys->selector);
    }
    if (!node) {
        char allowed[MURK_ALLOWED_SIZE];
        murk_value_allowed(key, allowed);
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "misses %s, must be %s", key->name, allowed);
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
                put_preset(walk, map, key->name, key->preset);
            if (status) {
                return status;
            }
        } else if (key->required) {
            char allowed[MURK_ALLOWED_SIZE];
            murk_value_allowed(key, allowed);
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "misses %s, must be %s", key->name, allowed);
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

static murk_status walk_map(murk_key_reader *walk, const murk_keys *keys,
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
    murk_status status = murk_walk_check_names(walk, keys, map);
    if (status || (status = murk_walk_check_groups(walk, keys, map)) ||
        (status = find_variant(walk, keys, map, &variant)) ||
        (status = murk_walk_check_variant(walk, keys, map, variant)) ||
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

static murk_status check_number_of_items(murk_key_reader *walk,
                                         const murk_key *key,
                                         const murk_yaml *node)
{
    const murk_keys *keys = key->keys;
    if (keys->needs_item && node->n == 0) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                              "an empty list, must have at least one %s",
                              keys->noun);
    }
    if (node->n > keys->max_items) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                              "%zu items (%s), must be at most %zu", node->n,
                              keys->noun, keys->max_items);
    }
    return MURK_OK;
}

static murk_status walk_items(murk_key_reader *walk, const murk_keys *keys,
                              murk_yaml *node, char *items)
{
    for (size_t i = 0; i < node->n; ++i) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        const bool is_named = node->kind == MURK_YAML_MAP;
        const size_t back =
            murk_walk_enter(walk, is_named ? node->key[i] : number);
        char *const item = items + i * keys->item_size;
        if (is_named) {
            memcpy(item + keys->name_at, node->key[i],
                   strlen(node->key[i]) + 1);
        }
        const murk_key one = {.name = "", .kind = MURK_KEY_MAP, .keys = keys};
        const murk_status status =
            murk_walk_value(walk, &one, node->child[i], item);
        murk_walk_leave(walk, back);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

static murk_status check_item_names(murk_key_reader *walk,
                                    const murk_yaml *node)
{
    for (size_t i = 0; i < node->n; ++i) {
        const size_t length = strlen(node->key[i]);
        if (length == 0 || length >= MURK_SCENE_NAME_SIZE) {
            const size_t back = murk_walk_enter(walk, node->key[i]);
            const murk_status status =
                murk_walk_fail(walk, MURK_BAD_VALUE, node->child[i], true,
                               "a name of %zu bytes, must be 1..%d", length,
                               MURK_SCENE_NAME_SIZE - 1);
            murk_walk_leave(walk, back);
            return status;
        }
    }
    return MURK_OK;
}

/* Puts the built-in name first, whether the user gave it or not. */
static murk_status put_first(murk_key_reader *walk, const murk_keys *keys,
                             murk_yaml *node)
{
    if (!keys->first) {
        return MURK_OK;
    }
    if (!murk_yaml_get(node, keys->first)) {
        const murk_status status =
            put_preset(walk, node, keys->first, keys->first_preset);
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

static murk_status walk_array(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *owner)
{
    const murk_keys *keys = key->keys;
    murk_status status = MURK_OK;
    if (key->kind == MURK_KEY_NAMED) {
        status = put_first(walk, keys, node);
    }
    if (status || (status = check_number_of_items(walk, key, node))) {
        return status;
    }
    if (key->kind == MURK_KEY_NAMED &&
        (status = check_item_names(walk, node))) {
        return status;
    }
    if (node->n == 0) {
        return walk_items(walk, keys, node, owner);
    }
    char *items = calloc(node->n, keys->item_size);
    if (!items) {
        return murk_walk_no_memory(walk);
    }
    /* from here on the scene owns the items, even if reading fails */
    memcpy((char *)owner + keys->array_at, &items, sizeof items);
    memcpy((char *)owner + keys->count_at, &node->n, sizeof node->n);
    return walk_items(walk, keys, node, items);
}

murk_status murk_walk_value(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item)
{
    if (key->has_flag) {
        murk_value_store(item, key->flag_at, sizeof(bool), true);
    }
    const bool may_be_word =
        key->kind == MURK_KEY_MAP || key->kind == MURK_KEY_NUMBER_LIST;
    if (may_be_word && key->words && node->kind == MURK_YAML_SCALAR) {
        int word = 0;
        const murk_status status = murk_value_word(walk, key, node, &word);
        if (!status) { /* a list does not store the word: it is empty then */
            murk_value_store(item, key->at, key->size, word);
        }
        return status;
    }
    if (key->kind == MURK_KEY_PER_BAND) {
        return murk_walk_bands(walk, key, node, item);
    }
    if (key->kind == MURK_KEY_SPECTRUM && key->keys &&
        node->kind == MURK_YAML_MAP) {
        return walk_map(walk, key->keys, node, item);
    }
    const bool wants_map =
        key->kind == MURK_KEY_MAP || key->kind == MURK_KEY_NAMED;
    if (!wants_map && key->kind != MURK_KEY_LIST) {
        return murk_value_read(walk, key, node, item);
    }
    if (node->kind != (wants_map ? MURK_YAML_MAP : MURK_YAML_LIST)) {
        char found[MURK_FOUND_SIZE], allowed[MURK_ALLOWED_SIZE];
        murk_value_found(node, found);
        murk_value_allowed(key, allowed);
        return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                              "%s, must be %s", found, allowed);
    }
    return key->kind == MURK_KEY_MAP ? walk_map(walk, key->keys, node, item)
                                     : walk_array(walk, key, node, item);
}

murk_status murk_walk_scene(murk_key_reader *walk)
{
    if (walk->root->kind != MURK_YAML_MAP) {
        char found[MURK_FOUND_SIZE];
        murk_value_found(walk->root, found);
        return murk_walk_fail(walk, MURK_BAD_VALUE, walk->root, false,
                              "%s, must be a scene: a map of keys", found);
    }
    return walk_map(walk, &murk_scene_keys, walk->root, walk->scene);
}
