/* The parts of free keys: their place in a scene, their names, and how values
 * are written into a scene. Internal to free_keys. */
#ifndef MURK_CALIBRATE_FREE_PARTS_H
#define MURK_CALIBRATE_FREE_PARTS_H

#include "calibrate/free_keys.h"
#include "scene/yaml.h"

struct murk_free_spot {
    char *source;     /* "--free media.fog.albedo.0", for messages */
    char *put;        /* path that is set: that of the key, or of the list that
                       * contains it, because a list may exist by default alone
                       */
    size_t index;     /* index in the list */
    bool *is_in;      /* [conditions]; true if the condition has the key */
    murk_yaml **list; /* [conditions]; the list; all NULL if the key is not in a
                       * list */
    double step;      /* step of differences relative to the size of the value
                       */
};

/* Allocates the place of one key; false when out of memory. */
bool murk_free_spot_make(murk_free_spot *spot, const char *name,
                         size_t conditions);
void murk_free_spot_release(murk_free_spot *spot, size_t conditions);

/* Reads the scene of condition c, with value[n], or unchanged if value is NULL.
 */
murk_status murk_free_spot_scene(murk_scene_desc **out,
                                 const murk_free_keys *keys, size_t c,
                                 const double *value, murk_error *err);

/* Steps of murk_free_keys_create(). Fills condition[], their names and the
 * checksum of the file. */
murk_status murk_free_find_conditions(murk_free_keys *keys, murk_error *err);
/* Fills key[] with names and paths, and a place for each. */
murk_status murk_free_add_all(murk_free_keys *keys, murk_error *err);
/* Completes key k, a factor of readings. */
murk_status murk_free_place_gain(murk_free_keys *keys, size_t k,
                                 murk_error *err);
/* Fails if readings of relative light have a factor that is not free. */
murk_status murk_free_check_gains(const murk_free_keys *keys, murk_error *err);

#endif
