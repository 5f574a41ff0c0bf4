/* Checks of YAML text that libyaml does not make: encoding, control
 * characters and duplicate keys. */
#include "scene/yaml_check.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"
#include "base/words.h"

/* A place in a message: a name of at most 120 bytes, escaped, with line and
 * column. */
#define PLACE_SIZE 256

/* Length of the UTF-8 character at p, or 0 if it is malformed. The text need
 * not end in a NUL. */
static size_t length_at(const char *p, size_t left)
{
    char text[5] = {0};
    memcpy(text, p, left < 4 ? left : 4);
    return murk_utf8_length(text);
}

murk_status murk_yaml_check_text(const char *text, size_t size,
                                 const char *source, murk_error *err)
{
    int line = 1, column = 1;
    for (size_t i = 0; i < size;) {
        const unsigned char *p = (const unsigned char *)text + i;
        const size_t n = length_at(text + i, size - i);
        const bool is_control =
            (*p < 0x20 && *p != '\t' && *p != '\n' && *p != '\r') || *p == 0x7F;
        /* Report the first bad byte with line and column. */
        if (n == 0 || is_control) {
            char place[PLACE_SIZE];
            murk_yaml_show_place(source, line, column, place, sizeof place);
            return murk_fail(err, MURK_BAD_FILE, place,
                             n == 0 ? "byte 0x%02X, must be UTF-8 text"
                                    : "control character 0x%02X, must be text",
                             *p);
        }
        ++column;
        if (*p == '\n') {
            ++line;
            column = 1;
        }
        i += n;
    }
    return MURK_OK;
}

typedef struct key_order {
    const char *key;
    size_t index;
} key_order;

static int compare_keys(const void *a, const void *b)
{
    const key_order *left = a, *right = b;
    const int order = strcmp(left->key, right->key);
    return order ? order
                 : (left->index > right->index) - (left->index < right->index);
}

/* Duplicates are found by sorting, since a million keys must not take a
 * million squared steps. */
murk_status murk_yaml_check_keys(const murk_yaml *map, murk_error *err)
{
    if (map->n < 2) {
        return MURK_OK;
    }
    key_order *order = malloc(map->n * sizeof *order);
    if (!order) {
        return murk_no_memory(err, map->source, "to read it");
    }
    for (size_t i = 0; i < map->n; ++i) {
        order[i] = (key_order){map->key[i], i};
    }
    qsort(order, map->n, sizeof *order, compare_keys);
    /* The first key in the file that repeats another. */
    size_t second = SIZE_MAX, first = 0;
    for (size_t i = 1; i < map->n; ++i) {
        if (strcmp(order[i - 1].key, order[i].key) == 0 &&
            order[i].index < second) {
            second = order[i].index;
            first = order[i - 1].index;
        }
    }
    free(order);
    if (second == SIZE_MAX) {
        return MURK_OK;
    }
    /* The message names both lines. */
    char place[PLACE_SIZE];
    char key[64];
    murk_yaml_key_place(map->child[second], place, sizeof place);
    murk_words_show(key, sizeof key, map->key[second]);
    return murk_fail(err, MURK_BAD_FILE, place,
                     "%s is given twice, first in line %d", key,
                     map->child[first]->key_line);
}
