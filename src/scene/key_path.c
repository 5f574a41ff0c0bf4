/* The steps along the path of a key (scene/key_path.h). */
#include "scene/key_path.h"

#include <string.h>

#include "base/number.h"

#define PART_SIZE 256 /* of one part of a path; names are shorter */

murk_key_position murk_key_path_root(murk_yaml *root)
{
    static const murk_key whole = {.kind = MURK_KEY_MAP,
                                   .keys = &murk_scene_keys};
    return (murk_key_position){root, &whole, false};
}

bool murk_key_path_is_map(const murk_key_position *at)
{
    if (!at->row || !at->row->keys) {
        return false;
    }
    const murk_key_kind kind = at->row->kind;
    const bool may_be_map =
        kind == MURK_KEY_PER_BAND || kind == MURK_KEY_SPECTRUM;
    return at->in_item || kind == MURK_KEY_MAP ||
           (may_be_map && at->node->kind != MURK_YAML_LIST);
}

size_t murk_key_path_part(const murk_key_position *at, const char *path)
{
    const murk_yaml *map = at->node;
    if (murk_key_path_is_map(at) && at->row->keys->is_open) {
        return strlen(path);
    }
    size_t length = strcspn(path, ".");
    for (size_t i = 0; map->kind == MURK_YAML_MAP && i < map->n; ++i) {
        const size_t n = strlen(map->key[i]);
        if (n > length && strncmp(path, map->key[i], n) == 0 &&
            (path[n] == '.' || path[n] == '\0')) {
            length = n;
        }
    }
    return length;
}

murk_key_position murk_key_path_member(const murk_key_position *at,
                                       const char *part, murk_yaml *child)
{
    return murk_key_path_is_map(at)
               ? (murk_key_position){child, murk_keys_find(at->row->keys, part),
                                     false}
               : (murk_key_position){child, at->row, true};
}

/* The child that `part` names; NULL if there is none. */
static murk_yaml *child_of(const murk_yaml *node, const char *part)
{
    size_t i;
    return node->kind == MURK_YAML_MAP ? murk_yaml_get(node, part)
           : node->kind == MURK_YAML_LIST && murk_key_path_item(node, part, &i)
               ? node->child[i]
               : NULL;
}

murk_key_position murk_key_path_find(murk_yaml *root, const char *path)
{
    static murk_yaml none = {.kind = MURK_YAML_MAP};
    murk_key_position at = murk_key_path_root(root);
    while (*path && (at.node || at.row)) {
        char part[PART_SIZE];
        at.node = at.node ? at.node : &none;
        const size_t length = murk_key_path_part(&at, path);
        if (length == 0 || length >= sizeof part) {
            return (murk_key_position){NULL, NULL, false};
        }
        memcpy(part, path, length);
        part[length] = '\0';
        at = murk_key_path_member(&at, part, child_of(at.node, part));
        path += length + (path[length] == '.');
    }
    return at;
}

bool murk_key_path_item(const murk_yaml *list, const char *part, size_t *index)
{
    uint64_t number;
    if (part[0] && strspn(part, "0123456789") == strlen(part) &&
        murk_count_parse(part, &number)) {
        *index = (size_t)number;
        return number < list->n;
    }
    for (size_t i = 0; i < list->n; ++i) {
        const murk_yaml *name = murk_yaml_get(list->child[i], "name");
        if (name && name->kind == MURK_YAML_SCALAR &&
            strcmp(name->text, part) == 0) {
            *index = i;
            return true;
        }
    }
    return false;
}

bool murk_key_path_spread(const murk_key_position *at, size_t bands)
{
    murk_yaml *node = at->node;
    if (node->kind != MURK_YAML_SCALAR || !at->row || at->in_item ||
        at->row->kind != MURK_KEY_SPECTRUM) {
        return false;
    }
    murk_yaml *one = murk_yaml_copy(node);
    bool is_whole = one != NULL;
    if (is_whole) {
        murk_yaml_clear(node);
        node->kind = MURK_YAML_LIST;
    }
    for (size_t b = 0; is_whole && b < bands; ++b) {
        murk_yaml *copy = murk_yaml_copy(one);
        is_whole = copy && murk_yaml_append(node, NULL, copy);
    }
    murk_yaml_destroy(one);
    return is_whole;
}
