/* Descriptions of values for messages: the value found, and the values that
 * a row of the key table allows. */
#include "scene/value.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "base/words.h"

/* Two quotes are around the text. */
#define SHOWN_SIZE (MURK_FOUND_SIZE - 2)

void murk_value_found(const murk_yaml *node, char out[MURK_FOUND_SIZE])
{
    if (node->kind != MURK_YAML_SCALAR) {
        snprintf(out, MURK_FOUND_SIZE, "%s %s", node->n ? "a" : "an empty",
                 node->kind == MURK_YAML_LIST ? "list" : "map");
    } else if (node->is_quoted) {
        char text[SHOWN_SIZE];
        murk_words_show(text, sizeof text, node->text);
        snprintf(out, MURK_FOUND_SIZE, "\"%s\"", text);
    } else if (node->text[0] == '\0') {
        snprintf(out, MURK_FOUND_SIZE, "nothing");
    } else {
        murk_words_show(out, MURK_FOUND_SIZE, node->text);
    }
}

/* Prints a bound: powers of ten from 1e5 in the form 1e9 or -1e9, other
 * numbers as murk_number_print() does. */
static void show_bound(char out[MURK_NUMBER_SIZE], double bound)
{
    murk_number_print(out, bound);
    const char *digits = out + (out[0] == '-');
    const size_t zeros = strlen(digits) - 1;
    if (zeros >= 5 && digits[0] == '1' && strspn(digits + 1, "0") == zeros) {
        snprintf(out, MURK_NUMBER_SIZE, "%s1e%zu", bound < 0 ? "-" : "", zeros);
    } else if (strncmp(digits, "1e+", 3) == 0) {
        snprintf(out, MURK_NUMBER_SIZE, "%s1e%ld", bound < 0 ? "-" : "",
                 strtol(digits + 3, NULL, 10));
    }
}

void murk_value_range(const murk_key *key, char *out, size_t size)
{
    char min[MURK_NUMBER_SIZE], max[MURK_NUMBER_SIZE];
    show_bound(min, key->min);
    show_bound(max, key->max);
    const char *gap = key->unit ? " " : "", *unit = key->unit ? key->unit : "";
    if (key->above && key->below) {
        snprintf(out, size, "more than %s and less than %s%s%s", min, max, gap,
                 unit);
    } else if (key->above) {
        snprintf(out, size, "more than %s and at most %s%s%s", min, max, gap,
                 unit);
    } else if (key->min < key->max) {
        snprintf(out, size, "%s..%s%s%s", min, max, gap, unit);
    } else {
        snprintf(out, size, "%s%s%s", min, gap, unit);
    }
}

/* Appends to a description, as far as there is space. */
static void add(char out[MURK_ALLOWED_SIZE], const char *format, ...)
{
    const size_t length = strlen(out);
    va_list args;
    va_start(args, format);
    vsnprintf(out + length, MURK_ALLOWED_SIZE - length, format, args);
    va_end(args);
}

/* "[n, mu], n 1.001..2, mu 3.0001..4.9999" */
static void add_items(char out[MURK_ALLOWED_SIZE], const murk_key *items)
{
    for (const murk_key *item = items; item->name; ++item) {
        add(out, "%s%s", item == items ? "[" : ", ", item->name);
    }
    add(out, "]");
    for (const murk_key *item = items; item->name; ++item) {
        char range[MURK_ALLOWED_SIZE];
        murk_value_range(item, range, sizeof range);
        add(out, ", %s %s", item->name, range);
    }
}

size_t murk_value_max_bytes(const murk_key *key)
{
    if (key->max > 0) {
        return (size_t)key->max;
    }
    return (key->size == sizeof(murk_scene_name) ? MURK_SCENE_NAME_SIZE
                                                 : MURK_SCENE_LONG_NAME_SIZE) -
           1;
}

/* The description of each kind: a text, the range of the row, and a text. */
static const struct {
    const char *before;
    bool has_range;
    const char *after;
} ALLOWED[] = {
    [MURK_KEY_NUMBER] = {"a number, ", true, ""},
    [MURK_KEY_COUNT] = {"a whole number, ", true, ""},
    [MURK_KEY_BOOL] = {"true or false", false, ""},
    [MURK_KEY_WORD] = {"", false, ""},
    [MURK_KEY_TEXT] = {"a text of 1..", false, ""},
    [MURK_KEY_PATH] = {"the name of a file", false, ""},
    [MURK_KEY_REFERENCE] = {"a name of ", false, ""},
    [MURK_KEY_REFERENCES] = {"a list of names of ", false, ""},
    [MURK_KEY_VECTOR] = {"[x, y, z], each ", true, ""},
    [MURK_KEY_SIZES] = {"], each a whole number, ", true, ""},
    [MURK_KEY_NUMBERS] = {"", false, ""},
    [MURK_KEY_BANDS] = {"a list of 1..16 rising wavelengths, each ", true, ""},
    [MURK_KEY_BAND_EDGES] = {"a list of 2..17 rising wavelengths, each ", true,
                             ""},
    [MURK_KEY_NUMBER_LIST] = {"a list of numbers, each ", true, ""},
    [MURK_KEY_TEXT_LIST] = {"a list of texts", false, ""},
    [MURK_KEY_SPECTRUM_LIST] = {"a list of numbers, each ", true,
                                ", or of lists, one a band"},
    [MURK_KEY_SPECTRUM] = {"a number, ", true,
                           ", or a list of them, one a band"},
    [MURK_KEY_SHARED] = {"a number (the total), ", true,
                         ", or a list, one a band"},
    [MURK_KEY_MAP] = {"a map of keys", false, ""},
    [MURK_KEY_PER_BAND] = {"a map of keys, or a list of them, one a band",
                           false, ""},
    [MURK_KEY_LIST] = {"a list of ", false, ""},
    [MURK_KEY_MAPS] = {"a map of keys, or a list of them", false, ""},
    [MURK_KEY_NAMED] = {"a map of names", false, ""},
    [MURK_KEY_OWN] = {"", false, ""},
};
_Static_assert(MURK_BANDS_MAX == 16, "the descriptions of bands state it");

void murk_value_allowed(const murk_key *key, char out[MURK_ALLOWED_SIZE])
{
    char range[MURK_ALLOWED_SIZE] = "";
    out[0] = '\0';
    /* Words come first. */
    for (const murk_word *word = key->words; word && word->text; ++word) {
        add(out, "%s%s", word == key->words ? "" : ", ", word->text);
    }
    if (key->words && key->kind != MURK_KEY_WORD) {
        add(out, " or ");
    }
    /* The description of the kind, and a part that depends on the row. */
    if (key->kind == MURK_KEY_SIZES) {
        add(out, "[nx, ny%s", key->size > 2 * sizeof(size_t) ? ", nz" : "");
    }
    if (ALLOWED[key->kind].has_range) {
        murk_value_range(key, range, sizeof range);
    }
    add(out, "%s%s%s", ALLOWED[key->kind].before, range,
        ALLOWED[key->kind].after);
    switch (key->kind) {
    case MURK_KEY_TEXT:
        add(out, "%zu bytes", murk_value_max_bytes(key));
        break;
    case MURK_KEY_REFERENCE:
    case MURK_KEY_REFERENCES:
        add(out, "%s", key->of);
        break;
    case MURK_KEY_NUMBERS:
        add_items(out, key->items);
        break;
    case MURK_KEY_SPECTRUM:
        add(out, "%s", key->keys ? ", or a map of keys" : "");
        break;
    case MURK_KEY_MAP:
        add(out, "%s", key->takes_file ? ", or the name of a file" : "");
        break;
    case MURK_KEY_LIST:
        add(out, "%s%s", key->keys->needs_item ? "at least one " : "maps",
            key->keys->needs_item ? key->keys->noun : "");
        break;
    case MURK_KEY_OWN:
        add(out, "%s", key->allowed);
        break;
    default:
        break;
    }
}
