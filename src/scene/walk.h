/* Traverses a scene's tree by the key table: checks it, fills the structs,
 * and completes the tree (defaults written out, keys in the order of the
 * table, numbers in one form), so that the tree prints as the resolved
 * scene. */
#ifndef MURK_SCENE_WALK_H
#define MURK_SCENE_WALK_H

#include "scene/keys.h"

/* Long enough for the deepest key with names of 63 bytes, outside of
 * conditions; longer keys are cut in messages. */
#define MURK_WALK_KEY_SIZE 160

struct murk_key_reader {
    murk_scene_desc *scene; /* NULL: the tree is no scene; its tables then have
                               no values per band and no references */
    murk_yaml *root;
    murk_error *err;
    char key[MURK_WALK_KEY_SIZE]; /* path of the current key:
                                   * "lights.0.power_w"; of no meaning after a
                                   * failure */
    murk_yaml **paths; /* nodes that name files, borrowed; the owner of the
                          reader frees the array */
    size_t n_paths;
};

/* Reads the whole tree by a table into an empty struct `item`. If the walk
 * already has a key, all keys in messages begin with it. */
murk_status murk_walk_root(murk_key_reader *walk, const murk_keys *keys,
                           void *item);

/* Reads one value, map or list under the current key, into the member of the
 * struct `item`. */
murk_status murk_walk_value(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item);

/* Turns the name of a file, short for a map, into {file: NAME}. False if there
 * is no memory. */
bool murk_walk_make_file_map(murk_yaml *node);

/* Reads the map of the current key by a table into the struct `item`. */
murk_status murk_walk_map(murk_key_reader *walk, const murk_keys *keys,
                          murk_yaml *map, void *item);

/* Adds the key `name` with the default `text` to a map. Defaults are parsed
 * from text, so that they are read like the values of the user. */
murk_status murk_walk_put_preset(murk_key_reader *walk, murk_yaml *map,
                                 const char *name, const char *text);

/* Appends a part, or the number of an item, to the current key. Returns the old
 * length, by which murk_walk_leave() restores the key. */
size_t murk_walk_enter(murk_key_reader *walk, const char *part);
size_t murk_walk_enter_item(murk_key_reader *walk, size_t index);
void murk_walk_leave(murk_key_reader *walk, size_t length);

/* Fails with MURK_BAD_VALUE at the place of a node and the current key:
 * "fog.yaml:12:13: media.fog.albedo". For maps and lists murk_walk_fail() takes
 * the place of the key of the node; murk_walk_fail_key() takes that place for
 * all nodes. */
murk_status murk_walk_fail(murk_key_reader *walk, const murk_yaml *node,
                           const char *format, ...)
    __attribute__((format(printf, 3, 4)));
murk_status murk_walk_fail_key(murk_key_reader *walk, const murk_yaml *node,
                               const char *format, ...)
    __attribute__((format(printf, 3, 4)));
murk_status murk_walk_no_memory(murk_key_reader *walk);

/* The place of a node: "FILE:LINE:COLUMN: KEY"; "FILE: KEY" for a node that is
 * not in the file; or the option of the command line or the call of the library
 * that sets the key, with ": KEY" unless these name the key. at_key: line and
 * column are those of the key of the node, as they are for maps and lists in
 * any case. */
void murk_walk_where(const murk_yaml *node, const char *key, bool at_key,
                     murk_scene_where out);

#endif
