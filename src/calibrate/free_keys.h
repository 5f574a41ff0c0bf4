/* The parameters of a fit: keys of the scene, one value for all conditions or
 * one for each, and free factors of readings.
 *
 * What a key does is found by reading the scene at two of its values and
 * comparing: whether it turns the optics of media alone, the power of lights
 * alone, or the world itself. */
#ifndef MURK_CALIBRATE_FREE_KEYS_H
#define MURK_CALIBRATE_FREE_KEYS_H

#include "calibrate/measurements.h"
#include "calibrate/optics.h"

#define MURK_FREE_MAX 512

typedef enum murk_free_kind {
    MURK_FREE_MEDIUM, /* extinction, albedo, phase of media: re-weighted */
    MURK_FREE_LIGHT,  /* power alone: scales */
    MURK_FREE_GAIN,   /* a factor of readings */
    MURK_FREE_WORLD   /* anything else: light is traced again */
} murk_free_kind;

typedef struct murk_free_key {
    char name[232];   /* for people: "media.fog.visibility_m@dawn"; @scene: of
                         the scene as it stands */
    char path[160];   /* of the scene's key; empty: a gain */
    size_t condition; /* that it is for, of keys->condition[]; SIZE_MAX: all
                         that have the key */
    size_t gain;      /* of the readings' gains; SIZE_MAX: a key */
    murk_free_kind kind;
    double start, lower, upper; /* in the key's own unit; ends may be infinite,
                                   lower is 0 of what runs over its logarithm */
    bool is_log;                /* the search runs over its logarithm */
    bool turns_phase;           /* of a medium: its cosines matter */
} murk_free_key;

typedef struct murk_free_desc {
    const char *scene_path;
    const murk_override *overrides;
    size_t n_overrides;
    const char *const *asked; /* [n_asked] "KEY", "KEY@each", "gain.NAME" */
    size_t n_asked;
    const char *const *bounds; /* [n_bounds] "KEY=LOW:HIGH", either may be
                                  empty */
    size_t n_bounds;
    const murk_measurements *measured;
    const murk_domain *domain;
} murk_free_desc;

typedef struct murk_free_spot murk_free_spot; /* where a key is put */

typedef struct murk_free_keys {
    size_t n;
    murk_free_key *key; /* [n] */
    int bands;          /* of the scene */
    size_t conditions;  /* in use by the data; each a scene of its own */
    size_t *condition;  /* [conditions] of the scene's, rising; SIZE_MAX: as it
                           stands, first */
    murk_scene_name *condition_name; /* [conditions]; empty: as it stands */
    murk_free_desc desc;             /* what it points to must outlive this */
    murk_free_spot *spot;            /* [n] private */
    double **power_w; /* [conditions] private: of channels, where no key has
                         a say in them; else NULL */
    char sha256[65];  /* of the scene's file, which must stay as it is */
} murk_free_keys;

/* Starts are the values of the scene, or of the first condition in use that has
 * the key; with @each, of each condition. What a condition sets itself gives
 * way to a free key; one that has no such key (it puts another medium there) is
 * left alone, which a note says. Ranges: key_range.h, within `bounds`.
 *
 * Refuses: unknown keys ("did you mean"), keys that are no single number, keys
 * of anything but media, regions, lights and site, gains that no reading names,
 * relative light whose gain is not free, a key asked for twice or without
 * effect, more parameters than rows, starts outside the bounds, and a start of
 * albedo, extinction or power 0, which cannot be re-weighted. *out is the
 * caller's. */
murk_status murk_free_keys_create(murk_free_keys **out,
                                  const murk_free_desc *desc, murk_error *err);
void murk_free_keys_destroy(murk_free_keys *keys); /* NULL is fine */

/* The scene of condition c (an index into keys->condition) at value[n]; and its
 * optics. Fails at "--free KEY" where the scene does not take a value. No
 * warnings. */
murk_status murk_free_scene(murk_scene_desc **out, const murk_free_keys *keys,
                            size_t c, const double *value, murk_error *err);
murk_status murk_free_optics(murk_optics **out, const murk_free_keys *keys,
                             size_t c, const double *value, murk_error *err);

/* Whether key k has a say in condition c. */
bool murk_free_key_is_in(const murk_free_keys *keys, size_t k, size_t c);

/* Two values around value[k], within its bounds, for differences: d/dvalue =
 * (f(high) - f(low)) / (high - low); equal distances where the bounds allow, at
 * a bound both on one side. 1e-5 of its size apart: some 1e-9 off; of keys that
 * turn tabulated phase functions, whose nodes are right to 1e-5, 2e-2. */
void murk_free_key_around(const murk_free_keys *keys, size_t k, double value,
                          double *low, double *high);

#endif
