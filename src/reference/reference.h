/* The reference of keys: finds a key by its path in the key table of scenes or
 * of studies, and the meaning of the key in the tables of doc/reference. Above
 * each table of keys a comment names the maps whose keys the table lists:
 *
 *   <!-- keys of sensors.types.view -->
 *
 * "scene" stands for the top level, "study" for a study file. Text between that
 * comment and the table is the introduction of the table. */
#ifndef MURK_REFERENCE_REFERENCE_H
#define MURK_REFERENCE_REFERENCE_H

#include "scene/keys.h"

#define MURK_REFERENCE_PATH_SIZE 160 /* of the deepest key */

typedef struct murk_reference_key {
    const murk_keys *table; /* the table that has the row; NULL: the key was not
                               found */
    const murk_key *row;    /* the first of its name */
    char path[MURK_REFERENCE_PATH_SIZE]; /* "media.*.extinction_per_m" */
    bool is_settable; /* of a key that is visited: it is no map, and all keys
                       * above it are maps of one kind, so that the path holds
                       * no numbers or names of a scene */
    /* If the key was not found: the part of the path that is unknown, and the
     * table in which it was looked up (NULL: the key above has no table). */
    const char *unknown;
    const murk_keys *looked_up;
} murk_reference_key;

/* Finds a key by its path in the table `root`, murk_scene_keys or
 * murk_study_keys. Items of lists and maps of names are given by their number
 * or name, by "*", or not at all: lights.0.power_w, media.fog.albedo,
 * media.*.albedo, media.albedo. */
murk_reference_key murk_reference_find(const murk_keys *root, const char *path);

/* Calls a function for each key of the table `root` and of the tables below it:
 * a key before the keys of its map, and of rows with the same name the first.
 */
typedef void murk_reference_visit(void *context, const murk_reference_key *key);
void murk_reference_visit_all(const murk_keys *root,
                              murk_reference_visit *visit, void *context);

/* The meaning of a row, and its default as the table of the reference states
 * it ("-": none), without marks of Markdown; NULL: the table has no such
 * row, or out of memory. The caller frees the text. */
char *murk_reference_meaning(const murk_keys *table, const murk_key *row);
char *murk_reference_default(const murk_keys *table, const murk_key *row);

/* The introduction of a table, likewise; NULL: none. */
char *murk_reference_introduction(const murk_keys *table);

#endif
