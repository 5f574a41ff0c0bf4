/* The parameters of a fit: keys of the scene, with one value for all conditions
 * or one for each, and free factors of readings.
 *
 * The effect of a key is found by reading the scene at two values of the key
 * and comparing: the key may change the optics of media alone, the power of
 * light sources alone, or the world itself. */
#ifndef MURK_CALIBRATE_FREE_KEYS_H
#define MURK_CALIBRATE_FREE_KEYS_H

#include "base/arena.h"
#include "calibrate/imported_stages.h"
#include "calibrate/optics.h"
#include "readings/readings.h"
#include "scene/yaml.h"

/* Limit on the parameters of a fit, far above the number that readings of the
 * field determine. */
#define MURK_FREE_MAX 512

/* The start of the place in messages about free keys, such as "keys KEY";
 * `keys` is the argument of murk_fit_create() (murk.h) that lists them. */
#define MURK_FREE_PLACE "keys"

typedef enum murk_free_kind {
    MURK_FREE_MEDIUM, /* extinction, albedo, phase function of media:
                       * re-weighted */
    MURK_FREE_LIGHT,  /* power alone: scaled */
    MURK_FREE_GAIN,   /* a factor of readings */
    MURK_FREE_WORLD   /* anything else: light is traced again */
} murk_free_kind;

typedef struct murk_free_key {
    char name[232]; /* for the user: "media.fog.visibility_m", one value for all
                     * conditions; "media.fog.visibility_m@dawn", the value of
                     * a condition; @scene: of the scene without a condition;
                     * "gain.NAME" for a factor of readings */
    char path[160]; /* key of the scene; empty for a factor of readings */
    size_t condition; /* index into keys->condition[]; SIZE_MAX: all conditions
                       * that have the key */
    size_t gain;      /* index into measured->gain[]; SIZE_MAX: a key of the
                       * scene, not a factor */
    murk_free_kind kind;
    double start, lower, upper; /* in the unit of the key; limits may be
                                 * infinite; lower may be 0 also for a key that
                                 * is searched in logarithms */
    bool is_log;                /* the search uses the logarithm */
    bool turns_phase;           /* changes the phase function of a medium, so
                                 * cosines are needed */
    bool *is_in;                /* [conditions]; true if the condition has the
                                 * key, or readings with the factor */
    /* Internal: the place of the key in the scene. */
    char *source;     /* "keys media.fog.albedo.0", for messages */
    char *put;        /* path that is set: that of the key, or of the list that
                       * contains the key; the whole list is set, because the
                       * scene file may not contain a list that is a default */
    size_t index;     /* index in the list */
    murk_yaml **list; /* [conditions]; the list; NULL in conditions without the
                       * key, and everywhere if the key is not in a list */
    double step;      /* step of differences relative to the size of the value
                         (murk_free_key_around()) */
} murk_free_key;

typedef struct murk_free_desc {
    const char *scene_path;
    const murk_override *overrides;
    size_t n_overrides;
    const char *const *asked; /* [n_asked]; "KEY", "KEY@each", "gain.NAME" */
    size_t n_asked;
    const char *const *bounds; /* [n_bounds]; "KEY=LOW:HIGH", either may be
                                * empty */
    size_t n_bounds;
    bool may_be_none; /* true: a prediction at the values of the scene needs no
                       * parameter */
    const murk_readings *measured;
    const murk_domain *domain;
    const murk_imported_stages *imported; /* of the scene, whose files no free
                                           * key changes; NULL if no medium has
                                           * `effective_variance` */
} murk_free_desc;

typedef struct murk_free_keys {
    size_t n;
    murk_free_key *key; /* [n] */
    int bands;          /* of the scene */
    size_t conditions;  /* conditions that the data use; each is a scene of its
                         * own */
    size_t *condition;  /* [conditions]; numbers of the conditions in the scene,
                         * rising; SIZE_MAX, which comes first: the scene
                         * without a condition */
    murk_scene_name *condition_name; /* [conditions]; empty for the scene
                                      * without a condition */
    murk_free_desc desc;             /* the objects that it points to must
                                      * outlive this struct */
    double **power_w; /* [conditions]; internal: powers of all light sources by
                       * band at the start, or NULL if a free key may change
                       * them */
    char sha256[65];  /* of the scene file, which must not change during a fit
                       */
    murk_arena arena; /* of all arrays */
} murk_free_keys;

/* Finds and checks the parameters. Start values are those of the scene, or of
 * the first used condition that has the key; with @each, of each condition. A
 * free key overrides the value that a condition sets. A condition without the
 * key (because it has another medium in its place) is not affected, which a
 * note states. The range of a key is that of murk_key_range_of()
 * (calibrate/key_place.h), narrowed by `bounds`.
 *
 * Fails for unknown keys (with a suggestion), keys that are not a single
 * number, keys of anything but media, regions, lights and site, factors that no
 * reading names, readings whose unit needs a free factor that is not among the
 * keys, a key that is given twice or has no effect, no parameter (unless
 * may_be_none), more parameters than fitted rows or than MURK_FREE_MAX, a
 * factor whose readings are all held out, bounds that are malformed, outside
 * the range or of no free key, starts outside the bounds, and a start with
 * albedo, extinction or power 0, which cannot be re-weighted: all
 * MURK_BAD_VALUE, at the option or the line of the data. Also fails as reading
 * the scene does, and with MURK_NO_MEMORY. The caller owns *out
 * (murk_free_keys_destroy()). The objects that desc points to must outlive
 * *out. */
murk_status murk_free_keys_create(murk_free_keys **out,
                                  const murk_free_desc *desc, murk_error *err);
void murk_free_keys_destroy(murk_free_keys *keys); /* NULL is fine */

/* The scene of condition c (an index into keys->condition) at value[keys->n],
 * or unchanged if value is NULL; and its optics. Both fail at "keys KEY" if the
 * scene does not accept a value, and with MURK_BAD_FILE if the scene file was
 * changed; they print no warnings. The caller owns *out. */
murk_status murk_free_scene(murk_scene_desc **out, const murk_free_keys *keys,
                            size_t c, const double *value, murk_error *err);
murk_status murk_free_optics(murk_optics **out, const murk_free_keys *keys,
                             size_t c, const double *value, murk_error *err);

/* Two values *low <= `value` <= *high of key k, within the range of the key,
 * for the derivative df/dvalue = (f(high) - f(low)) / (high - low). The full
 * distance from `value` is key->step times the size of the value. The step is
 * 1e-5, with a relative error of the derivative of some 1e-9, or 2e-2 for keys
 * that change tabulated phase functions, because their nodes are accurate to
 * 1e-5 only. The size of the value is `value` for keys with is_log, else the
 * absolute value or, if larger, the smaller of 1 and the width of the range.
 *
 * *low and *high are equally far from `value`: by the full distance or, if a
 * limit of the range is nearer, by the distance of that limit, provided that
 * this is more than a quarter of the full distance. Otherwise one of them is
 * `value` itself. The other then is on the side with more space, at the full
 * distance or at the limit of the range. */
void murk_free_key_around(const murk_free_keys *keys, size_t k, double value,
                          double *low, double *high);

/* The same with `step` in place of key->step. */
void murk_free_key_beside(const murk_free_key *key, double step, double value,
                          double *low, double *high);

#endif
