/* One value of a scene: checked by its row of the table, stored in its member,
 * and rewritten in the one form in which it prints. */
#ifndef MURK_SCENE_VALUE_H
#define MURK_SCENE_VALUE_H

#include "scene/walk.h"

/* All kinds but maps, lists and names. `item` is the struct of key->at. */
murk_status murk_value_read(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item);

/* Names among those of key->of: one, or a list of them (or one of key->words,
 * which leaves *out as it is). out->index is the caller's: free(). */
murk_status murk_value_reference(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, void *member);
murk_status murk_value_references(murk_key_reader *walk, const murk_key *key,
                                  murk_yaml *node, murk_scene_indices *out);

/* Fails: what was found, and what the row allows. */
murk_status murk_value_wrong(murk_key_reader *walk, const murk_key *key,
                             const murk_yaml *node);

/* The value of the word that a node is, in *value (which may be NULL). */
murk_status murk_value_word(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, int *value);

/* The file that a node names, as it is to be opened: in a scene it lies beside
 * it, on the command line it is seen from the working folder, in any other file
 * it lies beside that. NULL when out of memory; free() it. */
char *murk_value_opened(const murk_yaml *node, const murk_yaml *root,
                        const char *scene_path);

/* Stores an enum, bool or char. */
void murk_value_store(void *item, size_t at, size_t size, int value);

/* A node for a message: its text, or "a list", "a map", "nothing". */
#define MURK_FOUND_SIZE 48
void murk_value_found(const murk_yaml *node, char out[MURK_FOUND_SIZE]);

/* What a row allows: "a number, 0..1", "[x, y, z], each -1e9..1e9 m". */
#define MURK_ALLOWED_SIZE 256
void murk_value_allowed(const murk_key *key, char out[MURK_ALLOWED_SIZE]);
/* Of a text: 63 for names, more for those of files' parts. */
size_t murk_value_max_bytes(const murk_key *key);
/* Its range alone: "0..1". */
void murk_value_range(const murk_key *key, char *out, size_t size);

#endif
