/* Reads names that refer to materials and media of the scene, with a
 * suggestion for misspelled names. */
#include "scene/value.h"

#include <stdio.h>
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
        return murk_walk_fail(walk, node, "%s is not in %s, did you mean %s?",
                              found, key->of, shown);
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
    return murk_walk_fail(walk, node,
                          "%s is not in %s, must be a name given there: %s",
                          found, key->of, n ? list : "there are none");
}

murk_status murk_value_reference(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, void *member)
{
    if (node->kind != MURK_YAML_SCALAR || node->text[0] == '\0') {
        return murk_value_wrong(walk, key, node);
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
    if (key->size == sizeof(int)) {
        *(int *)member = (int)i;
    } else {
        *(size_t *)member = i;
    }
    return MURK_OK;
}
