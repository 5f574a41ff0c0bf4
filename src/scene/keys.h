/* The table of every key of a scene: type, unit, range, default, and the
 * member of the struct in which the value is stored. A new key is one row in
 * keys_*.c and a member in scene.h. */
#ifndef MURK_SCENE_KEYS_H
#define MURK_SCENE_KEYS_H

#include "scene/scene.h"
#include "scene/yaml.h"

typedef enum murk_key_kind {
    MURK_KEY_NUMBER,    /* double, times `factor` */
    MURK_KEY_COUNT,     /* uint32_t, uint64_t or size_t */
    MURK_KEY_BOOL,      /* bool */
    MURK_KEY_WORD,      /* one of `words`: an enum, bool or char */
    MURK_KEY_TEXT,      /* murk_scene_name, or char * */
    MURK_KEY_PATH,      /* char *: path from the working folder */
    MURK_KEY_REFERENCE, /* index among the names of `of`: size_t, or int with -1
                           if absent */
    MURK_KEY_REFERENCES,  /* murk_scene_indices: a list of such names; or one of
                             `words` */
    MURK_KEY_VECTOR,      /* murk_vec3 */
    MURK_KEY_SIZES,       /* size_t[3] or [2], by the member's size */
    MURK_KEY_NUMBERS,     /* double[]: a list, one for each of `items` */
    MURK_KEY_BANDS,       /* 1..16 rising doubles: the scene's bands */
    MURK_KEY_BAND_EDGES,  /* 2..17 rising doubles: the scene's bands */
    MURK_KEY_NUMBER_LIST, /* murk_scene_numbers; or one of `words`: empty */
    MURK_KEY_TEXT_LIST,   /* murk_preset_texts */
    MURK_KEY_SPECTRUM_LIST, /* murk_scene_spectra: each as a spectrum */
    MURK_KEY_SPECTRUM, /* one value for all bands, or a list; or a map, if there
                          are `keys` */
    MURK_KEY_SHARED,   /* a total spread over the bands, or a list */
    MURK_KEY_MAP,      /* keys into the same struct; or one of `words` */
    MURK_KEY_PER_BAND, /* maps or words, one or a list, one a band: an array
                          of structs in the same struct */
    MURK_KEY_LIST,     /* maps: an array of structs */
    MURK_KEY_MAPS,     /* a map or a list of maps: an array of structs; or one
                          of `words`: none */
    MURK_KEY_NAMED,    /* maps by name: an array of structs */
    MURK_KEY_OWN       /* read by the function `read` */
} murk_key_kind;

typedef struct murk_word {
    const char *text; /* NULL ends the list */
    int value;
} murk_word;

typedef struct murk_keys murk_keys;
typedef struct murk_key_reader murk_key_reader; /* walk.h */

typedef struct murk_key {
    const char *name; /* NULL ends the table */
    murk_key_kind kind;
    bool required;      /* in a group: one key of the group must be given */
    bool above, below;  /* `min`, `max` themselves are refused */
    double min, max;    /* both 0: any finite number; of a text: max is the
                         * largest number of bytes, where 0 means 63 for a
                         * murk_scene_name, else 255 */
    const char *unit;   /* NULL: none */
    const char *preset; /* default, in YAML; NULL: none, and the key may be
                         * absent unless `required` */
    unsigned variants;  /* bit set of the map's variants; 0: all */
    int group;          /* not 0: at most one key of a group may be given */
    double factor;      /* to SI; 0: 1 */
    const murk_word *words;
    const murk_keys *keys;        /* the keys of the map, or of each item */
    const struct murk_key *items; /* numbers: name and range of each item */
    const char *of;               /* references: "media" or "materials" */
    size_t at, size;              /* member; size 0: not stored */
    size_t inside;    /* a map: the member into which the keys of the map go */
    bool takes_file;  /* a map: a text is short for {file: TEXT} */
    bool is_position; /* moved to the local origin (scene/origin.h): a vector,
                       * or heights, which are numbers */
    bool selects_files; /* the number says which files are read, or what of
                         * them, so a fit cannot search it: files are read
                         * once */
    bool has_flag;
    size_t flag_at;  /* a bool that is true if the key is given */
    bool lights;     /* top level: the traced light depends on the key */
    bool may_differ; /* top level: conditions may set it */
    bool is_still;   /* top level: the same at all times, so that no track of
                      * the timeline may set it */
    murk_status (*read)(murk_key_reader *walk, const struct murk_key *key,
                        murk_yaml *node, void *member);
    const char *allowed; /* of a key of kind MURK_KEY_OWN: the allowed values
                          * for messages, such as "free or a list", and the same
                          * as a JSON Schema */
    const char *schema;
} murk_key;

struct murk_keys {
    const murk_key *key;
    const char *noun; /* "light" */
    /* The variant of a map: the value of the word key `selector`, the result of
     * choose(), or with by_key the last of variant_names that is a key of the
     * map (else 0); otherwise there is one variant only. */
    const char *selector;
    murk_status (*choose)(murk_key_reader *walk, const murk_yaml *map,
                          int *variant);
    bool by_key;
    const char *const *variant_names; /* without a selector: the names of the
                                       * variants, such as "with a view"; NULL
                                       * ends the list */
    /* The keys that a map of each variant has, with blanks between; NULL: none,
     * or by_key the name of the variant. */
    const char *const *variant_needs;
    bool has_variant_at, has_where;
    size_t variant_at, where_at; /* members */
    /* Called before defaults are filled in: may add keys to the map. */
    murk_status (*complete)(murk_key_reader *walk, murk_yaml *map);
    /* Called after all members are filled: checks that involve several of
     * them. */
    murk_status (*check)(murk_key_reader *walk, const murk_yaml *map,
                         void *item);
    /* Items of lists and names: */
    size_t item_size, array_at, count_at, max_items, name_at;
    bool needs_item;
    const char *first, *first_preset; /* a built-in name, always item 0 */
    bool is_open; /* any keys with any values are allowed; check() reads them */
};

/* Of a scene, and of a study. */
extern const murk_keys murk_scene_keys, murk_study_keys;

/* Calls visit(context, key, item) for each row of a table, where `item` is the
 * struct that the rows fill, and before that for the rows of the structs below:
 * of maps, and of the items of arrays. Rows that do not belong to the variant
 * that a struct stores are left out. */
typedef void murk_key_visit(void *context, const murk_key *key, void *item);
void murk_keys_visit(const murk_keys *keys, void *item, murk_key_visit *visit,
                     void *context);

/* True if values of the row are numbers that may be any within a range, one or
 * a list: no whole numbers, choices or texts. */
bool murk_key_is_continuous(const murk_key *key);

/* The first row with a name, of any variant, or NULL. */
const murk_key *murk_keys_find(const murk_keys *keys, const char *name);

/* The number of variants of a map, at least 1; and the name of a variant: the
 * word of the selector, or a name of variant_names. The name is NULL if the
 * table has neither. */
int murk_keys_variants(const murk_keys *keys);
const char *murk_keys_variant_name(const murk_keys *keys, int variant);

#endif
