/* Goes through a scene's tree by the table of keys: checks it, fills the
 * structs, and completes the tree (defaults written out, keys in the table's
 * order, numbers in one form), so that it prints as the scene resolved. */
#ifndef MURK_SCENE_WALK_H
#define MURK_SCENE_WALK_H

#include "scene/keys.h"

#define MURK_WALK_KEY_SIZE 160

struct murk_key_reader {
    murk_scene_desc *scene;
    murk_yaml *root;
    murk_error *err;
    char key[MURK_WALK_KEY_SIZE]; /* where it is: "lights.0.power_w" */
    murk_yaml **paths; /* nodes that name files, borrowed; free() the array */
    size_t n_paths;
};

/* scene->path is set, all else is empty; a key that the walk has already goes
 * before all others. */
murk_status murk_walk_scene(murk_key_reader *walk);

/* One value, map or list under the walk's present key, into its member of the
 * struct `item`. */
murk_status murk_walk_value(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item);

/* Adds a part to the present key; gives back the length to return to by
 * murk_walk_leave(). */
size_t murk_walk_enter(murk_key_reader *walk, const char *part);
void murk_walk_leave(murk_key_reader *walk, size_t length);

/* Fails at a node under the walk's present key: "fog.yaml:12:13:
 * media.fog.albedo". For maps, lists, and all with `at_key`, the place is that
 * of its key. */
murk_status murk_walk_fail(murk_key_reader *walk, murk_status status,
                           const murk_yaml *node, bool at_key,
                           const char *format, ...)
    __attribute__((format(printf, 5, 6)));
murk_status murk_walk_no_memory(murk_key_reader *walk);

/* "FILE:LINE:COLUMN: KEY", or "FILE: KEY" of what is not in the file, or the
 * option of the command line. */
void murk_walk_where(const murk_yaml *node, const char *key, bool at_key,
                     murk_scene_where out);

#endif
