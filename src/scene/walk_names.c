/* Checks which keys a map of the scene may have, with messages that list the
 * allowed keys or suggest a similar one. */
#include "scene/walk_names.h"

#include <stdio.h>
#include <string.h>

#include "scene/words.h"

#define MAX_KEYS 64 /* rows of one table that a message lists */

bool murk_walk_fits(const murk_key *key, int variant)
{
    return key->variants == 0 || (key->variants & (1u << variant)) != 0;
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

/* Lists the names that a map may have, each once. */
static size_t list_names(const murk_keys *keys, int variant,
                         const char *names[MAX_KEYS])
{
    size_t n = 0;
    for (const murk_key *key = keys->key; key->name; ++key) {
        bool is_new = variant < 0 || murk_walk_fits(key, variant);
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

static murk_status check_name(murk_key_reader *walk, const murk_keys *keys,
                              const char *name, const murk_yaml *child)
{
    const murk_key *key = murk_keys_find(keys, name);
    if (key) {
        return MURK_OK;
    }
    const char *names[MAX_KEYS];
    const char *meant =
        murk_words_meant(name, names, list_names(keys, -1, names));
    if (meant) {
        return murk_walk_fail_key(walk, child, "unknown key, did you mean %s?",
                                  meant);
    }
    return fail_with_names(walk, child, "unknown key", names,
                           list_names(keys, -1, names));
}

murk_status murk_walk_check_names(murk_key_reader *walk, const murk_keys *keys,
                                  const murk_yaml *map)
{
    for (size_t i = 0; i < map->n; ++i) {
        const size_t back = murk_walk_enter(walk, map->key[i]);
        const murk_status status =
            check_name(walk, keys, map->key[i], map->child[i]);
        murk_walk_leave(walk, back);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
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

murk_status murk_walk_check_variant(murk_key_reader *walk,
                                    const murk_keys *keys, const murk_yaml *map,
                                    int variant)
{
    for (size_t i = 0; i < map->n; ++i) {
        if (murk_walk_find(keys, map->key[i], variant)) {
            continue;
        }
        char what[120];
        const char *names[MAX_KEYS];
        const size_t n = list_names(keys, variant, names);
        snprintf(what, sizeof what, "not a key of a %s (%s)", keys->noun,
                 keys->variant_names[variant]);
        const size_t back = murk_walk_enter(walk, map->key[i]);
        const murk_status status =
            fail_with_names(walk, map->child[i], what, names, n);
        murk_walk_leave(walk, back);
        return status;
    }
    return MURK_OK;
}
