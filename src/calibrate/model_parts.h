/* What the forward model is made of; inside this room only. */
#ifndef MURK_CALIBRATE_MODEL_PARTS_H
#define MURK_CALIBRATE_MODEL_PARTS_H

#include "calibrate/lit.h"
#include "calibrate/model.h"

/* One condition. */
typedef struct murk_model_world {
    murk_scene_desc *scene; /* at the start */
    murk_instruments instruments;
    size_t *medium; /* [scene->n_media] that keys re-weight */
    murk_lit_desc desc;
    murk_lit lit;
    murk_lit_rows rows;  /* as predicted last */
    double *world_slope; /* [lit][keys] of world keys, at what was traced */
    bool has_world_keys; /* that turn its light */
} murk_model_world;

struct murk_model {
    murk_model_desc desc;
    size_t n, rows;          /* keys, rows of the data */
    murk_model_world *world; /* [keys->conditions] */
    size_t worlds;
    double *traced; /* [n] where light was traced */
    double
        *slope_off; /* [n] sums of squares: errors of a world key's slopes, */
    double *slope_size; /* [n] and the slopes */
    double *factor;     /* [rows] gain, as predicted last */
    size_t *gain_key;   /* [rows] the key that it is; n: none */
    size_t *lit;        /* [lits] rows of light, rising */
    size_t *place;      /* [rows] number in lit */
    size_t lits;
    size_t batches, runs;
    size_t traces;
    bool was_built;
    double memory_bytes; /* foretold; 0: not yet */
    uint64_t photons;
    double trace_s;
};

/* Optics at two values of each key that re-weights a condition; low NULL for
 * the others. */
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

/* Of its own two sides re-weighting makes a slope. */
static inline bool murk_model_reweighs(const murk_model *m, size_t k, size_t c)
{
    const murk_free_keys *keys = m->desc.keys;
    const murk_free_kind kind = keys->key[k].kind;
    return (kind == MURK_FREE_MEDIUM || kind == MURK_FREE_LIGHT) &&
           murk_free_key_is_in(keys, k, c);
}

/* Release also after a failure. */
murk_status murk_model_look_around(murk_sides *out, const murk_model *m,
                                   size_t c, const double *value,
                                   murk_error *err);
void murk_sides_release(murk_sides *s, size_t n);

#endif
