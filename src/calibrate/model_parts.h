/* The internal structure of the forward model. Internal to this room. */
#ifndef MURK_CALIBRATE_MODEL_PARTS_H
#define MURK_CALIBRATE_MODEL_PARTS_H

#include "calibrate/lit.h"
#include "calibrate/model.h"

/* One condition. */
typedef struct murk_model_world {
    murk_scene_desc *scene; /* at the start values */
    murk_instruments instruments;
    size_t *medium; /* [scene->n_media]; media that keys re-weight */
    murk_lit_desc desc;
    murk_lit lit;
    murk_lit_rows rows;  /* at the last prediction */
    double *world_slope; /* [lit][keys]; slopes of world keys at the traced
                          * values */
    bool has_world_keys; /* keys change the world of this condition */
} murk_model_world;

struct murk_model {
    murk_model_desc desc;
    size_t n, rows;          /* number of keys, and of rows of the data */
    murk_model_world *world; /* [keys->conditions] */
    size_t worlds;
    double *traced; /* [n]; values at which light was traced */
    double
        *slope_off; /* [n]; sum of squared errors of the slopes of a world key
                     */
    double *slope_size; /* [n]; sum of squares of these slopes */
    double *factor;     /* [rows]; factor of readings at the last prediction */
    size_t *gain_key;   /* [rows]; the key of the factor; n: none */
    size_t *lit;        /* [lits]; rows that need light, rising */
    size_t *place;      /* [rows]; index in lit */
    size_t lits;
    size_t batches, runs;
    size_t traces;
    bool was_built;
    double memory_bytes; /* forecast; 0: not yet */
    uint64_t photons;
    double trace_s;
};

/* Optics at two values of each key that re-weights a condition; low is NULL for
 * other keys. */
typedef struct murk_sides {
    murk_optics_sides *side;   /* [keys] */
    murk_optics **low, **high; /* [keys] owned */
} murk_sides;

static inline bool murk_model_turns_world(const murk_model *m, size_t k,
                                          size_t c)
{
    const murk_free_keys *keys = m->desc.keys;
    return keys->key[k].kind == MURK_FREE_WORLD &&
           murk_free_key_is_in(keys, k, c);
}

/* True if the slope with respect to key k comes from re-weighting. */
static inline bool murk_model_reweighs(const murk_model *m, size_t k, size_t c)
{
    const murk_free_keys *keys = m->desc.keys;
    const murk_free_kind kind = keys->key[k].kind;
    return (kind == MURK_FREE_MEDIUM || kind == MURK_FREE_LIGHT) &&
           murk_free_key_is_in(keys, k, c);
}

/* Fills the optics at two values of each key. Release also after a failure. */
murk_status murk_model_look_around(murk_sides *out, const murk_model *m,
                                   size_t c, const double *value,
                                   murk_error *err);
void murk_sides_release(murk_sides *s, size_t n);

#endif
