/* Which keys a map may have: known ones, of its variant, one of a group. */
#ifndef MURK_SCENE_WALK_NAMES_H
#define MURK_SCENE_WALK_NAMES_H

#include "scene/walk.h"

/* Whether a row is of that variant, and the row of that name and variant. */
bool murk_walk_fits(const murk_key *key, int variant);
const murk_key *murk_walk_find(const murk_keys *keys, const char *name,
                               int variant);

/* Every key is in the table, and supported. */
murk_status murk_walk_check_names(murk_key_reader *walk, const murk_keys *keys,
                                  const murk_yaml *map);

/* At most one key of each group, and one where the group is required. */
murk_status murk_walk_check_groups(murk_key_reader *walk, const murk_keys *keys,
                                   const murk_yaml *map);

/* Every key is one of the map's variant. */
murk_status murk_walk_check_variant(murk_key_reader *walk,
                                    const murk_keys *keys, const murk_yaml *map,
                                    int variant);

#endif
