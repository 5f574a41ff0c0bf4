/* Descriptions of values for messages: the value found, and the values that
 * a row of the key table allows. */
#include "scene/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "scene/words.h"

/* A range or a list of words is part of a description. */
#define PART_SIZE (MURK_ALLOWED_SIZE / 2)

/* Two quotes are around the text. */
#define SHOWN_SIZE (MURK_FOUND_SIZE - 2)

void murk_value_found(const murk_yaml *node, char out[MURK_FOUND_SIZE])
{
    if (node->kind != MURK_YAML_SCALAR) {
        snprintf(out, MURK_FOUND_SIZE, "%s%s", node->n ? "" : "an empty ",
                 node->kind == MURK_YAML_LIST ? node->n ? "a list" : "list"
                 : node->n                    ? "a map"
                                              : "map");
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

/* Prints a bound: powers of ten as 1e9, other numbers in full. */
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

static void show_words(const murk_word *words, char *out, size_t size)
{
    size_t length = 0;
    out[0] = '\0';
    for (const murk_word *word = words; word->text; ++word) {
        if (length < size) {
            const int n = snprintf(out + length, size - length, "%s%s",
                                   length ? ", " : "", word->text);
            length += (size_t)n;
        }
    }
}

/* "[n, mu], n 1.001..2, mu 3.0001..4.9999" */
static void show_items(const murk_key *items, char *out, size_t size)
{
    size_t length = 0;
    for (const murk_key *item = items; item->name && length < size; ++item) {
        length += (size_t)snprintf(out + length, size - length, "%s%s",
                                   item == items ? "[" : ", ", item->name);
    }
    for (const murk_key *item = items; item->name && length < size; ++item) {
        char range[PART_SIZE];
        murk_value_range(item, range, sizeof range);
        length += (size_t)snprintf(out + length, size - length, "%s, %s %s",
                                   item == items ? "]" : "", item->name, range);
    }
}

size_t murk_value_max_bytes(const murk_key *key)
{
    return (key->size == sizeof(murk_scene_name) ? MURK_SCENE_NAME_SIZE
                                                 : MURK_SCENE_LONG_NAME_SIZE) -
           1;
}

void murk_value_allowed(const murk_key *key, char out[MURK_ALLOWED_SIZE])
{
    const size_t size = MURK_ALLOWED_SIZE;
    char range[PART_SIZE];
    murk_value_range(key, range, sizeof range);
    /* One description for each kind of key. */
    switch (key->kind) {
    case MURK_KEY_NUMBER:
        snprintf(out, size, "a number, %s", range);
        break;
    case MURK_KEY_COUNT:
        snprintf(out, size, "a whole number, %s", range);
        break;
    case MURK_KEY_BOOL:
        snprintf(out, size, "true or false");
        break;
    case MURK_KEY_WORD:
        show_words(key->words, out, size);
        break;
    case MURK_KEY_VECTOR:
        snprintf(out, size, "[x, y, z], each %s", range);
        break;
    case MURK_KEY_SIZES:
        snprintf(out, size, "[nx, ny%s], each a whole number, %s",
                 key->size > 2 * sizeof(size_t) ? ", nz" : "", range);
        break;
    case MURK_KEY_NUMBERS:
        show_items(key->items, out, size);
        break;
    case MURK_KEY_BANDS:
        snprintf(out, size, "a list of 1..%d rising wavelengths, each %s",
                 MURK_BANDS_MAX, range);
        break;
    case MURK_KEY_BAND_EDGES:
        snprintf(out, size, "a list of 2..%d rising wavelengths, each %s",
                 MURK_BANDS_MAX + 1, range);
        break;
    case MURK_KEY_SPECTRUM:
        snprintf(out, size, "a number, %s, or a list of them, one a band%s",
                 range, key->keys ? ", or a map of keys" : "");
        break;
    case MURK_KEY_NUMBER_LIST:
        if (key->words) {
            show_words(key->words, out, size);
        }
        snprintf(out + (key->words ? strlen(out) : 0),
                 size - (key->words ? strlen(out) : 0),
                 "%sa list of numbers, each %s", key->words ? " or " : "",
                 range);
        break;
    case MURK_KEY_SPECTRUM_LIST:
        snprintf(out, size,
                 "a list of numbers, each %s, or of lists, one a band", range);
        break;
    case MURK_KEY_SHARED:
        snprintf(out, size, "a number (the total), %s, or a list, one a band",
                 range);
        break;
    case MURK_KEY_TEXT:
        snprintf(out, size, "a text of 1..%zu bytes",
                 murk_value_max_bytes(key));
        break;
    case MURK_KEY_PATH:
        snprintf(out, size, "the name of a file");
        break;
    case MURK_KEY_REFERENCE:
        snprintf(out, size, "a name of %s", key->of);
        break;
    case MURK_KEY_REFERENCES:
        snprintf(out, size, "a list of names of %s", key->of);
        if (key->words) {
            show_words(key->words, range, sizeof range);
            snprintf(out, size, "%s or a list of names of %s", range, key->of);
        }
        break;
    case MURK_KEY_MAP:
        snprintf(out, size, "a map of keys");
        if (key->words) {
            char words[PART_SIZE];
            show_words(key->words, words, sizeof words);
            snprintf(out, size, "%s or a map of keys", words);
        }
        break;
    case MURK_KEY_PER_BAND:
        show_words(key->words, range, sizeof range);
        snprintf(out, size,
                 "%s or a map of keys, or a list of them, one a "
                 "band",
                 range);
        break;
    case MURK_KEY_LIST:
        if (key->keys->needs_item) {
            snprintf(out, size, "a list of at least one %s", key->keys->noun);
        } else {
            snprintf(out, size, "a list of maps");
        }
        break;
    case MURK_KEY_NAMED:
        snprintf(out, size, "a map of names");
        break;
    case MURK_KEY_OWN:
        snprintf(out, size, "%s", key->allowed);
        break;
    }
}
