/* The reference of keys as JSON. The key table says which values a key takes,
 * the default and the keys that exclude each other; the meaning is that of
 * doc/reference. A name has several rows in a table if the values of the key
 * depend on the variant of the map, such as the type of a light. */
#include "reference/entries.h"

#include "base/words.h"
#include "reference/reference.h"
#include "scene/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAMES_MAX 64   /* more names than a table of keys has */
#define LIST_SIZE 1000 /* bytes, more than a list of paths of keys has */

/* The kinds of values, for readers that are programs. */
static const char *const TYPES[] = {[MURK_KEY_NUMBER] = "number",
                                    [MURK_KEY_COUNT] = "count",
                                    [MURK_KEY_BOOL] = "boolean",
                                    [MURK_KEY_WORD] = "word",
                                    [MURK_KEY_TEXT] = "text",
                                    [MURK_KEY_PATH] = "file",
                                    [MURK_KEY_REFERENCE] = "name",
                                    [MURK_KEY_REFERENCES] = "names",
                                    [MURK_KEY_VECTOR] = "vector",
                                    [MURK_KEY_SIZES] = "counts",
                                    [MURK_KEY_NUMBERS] = "numbers",
                                    [MURK_KEY_BANDS] = "bands",
                                    [MURK_KEY_BAND_EDGES] = "band edges",
                                    [MURK_KEY_NUMBER_LIST] = "list of numbers",
                                    [MURK_KEY_TEXT_LIST] = "list of texts",
                                    [MURK_KEY_SPECTRUM_LIST] =
                                        "list of spectra",
                                    [MURK_KEY_SPECTRUM] = "spectrum",
                                    [MURK_KEY_SHARED] = "total or spectrum",
                                    [MURK_KEY_MAP] = "map",
                                    [MURK_KEY_PER_BAND] = "map or list by band",
                                    [MURK_KEY_LIST] = "list of maps",
                                    [MURK_KEY_MAPS] = "map or list of maps",
                                    [MURK_KEY_NAMED] = "maps by name",
                                    [MURK_KEY_OWN] = "own"};

/* ---- one row ---- */

static void add_text(cJSON *to, const char *name, const char *text)
{
    cJSON_AddItemToObject(to, name,
                          text ? cJSON_CreateString(text) : cJSON_CreateNull());
}

/* Adds a text, which it frees. */
static void add_owned(cJSON *to, const char *name, char *text)
{
    add_text(to, name, text);
    free(text);
}

/* Adds the range of numbers; null: any finite number, or no number. */
static void add_range(cJSON *to, const murk_key *row)
{
    const bool has_range =
        row->kind != MURK_KEY_TEXT &&
        (row->min != 0 || row->max != 0 || row->above || row->below);
    cJSON *range = has_range ? cJSON_AddObjectToObject(to, "range") : NULL;
    if (!range) {
        cJSON_AddNullToObject(to, "range");
        return;
    }
    cJSON_AddNumberToObject(range, "minimum", row->min);
    cJSON_AddNumberToObject(range, "maximum", row->max);
    cJSON_AddBoolToObject(range, "excludes_minimum", row->above);
    cJSON_AddBoolToObject(range, "excludes_maximum", row->below);
}

/* Adds the default in the words of the reference, which describes a default
 * that depends on other keys. */
static void add_default_in_words(cJSON *to, const murk_keys *table,
                                 const murk_key *row)
{
    char *stated = murk_reference_default(table, row);
    const bool is_stated =
        stated && !row->preset && !row->required && strcmp(stated, "-") != 0 &&
        strcmp(stated, "required") != 0 && strcmp(stated, "one of these") != 0;
    add_text(to, "default_in_words", is_stated ? stated : NULL);
    free(stated);
}

/* Adds the names of variants of the map that may have the key; none: all. */
static void add_variants(cJSON *to, const murk_keys *table, const murk_key *row)
{
    cJSON *list = cJSON_AddArrayToObject(to, "variants");
    for (int i = 0; row->variants && i < murk_keys_variants(table); ++i) {
        const char *name = murk_keys_variant_name(table, i);
        if (name && row->variants & (1u << i)) {
            cJSON_AddItemToArray(list, cJSON_CreateString(name));
        }
    }
}

/* Adds the other keys of the group of a key. A map may have one key of a group
 * at most. */
static void add_group(cJSON *to, const murk_keys *table, const murk_key *row)
{
    cJSON *list = cJSON_AddArrayToObject(to, "in_place_of");
    for (const murk_key *other = table->key; other->name; ++other) {
        if (row->group && other->group == row->group &&
            strcmp(other->name, row->name) != 0) {
            cJSON_AddItemToArray(list, cJSON_CreateString(other->name));
        }
    }
}

/* Adds what the key table and the reference say of a row. */
static void describe(cJSON *to, const murk_keys *table, const murk_key *row)
{
    char allowed[MURK_ALLOWED_SIZE];
    murk_value_allowed(row, allowed);
    /* Values. */
    cJSON_AddStringToObject(to, "type", TYPES[row->kind]);
    cJSON_AddStringToObject(to, "value", allowed);
    add_range(to, row);
    cJSON *words = cJSON_AddArrayToObject(to, "words");
    for (const murk_word *word = row->words; word && word->text; ++word) {
        cJSON_AddItemToArray(words, cJSON_CreateString(word->text));
    }
    add_text(to, "unit", row->unit);
    /* Default, and keys that go with the key or not. */
    add_text(to, "default", row->preset);
    add_default_in_words(to, table, row);
    cJSON_AddBoolToObject(to, "required", row->required);
    cJSON_AddBoolToObject(to, "of_group", row->group != 0);
    add_group(to, table, row);
    add_variants(to, table, row);
    add_owned(to, "meaning", murk_reference_meaning(table, row));
}

/* ---- a map ---- */

/* Adds the keys of a map, a row each, and the introduction of their table;
 * keys NULL: no map. */
static void add_map(cJSON *to, const murk_keys *keys)
{
    cJSON *list = keys ? cJSON_AddArrayToObject(to, "keys") : NULL;
    if (!list) {
        return;
    }
    add_owned(to, "introduction", murk_reference_introduction(keys));
    for (const murk_key *row = keys->key; row->name; ++row) {
        cJSON *item = murk_json_item(list);
        cJSON_AddStringToObject(item, "name", row->name);
        describe(item, keys, row);
    }
}

static void add_key(void *list, const murk_reference_key *key)
{
    cJSON *item = murk_json_item(list);
    cJSON_AddStringToObject(item, "path", key->path);
    cJSON_AddBoolToObject(item, "is_settable", key->is_settable);
    describe(item, key->table, key->row);
}

void murk_reference_all(cJSON **out, const murk_keys *root)
{
    *out = cJSON_CreateObject();
    cJSON_AddStringToObject(*out, "path", "");
    add_map(*out, root);
    cJSON *all = cJSON_AddArrayToObject(*out, "all");
    murk_reference_visit_all(root, add_key, all);
}

/* ---- unknown keys ---- */

typedef struct search {
    const char *last; /* part of the unknown path */
    char list[LIST_SIZE];
} search;

static void take_same_name(void *context, const murk_reference_key *key)
{
    search *s = context;
    if (strcmp(key->row->name, s->last) == 0) {
        const size_t length = strlen(s->list);
        snprintf(s->list + length, sizeof s->list - length, "%s%s",
                 length ? ", " : "", key->path);
    }
}

/* Suggests a key of the same map that is spelled alike, or keys of that name in
 * other maps. */
static murk_status unknown_key(const murk_keys *root, const char *path,
                               const murk_reference_key *key, murk_error *err)
{
    const char *names[NAMES_MAX], *dot = strrchr(path, '.');
    char part[MURK_SCENE_NAME_SIZE], shown[MURK_REFERENCE_PATH_SIZE];
    size_t n = 0;
    const murk_key *row = key->looked_up ? key->looked_up->key : NULL;
    for (; row && row->name && n < NAMES_MAX; ++row) {
        names[n++] = row->name;
    }
    snprintf(part, sizeof part, "%.*s", (int)strcspn(key->unknown, "."),
             key->unknown);
    murk_words_show(shown, sizeof shown, path);
    /* A key that is spelled alike, in the table in which the unknown part of
     * the path was looked up. */
    const char *meant = murk_words_meant(part, names, n);
    if (meant) {
        return murk_fail(err, MURK_BAD_VALUE, shown,
                         "no such key, did you mean %.*s%s?",
                         (int)(key->unknown - path), path, meant);
    }
    search s = {.last = dot ? dot + 1 : path};
    murk_reference_visit_all(root, take_same_name, &s);
    return s.list[0] ? murk_fail(err, MURK_BAD_VALUE, shown,
                                 "no such key, did you mean %s?", s.list)
                     : murk_fail(err, MURK_BAD_VALUE, shown, "no such key");
}

/* ---- one key ---- */

murk_status murk_reference_one(cJSON **out, const murk_keys *root,
                               const char *path, murk_error *err)
{
    *out = NULL;
    const murk_reference_key key = murk_reference_find(root, path);
    if (!key.row) {
        return unknown_key(root, path, &key, err);
    }
    *out = cJSON_CreateObject();
    cJSON_AddStringToObject(*out, "path", key.path);
    cJSON_AddStringToObject(*out, "of", key.table->noun);
    /* All rows of the name. */
    cJSON *rows = cJSON_AddArrayToObject(*out, "rows");
    for (const murk_key *row = key.row; row->name; ++row) {
        if (strcmp(row->name, key.row->name) == 0) {
            describe(murk_json_item(rows), key.table, row);
        }
    }
    const murk_keys *keys = key.row->keys;
    add_map(*out, keys && !keys->is_open ? keys : NULL);
    return MURK_OK;
}
