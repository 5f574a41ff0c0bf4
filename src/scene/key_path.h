/* Follows the path of a key, such as media.fog.albedo or lights.0.power_w,
 * through the tree of a scene and the key table at the same time. Callers that
 * only read and callers that change the tree share these steps. */
#ifndef MURK_SCENE_KEY_PATH_H
#define MURK_SCENE_KEY_PATH_H

#include "scene/keys.h"

/* A position on a path: a node, and the row of the key table for it. */
typedef struct murk_key_position {
    murk_yaml *node;
    const murk_key *row; /* NULL: none; the row of the scene has no name */
    bool in_item;        /* the node is an item of the list of the row, or one
                          * of the names of the row */
} murk_key_position;

/* The position of the whole scene. */
murk_key_position murk_key_path_root(murk_yaml *root);

/* True if the keys of the node are those of row->keys. False for a list and
 * for a map of names, and if the row has no keys. */
bool murk_key_path_is_map(const murk_key_position *at);

/* Length of the first part of a path. A name with dots is one part if the
 * map has that name. In a map that allows any key the whole rest is one
 * part. */
size_t murk_key_path_part(const murk_key_position *at, const char *path);

/* The position of a member of a map or a list. `part` is that part of the path
 * alone, ended by '\0'. `child` is the node of the member, which the caller
 * finds or makes (NULL to ask for the row only). For a key of a map the row is
 * that of the key, NULL if the table does not have the key; for an item of a
 * list, or a name, the row is that of the list or the names. */
murk_key_position murk_key_path_member(const murk_key_position *at,
                                       const char *part, murk_yaml *child);

/* The position at the end of a path of keys, indices and names. Its node is
 * NULL if the tree has none there, its row if the table has none. */
murk_key_position murk_key_path_find(murk_yaml *root, const char *path);

/* Finds an item of a list by its index, or by the value of its key `name`.
 * False, with *index undefined, if there is none. */
bool murk_key_path_item(const murk_yaml *list, const char *part, size_t *index);

/* Replaces one value for all bands by a list with the value for each of
 * `bands`, so that a single band can be set: a resolved scene contains equal
 * values of all bands only once. False if the node is no such value, or when
 * out of memory, which may leave the list incomplete. */
bool murk_key_path_spread(const murk_key_position *at, size_t bands);

#endif
