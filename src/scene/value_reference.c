/* Reads names that refer to materials and media of the scene, with a
 * suggestion for misspelled names. */
#include "scene/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/words.h"

/* Fails for an unknown name: suggests a similar name, or lists all. */
static murk_status no_such_name(murk_key_reader *walk, const murk_key *key,
                                const murk_yaml *node, const murk_yaml *names)
{
    char found[MURK_FOUND_SIZE];
    murk_value_found(node, found);
    const size_t n = names ? names->n : 0;
    const char *meant =
        n ? murk_words_meant(node->text, (const char *const *)names->key, n)
          : NULL;
    if (meant) {
        char shown[MURK_SCENE_NAME_SIZE];
        murk_words_show(shown, sizeof shown, meant);
        return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                              "%s is not in %s, did you mean %s?", found,
                              key->of, shown);
    }
    /* List the names that exist, as far as the message has space. */
    char list[MURK_ALLOWED_SIZE] = "";
    size_t length = 0;
    for (size_t i = 0; i < n && length + 80 < sizeof list; ++i) {
        char shown[MURK_SCENE_NAME_SIZE];
        murk_words_show(shown, sizeof shown, names->key[i]);
        length += (size_t)snprintf(list + length, sizeof list - length, "%s%s",
                                   i ? ", " : "", shown);
    }
    return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                          "%s is not in %s, must be a name given there: %s",
                          found, key->of, n ? list : "there are none");
}

static murk_status find_name(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, size_t *index)
{
    if (node->kind != MURK_YAML_SCALAR || node->text[0] == '\0') {
        murk_key one = *key; /* an item of a list is a name, too */
        one.kind = MURK_KEY_REFERENCE;
        return murk_value_wrong(walk, &one, node);
    }
    const murk_yaml *names = murk_yaml_get(walk->root, key->of);
    const size_t n = names ? names->n : 0;
    size_t i = 0;
    while (i < n && strcmp(names->key[i], node->text) != 0) {
        ++i;
    }
    if (i == n) {
        return no_such_name(walk, key, node, names);
    }
    node->is_quoted = true;
    *index = i;
    return MURK_OK;
}

murk_status murk_value_reference(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, void *member)
{
    size_t i = 0;
    const murk_status status = find_name(walk, key, node, &i);
    if (!status && key->size == sizeof(int)) {
        *(int *)member = (int)i;
    } else if (!status) {
        *(size_t *)member = i;
    }
    return status;
}

murk_status murk_value_references(murk_key_reader *walk, const murk_key *key,
                                  murk_yaml *node, murk_scene_indices *out)
{
    if (node->kind == MURK_YAML_SCALAR && key->words) {
        return murk_value_word(walk, key, node, NULL);
    }
    if (node->kind != MURK_YAML_LIST || node->n == 0) {
        return murk_value_wrong(walk, key, node);
    }
    if (node->n > MURK_SCENE_LIST_MAX) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                              "a list of %zu, must be at most %d", node->n,
                              MURK_SCENE_LIST_MAX);
    }
    /* Find each name of the list. */
    out->index = calloc(node->n, sizeof *out->index);
    if (!out->index) {
        return murk_walk_no_memory(walk);
    }
    out->n = node->n;
    for (size_t i = 0; i < node->n; ++i) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        const size_t back = murk_walk_enter(walk, number);
        const murk_status status =
            find_name(walk, key, node->child[i], &out->index[i]);
        murk_walk_leave(walk, back);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}
