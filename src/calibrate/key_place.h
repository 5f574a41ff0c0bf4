/* Where a key stands in a scene: its number, and its row of the table of keys.
 * Private to free_keys. */
#ifndef MURK_CALIBRATE_KEY_PLACE_H
#define MURK_CALIBRATE_KEY_PLACE_H

#include "scene/keys.h"

typedef struct murk_key_place {
    double value;
    const murk_yaml *node; /* that it is written in */
    const murk_key *row;   /* of an item of a list: the list's */
    const murk_key *item;  /* of a list in which each has a row of its own */
    const murk_yaml *list; /* that it is an item of; NULL: of none */
    size_t index;          /* in it */
    size_t put;            /* bytes of the path up to the list's key; without
                              list: all of them */
    const murk_yaml
        *medium; /* map of the medium that it is a key of; or NULL */
} murk_key_place;

/* Finds a path in a scene as resolved (scene->resolved, parsed), where all
 * defaults are written. Fails at `where` when there is nothing, or no single
 * number that may be any. What is found points into `root` and the table. */
murk_status murk_key_place_find(murk_key_place *out, const murk_yaml *root,
                                const char *path, const char *where,
                                murk_error *err);

/* Where the path is an item, below `bands`, of what is one value for all bands,
 * writes that value out for each: a scene as resolved says once what may have
 * been listed. False where it is not so, or without memory. */
bool murk_key_place_spread(murk_yaml *root, const char *path, int bands);

#endif
