/* A JSON Schema (draft-07) of scene and study files, made from the key tables.
 * A map becomes an object with one property for each key; groups of
 * keys that exclude each other and the variants of a map become conditions on
 * the object. Descriptions are those of doc/reference.
 *
 * A schema refuses no scene that murk reads. It accepts some that murk refuses:
 * checks of several values, and names of media and materials, are no part of
 * it. */
#include "reference/schema.h"

#include "reference/reference.h"
#include "scene/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static cJSON *map_schema(const murk_keys *keys);

/* ---- values ---- */

static cJSON *of_type(const char *type)
{
    cJSON *schema = cJSON_CreateObject();
    cJSON_AddStringToObject(schema, "type", type);
    return schema;
}

/* A number in the range of a row. */
static cJSON *number(const murk_key *row, const char *type)
{
    cJSON *schema = of_type(type);
    if (row->min == 0 && row->max == 0 && !row->above && !row->below) {
        return schema;
    }
    cJSON_AddNumberToObject(schema, row->above ? "exclusiveMinimum" : "minimum",
                            row->min);
    cJSON_AddNumberToObject(schema, row->below ? "exclusiveMaximum" : "maximum",
                            row->max);
    return schema;
}

/* A text. A value that looks like a number or a boolean is one in YAML, and a
 * text for murk, so the schema allows all three. */
static cJSON *text(size_t max)
{
    static const char *const TYPES[] = {"string", "number", "boolean"};
    cJSON *schema = cJSON_CreateObject();
    cJSON_AddItemToObject(schema, "type", cJSON_CreateStringArray(TYPES, 3));
    cJSON_AddNumberToObject(schema, "minLength", 1);
    if (max > 0) {
        cJSON_AddNumberToObject(schema, "maxLength", (double)max);
    }
    return schema;
}

/* A list of `minimum` to `maximum` items (maximum 0: no limit). */
static cJSON *list_of(cJSON *items, size_t minimum, size_t maximum)
{
    cJSON *schema = of_type("array");
    cJSON_AddItemToObject(schema, "items", items);
    cJSON_AddNumberToObject(schema, "minItems", (double)minimum);
    if (maximum > 0) {
        cJSON_AddNumberToObject(schema, "maxItems", (double)maximum);
    }
    return schema;
}

/* A schema that accepts what at least one of a, b and c accepts; those that are
 * NULL are left out. */
static cJSON *any_of(cJSON *a, cJSON *b, cJSON *c)
{
    cJSON *const all[] = {a, b, c};
    cJSON *only = a ? a : b ? b : c;
    if (!a + !b + !c == 2) {
        return only;
    }
    cJSON *schema = cJSON_CreateObject();
    cJSON *list = cJSON_AddArrayToObject(schema, "anyOf");
    for (size_t i = 0; i < 3; ++i) {
        if (all[i]) {
            cJSON_AddItemToArray(list, all[i]);
        }
    }
    return schema;
}

/* The words of a row; NULL: the row has none. */
static cJSON *words(const murk_key *row)
{
    if (!row->words) {
        return NULL;
    }
    cJSON *schema = cJSON_CreateObject();
    cJSON *list = cJSON_AddArrayToObject(schema, "enum");
    for (const murk_word *word = row->words; word->text; ++word) {
        if (strcmp(word->text, "null") == 0) {
            cJSON_AddItemToArray(list, cJSON_CreateNull());
        }
        cJSON_AddItemToArray(list, cJSON_CreateString(word->text));
    }
    return schema;
}

/* [n, mu]: a number for each item of the row. */
static cJSON *numbers(const murk_key *row)
{
    cJSON *items = cJSON_CreateArray();
    for (const murk_key *item = row->items; item->name; ++item) {
        cJSON_AddItemToArray(items, number(item, "number"));
    }
    const size_t n = (size_t)cJSON_GetArraySize(items);
    return list_of(items, n, n);
}

/* Maps by name. */
static cJSON *named(const murk_keys *keys)
{
    cJSON *schema = of_type("object");
    cJSON *names = cJSON_AddObjectToObject(schema, "propertyNames");
    cJSON_AddNumberToObject(names, "minLength", 1);
    cJSON_AddNumberToObject(names, "maxLength", MURK_SCENE_NAME_SIZE - 1);
    cJSON_AddItemToObject(schema, "additionalProperties", map_schema(keys));
    cJSON_AddNumberToObject(schema, "maxProperties", (double)keys->max_items);
    return schema;
}

/* The values of a row, without those that are words. */
static cJSON *values(const murk_key *row)
{
    const murk_keys *keys = row->keys;
    cJSON *one;
    switch (row->kind) {
    /* One value. */
    case MURK_KEY_NUMBER:
        return number(row, "number");
    case MURK_KEY_COUNT:
        return number(row, "integer");
    case MURK_KEY_BOOL:
        return of_type("boolean");
    case MURK_KEY_TEXT:
        return text(murk_value_max_bytes(row));
    case MURK_KEY_PATH:
    case MURK_KEY_REFERENCE:
        return text(0);
    case MURK_KEY_OWN:
        return cJSON_Parse(row->schema);
    /* Lists of numbers and texts. */
    case MURK_KEY_REFERENCES:
    case MURK_KEY_TEXT_LIST:
        return list_of(text(0), 1, 0);
    case MURK_KEY_VECTOR:
        return list_of(number(row, "number"), 3, 3);
    case MURK_KEY_SIZES:
        return list_of(number(row, "integer"), row->size / sizeof(size_t),
                       row->size / sizeof(size_t));
    case MURK_KEY_NUMBERS:
        return numbers(row);
    case MURK_KEY_BANDS:
        return list_of(number(row, "number"), 1, MURK_BANDS_MAX);
    case MURK_KEY_BAND_EDGES:
        return list_of(number(row, "number"), 2, MURK_BANDS_MAX + 1);
    case MURK_KEY_NUMBER_LIST:
        return list_of(number(row, "number"), 1, 0);
    /* Values of bands. */
    case MURK_KEY_SPECTRUM:
    case MURK_KEY_SHARED:
    case MURK_KEY_SPECTRUM_LIST:
        one = any_of(number(row, "number"),
                     list_of(number(row, "number"), 1, MURK_BANDS_MAX),
                     keys ? map_schema(keys) : NULL);
        return row->kind == MURK_KEY_SPECTRUM_LIST ? list_of(one, 1, 0) : one;
    case MURK_KEY_PER_BAND:
        one = any_of(words(row), map_schema(keys), NULL);
        return any_of(map_schema(keys), list_of(one, 1, MURK_BANDS_MAX), NULL);
    /* Maps. */
    case MURK_KEY_MAP:
        return any_of(row->takes_file ? text(0) : NULL, map_schema(keys), NULL);
    case MURK_KEY_LIST:
        return list_of(map_schema(keys), keys->needs_item, keys->max_items);
    case MURK_KEY_MAPS:
        return any_of(map_schema(keys),
                      list_of(map_schema(keys), 0, keys->max_items), NULL);
    case MURK_KEY_NAMED:
        return named(keys);
    case MURK_KEY_WORD:
        break;
    }
    return NULL;
}

static cJSON *row_schema(const murk_key *row)
{
    return any_of(words(row), values(row), NULL);
}

/* ---- properties ---- */

/* Adds the meaning of a row, with its values and their unit, and its default.
 */
static void describe(cJSON *schema, const murk_keys *keys, const murk_key *row)
{
    char allowed[MURK_ALLOWED_SIZE];
    char *meaning = murk_reference_meaning(keys, row), *whole = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&whole, &size);
    murk_value_allowed(row, allowed);
    if (to) {
        fprintf(to, "%s\n\nValue: %s.", meaning ? meaning : "", allowed);
        if (row->preset) {
            fprintf(to, " Default: %s.", row->preset);
        }
        fclose(to);
        cJSON_AddStringToObject(schema, "description", whole);
    }
    free(meaning);
    free(whole);
    if (row->preset) {
        cJSON *preset = cJSON_Parse(row->preset);
        cJSON_AddItemToObject(schema, "default",
                              preset ? preset
                                     : cJSON_CreateString(row->preset));
    }
}

/* The number of rows of that name. */
static int count_rows(const murk_keys *keys, const char *name)
{
    int n = 0;
    for (const murk_key *row = keys->key; row->name; ++row) {
        n += strcmp(row->name, name) == 0;
    }
    return n;
}

/* The property of a key: the values of all of its rows. */
static cJSON *property(const murk_keys *keys, const murk_key *first)
{
    cJSON *schema = row_schema(first);
    for (const murk_key *row = first + 1; row->name; ++row) {
        if (strcmp(row->name, first->name) == 0) {
            schema = any_of(schema, row_schema(row), NULL);
        }
    }
    describe(schema, keys, first);
    return schema;
}

static void add_properties(cJSON *schema, const murk_keys *keys)
{
    cJSON *properties = cJSON_AddObjectToObject(schema, "properties");
    for (const murk_key *row = keys->key; row->name; ++row) {
        if (!cJSON_HasObjectItem(properties, row->name)) {
            cJSON_AddItemToObject(properties, row->name, property(keys, row));
        }
    }
    cJSON_AddFalseToObject(schema, "additionalProperties");
}

/* ---- what goes together ---- */

static cJSON *requires(const char *a, const char *b)
{
    const char *const both[] = {a, b};
    cJSON *schema = cJSON_CreateObject();
    cJSON_AddItemToObject(schema, "required",
                          cJSON_CreateStringArray(both, b ? 2 : 1));
    return schema;
}

/* The conditions of one group: exactly one of its keys, or at most one. */
static void add_group(cJSON *all_of, const murk_key *first)
{
    cJSON *one_of = first->required ? cJSON_CreateArray() : NULL;
    for (const murk_key *row = first; row->name; ++row) {
        if (row->group != first->group) {
            continue;
        }
        if (one_of) {
            cJSON_AddItemToArray(one_of, requires(row->name, NULL));
            continue;
        }
        /* No two of the group. */
        for (const murk_key *other = row + 1; other->name; ++other) {
            if (other->group == row->group) {
                cJSON *both = cJSON_CreateObject();
                cJSON_AddItemToObject(both, "not",
                                      requires(row->name, other->name));
                cJSON_AddItemToArray(all_of, both);
            }
        }
    }
    if (one_of) {
        cJSON *one = cJSON_CreateObject();
        cJSON_AddItemToObject(one, "oneOf", one_of);
        cJSON_AddItemToArray(all_of, one);
    }
}

static void add_groups(cJSON *all_of, const murk_keys *keys)
{
    int above = 0; /* bit g: a row of group g was found already */
    for (const murk_key *row = keys->key; row->name; ++row) {
        if (row->group && !(above & (1 << row->group))) {
            above |= 1 << row->group;
            add_group(all_of, row);
        }
    }
}

static bool fits(const murk_key *row, int variant)
{
    return !row->variants || (row->variants & (1u << variant));
}

/* Adds the keys that are required: in maps of a variant, or (variant -1) in all
 * maps. */
static void add_required(cJSON *list, const murk_keys *keys, int variant)
{
    for (const murk_key *row = keys->key; row->name; ++row) {
        if (row->required && !row->group && !row->preset &&
            (variant < 0 ? !row->variants : fits(row, variant))) {
            cJSON_AddItemToArray(list, cJSON_CreateString(row->name));
        }
    }
}

/* Adds the keys by which a variant is chosen. */
static void add_needs(cJSON *list, const murk_keys *keys, int variant)
{
    const char *needs =
        keys->variant_needs ? keys->variant_needs[variant]
        : keys->by_key && murk_keys_find(keys, keys->variant_names[variant])
            ? keys->variant_names[variant]
            : NULL;
    while (needs && *needs) {
        char name[MURK_SCENE_NAME_SIZE];
        const size_t length = strcspn(needs, " ");
        snprintf(name, sizeof name, "%.*s", (int)length, needs);
        cJSON_AddItemToArray(list, cJSON_CreateString(name));
        needs += length + (needs[length] == ' ');
    }
}

/* What holds for maps of one variant; NULL: no key belongs to the variant. */
static cJSON *variant_schema(const murk_keys *keys, int variant)
{
    cJSON *schema = cJSON_CreateObject();
    cJSON *names = cJSON_CreateArray();
    cJSON *own = cJSON_CreateObject();
    for (const murk_key *row = keys->key; row->name; ++row) {
        if (!fits(row, variant)) {
            continue;
        }
        cJSON_AddItemToArray(names, cJSON_CreateString(row->name));
        if (count_rows(keys, row->name) > 1) {
            cJSON_AddItemToObject(own, row->name, row_schema(row));
        }
    }
    /* The names of keys, values that differ, and what is required. */
    const bool is_possible = cJSON_GetArraySize(names) > 0;
    cJSON *enumerated = cJSON_AddObjectToObject(schema, "propertyNames");
    cJSON_AddItemToObject(enumerated, "enum", names);
    cJSON_AddItemToObject(schema, "properties", own);
    cJSON *required = cJSON_AddArrayToObject(schema, "required");
    add_required(required, keys, variant);
    add_needs(required, keys, variant);
    if (!is_possible) {
        cJSON_Delete(schema);
    }
    return is_possible ? schema : NULL;
}

/* A variant that a word selects: if the key `selector` has the word of the
 * variant, or is left out and the word is the default, then the schema of the
 * variant holds. */
static cJSON *if_word(const murk_keys *keys, int variant)
{
    const murk_key *key = murk_keys_find(keys, keys->selector);
    const char *name = murk_keys_variant_name(keys, variant);
    cJSON *schema = cJSON_CreateObject();
    cJSON *condition = cJSON_AddObjectToObject(schema, "if");
    cJSON *properties = cJSON_AddObjectToObject(condition, "properties");
    cJSON *value = cJSON_AddObjectToObject(properties, keys->selector);
    cJSON_AddStringToObject(value, "const", name);
    if (!key->preset || strcmp(key->preset, name) != 0) {
        cJSON_AddItemToObject(condition, "required",
                              cJSON_CreateStringArray(&keys->selector, 1));
    }
    cJSON_AddItemToObject(schema, "then", variant_schema(keys, variant));
    return schema;
}

static void add_variants(cJSON *all_of, const murk_keys *keys)
{
    bool differ = false;
    for (const murk_key *row = keys->key; row->name; ++row) {
        differ |= row->variants != 0;
    }
    cJSON *any = cJSON_CreateArray();
    for (int i = 0; differ && i < murk_keys_variants(keys); ++i) {
        cJSON *one =
            keys->selector ? if_word(keys, i) : variant_schema(keys, i);
        if (one) {
            cJSON_AddItemToArray(keys->selector ? all_of : any, one);
        }
    }
    /* Variants that no word selects: at least one of them must fit. */
    if (cJSON_GetArraySize(any) > 0) {
        cJSON *schema = cJSON_CreateObject();
        cJSON_AddItemToObject(schema, "anyOf", any);
        cJSON_AddItemToArray(all_of, schema);
    } else {
        cJSON_Delete(any);
    }
}

static cJSON *map_schema(const murk_keys *keys)
{
    cJSON *schema = of_type("object");
    if (keys->is_open) {
        return schema;
    }
    add_properties(schema, keys);
    cJSON *required = cJSON_AddArrayToObject(schema, "required");
    cJSON *all_of = cJSON_CreateArray();
    add_required(required, keys, -1);
    add_groups(all_of, keys);
    add_variants(all_of, keys);
    if (cJSON_GetArraySize(all_of) > 0) {
        cJSON_AddItemToObject(schema, "allOf", all_of);
    } else {
        cJSON_Delete(all_of);
    }
    return schema;
}

/* ---- the whole ---- */

cJSON *murk_reference_schema(void)
{
    /* A study has the key murk_study; all else is a scene. */
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "$schema",
                            "http://json-schema.org/draft-07/schema#");
    cJSON_AddStringToObject(root, "title", "A scene or a study of murk");
    cJSON_AddStringToObject(root, "type", "object");
    cJSON_AddItemToObject(root, "if", requires("murk_study", NULL));
    cJSON_AddItemToObject(root, "then", map_schema(&murk_study_keys));
    cJSON_AddItemToObject(root, "else", map_schema(&murk_scene_keys));
    return root;
}
