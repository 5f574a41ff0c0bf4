/* Checks the keys of a map: known names, names of the map's variant, and
 * groups of keys that exclude each other. */
#ifndef MURK_SCENE_WALK_NAMES_H
#define MURK_SCENE_WALK_NAMES_H

#include "scene/walk.h"

/* murk_walk_fits(): true if a row belongs to a variant. murk_walk_find(): the
 * first row with a name that belongs to a variant; NULL if there is none. A
 * variant of -1 stands for any. */
bool murk_walk_fits(const murk_key *key, int variant);
const murk_key *murk_walk_find(const murk_keys *keys, const char *name,
                               int variant);

/* Checks that every key of the map has a row in the table that belongs to the
 * variant (-1: to any); otherwise fails with MURK_BAD_VALUE. */
murk_status murk_walk_check_names(murk_key_reader *walk, const murk_keys *keys,
                                  const murk_yaml *map, int variant);

/* Checks that the map has at most one key of each group, and one of each
 * required group; otherwise fails with MURK_BAD_VALUE. */
murk_status murk_walk_check_groups(murk_key_reader *walk, const murk_keys *keys,
                                   const murk_yaml *map);

#endif
