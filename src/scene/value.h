/* Reads one value of a scene: checks it by the row of the key table, stores
 * it in the member of the struct, and rewrites the node in the canonical
 * form in which it is printed. */
#ifndef MURK_SCENE_VALUE_H
#define MURK_SCENE_VALUE_H

#include "scene/walk.h"

/* Reads a value of any kind of murk_key_kind but MAP, PER_BAND, LIST, MAPS and
 * NAMED; a WORD fails, because murk_walk_value() has read the words. `item` is
 * the struct that key->at refers to. */
murk_status murk_value_read(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item);

/* Fails with a message that states the value found and the values that the
 * row allows. */
murk_status murk_value_wrong(murk_key_reader *walk, const murk_key *key,
                             const murk_yaml *node);

/* Sets *value (unless `value` is NULL) to the value of the word in a node.
 * Fails as murk_value_wrong() does if the node is none of key->words. */
murk_status murk_value_word(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, int *value);

/* The path by which the program opens the file that a node names. A name from
 * the command line, or from a call of the library that sets a key, is relative
 * to the working folder, any other name to the folder of the file that has the
 * node. "memory:NAME" and absolute paths are returned as they are. NULL when
 * out of memory; the caller frees the path with free(). */
char *murk_value_opened(const murk_yaml *node);

/* Stores a value in a member that is an enum, a bool or a char; stores nothing
 * in a member of another size. */
void murk_value_store(void *item, size_t at, size_t size, int value);

/* Describes a node for a message: the text (shortened to fit), or "a list", "an
 * empty map", "nothing" and so on. */
#define MURK_FOUND_SIZE 48
void murk_value_found(const murk_yaml *node, char out[MURK_FOUND_SIZE]);

/* Describes the values that a row allows: "a number, 0..1", "[x, y, z], each
 * -1e9..1e9 m". */
#define MURK_ALLOWED_SIZE 256
void murk_value_allowed(const murk_key *key, char out[MURK_ALLOWED_SIZE]);
/* Largest length of a text in bytes: key->max if that is above 0, else 63 for a
 * murk_scene_name and 255 for other texts. */
size_t murk_value_max_bytes(const murk_key *key);
/* Describes the range of a row: "0..1". */
void murk_value_range(const murk_key *key, char *out, size_t size);

#endif
