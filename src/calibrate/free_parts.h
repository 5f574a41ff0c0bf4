/* What free keys are made of, and how they are put into a scene. Private to
 * free_keys. */
#ifndef MURK_CALIBRATE_FREE_PARTS_H
#define MURK_CALIBRATE_FREE_PARTS_H

#include "calibrate/free_keys.h"
#include "scene/yaml.h"

struct murk_free_spot {
    char *source;     /* "--free media.fog.albedo.0", for messages */
    char *put;        /* path that is put: the key's, or that of its list, since
                         lists may stand there by default alone */
    size_t index;     /* in the list */
    bool *is_in;      /* [conditions] whether the key is there */
    murk_yaml **list; /* [conditions] the list there; all NULL: no list */
    double step;      /* of differences, as a share of the value's size */
};

/* Room for one key; false when out of memory. */
bool murk_free_spot_make(murk_free_spot *spot, const char *name,
                         size_t conditions);
void murk_free_spot_release(murk_free_spot *spot, size_t conditions);

/* The scene of condition c as it stands, or with values: NULL for none. */
murk_status murk_free_spot_scene(murk_scene_desc **out,
                                 const murk_free_keys *keys, size_t c,
                                 const double *value, murk_error *err);

/* Steps of murk_free_keys_create: fills condition[], its names and the file's
 * checksum; */
murk_status murk_free_find_conditions(murk_free_keys *keys, murk_error *err);
/* key[] with names and paths alone, a spot[] for each; */
murk_status murk_free_add_all(murk_free_keys *keys, murk_error *err);
/* all of key k, a gain; */
murk_status murk_free_place_gain(murk_free_keys *keys, size_t k,
                                 murk_error *err);
/* and refuses relative light of gains that are not free. */
murk_status murk_free_check_gains(const murk_free_keys *keys, murk_error *err);

#endif
