/* The reference of keys as JSON: the values, unit, default and meaning of one
 * key, and the keys of its map. Without memory, parts may be missing. */
#ifndef MURK_REFERENCE_ENTRIES_H
#define MURK_REFERENCE_ENTRIES_H

#include "results/json.h"
#include "scene/keys.h"

/* *out: the keys of the top level of the table `root`, murk_scene_keys or
 * murk_study_keys, and a list of all keys below; the caller deletes it. */
void murk_reference_all(cJSON **out, const murk_keys *root);

/* *out: the key at a path of the table `root` (murk_reference_find()), and the
 * keys of its map. Fails with MURK_BAD_VALUE at the path if there is no such
 * key; the message suggests a key that is spelled alike, or keys of the same
 * name in other maps. */
murk_status murk_reference_one(cJSON **out, const murk_keys *root,
                               const char *path, murk_error *err);

#endif
