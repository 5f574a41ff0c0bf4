/* Finds the place of a key in a scene: the number, the row of the key table,
 * and the range. Internal to free_keys. */
#ifndef MURK_CALIBRATE_KEY_PLACE_H
#define MURK_CALIBRATE_KEY_PLACE_H

#include "scene/keys.h"

typedef struct murk_key_place {
    double value;
    const murk_yaml *node; /* the node that has the value */
    const murk_key *row;   /* row of the key; for an item of a list, that of the
                            * list */
    const murk_key *item;  /* row of the item if each item of the list has a row
                            * of its own */
    const murk_yaml *list; /* the list that contains `node`; NULL: none */
    size_t index;          /* index in the list */
    size_t put;            /* length of the path without the index in the list;
                            * without a list, of the whole path */
    const murk_yaml *medium; /* map of the medium that the key belongs to; NULL:
                              * it is not a key of a medium */
} murk_key_place;

/* Finds a path in a resolved scene (scene->resolved, parsed), which contains
 * all defaults. If the path names one band of a value that is given once for
 * all `bands`, the value is replaced by a list with one item for each band.
 * Fails at `where` if the path does not exist, or if the value is not a single
 * number that may vary continuously. The result points into `root` and the key
 * table. */
murk_status murk_key_place_find(murk_key_place *out, murk_yaml *root, int bands,
                                const char *path, const char *where,
                                murk_error *err);

/* The range in which a fit may vary a key. */
typedef struct murk_key_range {
    double lower, upper;
    bool is_log; /* a positive scale: the search uses the logarithm */
} murk_key_range;

/* The range of the key table, for a word of presets narrowed to that of the
 * preset. A limit that the key may not reach (the cosines -1 and 1) is replaced
 * by a value that lies 1e-3 inside, except a lower limit 0 of a key that is
 * searched in logarithms. Limits of 1e9 and more only catch typing errors and
 * count as infinite. The last part of the path (without the index in a list) is
 * the name of the key. Fails as reading the preset does. */
murk_status murk_key_range_of(murk_key_range *out, const murk_key_place *place,
                              const char *path, const char *where,
                              murk_error *err);

#endif
