/* Reads maps or words that may be given per band, such as phase functions,
 * into an array of structs. */
#include "scene/walk_bands.h"

#include <stdio.h>
#include <string.h>

/* Checks that an item of a list of bands has no values per band of its own. */
static murk_status check_one_band(murk_key_reader *walk, const murk_keys *keys,
                                  const murk_yaml *item)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; item->kind == MURK_YAML_MAP && i < item->n && !status;
         ++i) {
        const murk_key *key = murk_keys_find(keys, item->key[i]);
        if (key && key->kind == MURK_KEY_SPECTRUM &&
            item->child[i]->kind == MURK_YAML_LIST) {
            const size_t back = murk_walk_enter(walk, key->name);
            status = murk_walk_fail(walk, MURK_BAD_VALUE, item->child[i], false,
                                    "a list inside a list of bands, must be "
                                    "one number");
            murk_walk_leave(walk, back);
        }
    }
    return status;
}

murk_status murk_walk_bands(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *owner)
{
    const murk_keys *keys = key->keys;
    const murk_key one = {.name = key->name,
                          .kind = MURK_KEY_MAP,
                          .keys = keys,
                          .words = key->words,
                          .at = keys->variant_at,
                          .size = sizeof(int)};
    char *const items = (char *)owner + key->at;
    const bool is_list = node->kind == MURK_YAML_LIST;
    const size_t n = is_list ? node->n : 1;
    if (is_list && n != (size_t)walk->scene->bands) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                              "a list of %zu, must be one %s or a list of %d, "
                              "one a band",
                              n, keys->noun, walk->scene->bands);
    }
    /* Read each item of a list under its number, or the single item. */
    memcpy((char *)owner + keys->count_at, &n, sizeof n);
    murk_status status = MURK_OK;
    for (size_t i = 0; is_list && i < n && !status; ++i) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        const size_t back = murk_walk_enter(walk, number);
        status = check_one_band(walk, keys, node->child[i]);
        if (!status) {
            status = murk_walk_value(walk, &one, node->child[i],
                                     items + i * keys->item_size);
        }
        murk_walk_leave(walk, back);
    }
    return is_list ? status : murk_walk_value(walk, &one, node, items);
}
