/* Checks which keys a map of the scene may have, with messages that list the
 * allowed keys or suggest a similar one. */
#include "scene/walk_names.h"

#include <stdio.h>
#include <string.h>

#include "base/words.h"

#define MAX_KEYS 64 /* rows of one table that a message lists */

bool murk_walk_fits(const murk_key *key, int variant)
{
    return variant < 0 || key->variants == 0 ||
           (key->variants & (1u << variant)) != 0;
}

const murk_key *murk_walk_find(const murk_keys *keys, const char *name,
                               int variant)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        if (murk_walk_fits(key, variant) && strcmp(key->name, name) == 0) {
            return key;
        }
    }
    return NULL;
}

bool murk_key_is_continuous(const murk_key *key)
{
    const murk_key_kind kind = key->kind;
    return kind == MURK_KEY_NUMBER || kind == MURK_KEY_VECTOR ||
           kind == MURK_KEY_NUMBERS || kind == MURK_KEY_NUMBER_LIST ||
           kind == MURK_KEY_SPECTRUM_LIST || kind == MURK_KEY_SPECTRUM ||
           kind == MURK_KEY_SHARED;
}

const murk_key *murk_keys_find(const murk_keys *keys, const char *name)
{
    return murk_walk_find(keys, name, -1);
}

/* Lists the names that a map may have, each once. */
static size_t list_names(const murk_keys *keys, int variant,
                         const char *names[MAX_KEYS])
{
    size_t n = 0;
    for (const murk_key *key = keys->key; key->name; ++key) {
        bool is_new = murk_walk_fits(key, variant);
        for (size_t i = 0; i < n; ++i) {
            is_new = is_new && strcmp(names[i], key->name) != 0;
        }
        if (is_new && n < MAX_KEYS) {
            names[n++] = key->name;
        }
    }
    return n;
}

static murk_status fail_with_names(murk_key_reader *walk, const murk_yaml *node,
                                   const char *what, const char *const *names,
                                   size_t n)
{
    char list[400] = "";
    size_t length = 0;
    for (size_t i = 0; i < n && length < sizeof list; ++i) {
        length += (size_t)snprintf(list + length, sizeof list - length, "%s%s",
                                   i ? ", " : "", names[i]);
    }
    return murk_walk_fail_key(walk, node, "%s, must be %s%s", what,
                              n > 1 ? "one of " : "", list);
}

int murk_keys_variants(const murk_keys *keys)
{
    int n = 0;
    while (keys->variant_names && keys->variant_names[n]) {
        ++n;
    }
    const murk_word *words =
        keys->selector ? murk_keys_find(keys, keys->selector)->words : NULL;
    while (words && words[n].text) {
        ++n;
    }
    return n > 0 ? n : 1;
}

const char *murk_keys_variant_name(const murk_keys *keys, int variant)
{
    if (!keys->selector) {
        return keys->variant_names ? keys->variant_names[variant] : NULL;
    }
    const murk_word *word = murk_keys_find(keys, keys->selector)->words;
    while (word->value != variant) {
        ++word;
    }
    return word->text;
}

murk_status murk_walk_check_names(murk_key_reader *walk, const murk_keys *keys,
                                  const murk_yaml *map, int variant)
{
    size_t i = 0;
    while (i < map->n && murk_walk_find(keys, map->key[i], variant)) {
        ++i;
    }
    if (i == map->n) {
        return MURK_OK;
    }
    /* Suggest a similar key, or list the allowed ones. */
    const char *names[MAX_KEYS];
    const size_t n = list_names(keys, variant, names);
    const char *meant =
        variant < 0 ? murk_words_meant(map->key[i], names, n) : NULL;
    char what[120] = "unknown key";
    murk_walk_enter(walk, map->key[i]);
    if (meant) {
        return murk_walk_fail_key(walk, map->child[i],
                                  "unknown key, did you mean %s?", meant);
    }
    if (variant >= 0) {
        snprintf(what, sizeof what, "not a key of a %s (%s)", keys->noun,
                 murk_keys_variant_name(keys, variant));
    }
    return fail_with_names(walk, map->child[i], what, names, n);
}

/* The keys of a group exclude each other. */
murk_status murk_walk_check_groups(murk_key_reader *walk, const murk_keys *keys,
                                   const murk_yaml *map)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        if (key->group == 0) {
            continue;
        }
        /* Find the keys of the group that are given. */
        const murk_key *given = NULL;
        for (const murk_key *other = keys->key; other->name; ++other) {
            if (other->group != key->group ||
                !murk_yaml_get(map, other->name)) {
                continue;
            }
            if (given) {
                return murk_walk_fail(walk, map,
                                      "has %s and %s, must have one of them",
                                      given->name, other->name);
            }
            given = other;
        }
        /* A required group without a key: list the group. */
        if (!given && key->required) {
            const char *names[MAX_KEYS];
            size_t n = 0;
            for (const murk_key *other = key; other->name; ++other) {
                if (other->group == key->group) {
                    names[n++] = other->name;
                }
            }
            char what[80];
            snprintf(what, sizeof what, "misses a key of a %s", keys->noun);
            return fail_with_names(walk, map, what, names, n);
        }
    }
    return MURK_OK;
}
