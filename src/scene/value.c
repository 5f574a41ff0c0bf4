/* Reads values of a scene by their row of the key table: numbers, counts,
 * vectors, spectra, lists, texts, paths and words. Each value that is read
 * is also rewritten in the tree in canonical form (scene/print.h). */
#include "scene/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/number.h"
#include "scene/words.h"

murk_status murk_value_wrong(murk_key_reader *walk, const murk_key *key,
                             const murk_yaml *node)
{
    char found[MURK_FOUND_SIZE], allowed[MURK_ALLOWED_SIZE];
    murk_value_found(node, found);
    murk_value_allowed(key, allowed);
    return murk_walk_fail(walk, MURK_BAD_VALUE, node, false, "%s, must be %s",
                          found, allowed);
}

/* ---- one number ---- */

static bool is_within(const murk_key *key, double value)
{
    if (key->min == 0 && key->max == 0) {
        return true;
    }
    return (key->above ? value > key->min : value >= key->min) &&
           (key->below ? value < key->max : value <= key->max);
}

static murk_status out_of_range(murk_key_reader *walk, const murk_key *key,
                                const murk_yaml *node)
{
    char found[MURK_FOUND_SIZE], range[MURK_ALLOWED_SIZE];
    murk_value_found(node, found);
    murk_value_range(key, range, sizeof range);
    return murk_walk_fail(walk, MURK_BAD_VALUE, node, false, "%s, must be %s",
                          found, range);
}

static murk_status read_number(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, double *out)
{
    double value;
    if (!murk_yaml_number(node, &value)) {
        murk_key one = *key; /* an item of a list is a number, too */
        one.kind = MURK_KEY_NUMBER;
        return murk_value_wrong(walk, &one, node);
    }
    if (!is_within(key, value)) {
        return out_of_range(walk, key, node);
    }
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, value);
    if (!murk_yaml_set_text(node, text)) {
        return murk_walk_no_memory(walk);
    }
    *out = value;
    return MURK_OK;
}

static murk_status read_count(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, uint64_t *out)
{
    uint64_t value;
    double number;
    if (!murk_yaml_count(node, &value)) {
        if (murk_yaml_number(node, &number) && !is_within(key, number)) {
            return out_of_range(walk, key, node);
        }
        murk_key one = *key;
        one.kind = MURK_KEY_COUNT;
        return murk_value_wrong(walk, &one, node);
    }
    if (!is_within(key, (double)value)) {
        return out_of_range(walk, key, node);
    }
    char text[MURK_NUMBER_SIZE];
    snprintf(text, sizeof text, "%llu", (unsigned long long)value);
    if (!murk_yaml_set_text(node, text)) {
        return murk_walk_no_memory(walk);
    }
    *out = value;
    return MURK_OK;
}

/* ---- lists of fixed length ---- */

typedef murk_status (*item_reader)(murk_key_reader *walk, const murk_key *key,
                                   murk_yaml *node, size_t index, void *out);

static murk_status number_item(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, size_t index, void *out)
{
    return read_number(walk, key, node, (double *)out + index);
}

static murk_status count_item(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, size_t index, void *out)
{
    uint64_t value = 0;
    const murk_status status = read_count(walk, key, node, &value);
    ((size_t *)out)[index] = (size_t)value;
    return status;
}

static murk_status read_items(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *list, item_reader read, void *out)
{
    for (size_t i = 0; i < list->n; ++i) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        const size_t back = murk_walk_enter(walk, number);
        const murk_status status = read(walk, key, list->child[i], i, out);
        murk_walk_leave(walk, back);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

static murk_status read_vector(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, murk_vec3 *out)
{
    double v[3] = {0};
    if (node->kind != MURK_YAML_LIST || node->n != 3) {
        return murk_value_wrong(walk, key, node);
    }
    const murk_status status = read_items(walk, key, node, number_item, v);
    *out = murk_vec(v[0], v[1], v[2]);
    return status;
}

static size_t items_of(const murk_key *key)
{
    size_t n = 0;
    while (key->items[n].name) {
        ++n;
    }
    return n;
}

static murk_status numbers_item(murk_key_reader *walk, const murk_key *key,
                                murk_yaml *node, size_t index, void *out)
{
    return read_number(walk, &key->items[index], node, (double *)out + index);
}

static murk_status read_numbers(murk_key_reader *walk, const murk_key *key,
                                murk_yaml *node, double *out)
{
    if (node->kind != MURK_YAML_LIST || node->n != items_of(key)) {
        return murk_value_wrong(walk, key, node);
    }
    return read_items(walk, key, node, numbers_item, out);
}

static murk_status read_bands(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, double *out)
{
    const bool are_edges = key->kind == MURK_KEY_BAND_EDGES;
    if (node->kind != MURK_YAML_LIST || node->n < (are_edges ? 2 : 1) ||
        node->n > MURK_BANDS_MAX + (are_edges ? 1 : 0)) {
        return murk_value_wrong(walk, key, node);
    }
    /* Wavelengths must rise. */
    const murk_status status = read_items(walk, key, node, number_item, out);
    if (status) {
        return status;
    }
    for (size_t i = 1; i < node->n; ++i) {
        if (!(out[i] > out[i - 1])) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, node->child[i], false,
                                  "%.9g after %.9g, must rise, nm", out[i],
                                  out[i - 1]);
        }
    }
    /* A band between edges has the middle as wavelength. */
    murk_scene_desc *scene = walk->scene;
    scene->has_edges = are_edges;
    scene->bands = (int)node->n - (are_edges ? 1 : 0);
    for (int i = 0; are_edges && i < scene->bands; ++i) {
        scene->band_nm[i] = 0.5 * (out[i] + out[i + 1]);
    }
    return MURK_OK;
}

/* Replaces a list of equal values by one value, so that equal scenes have
 * one form. */
static void join_equal(murk_yaml *list)
{
    for (size_t i = 1; i < list->n; ++i) {
        if (strcmp(list->child[i]->text, list->child[0]->text) != 0) {
            return;
        }
    }
    char *text = list->child[0]->text;
    list->child[0]->text = NULL;
    murk_yaml_clear(list);
    list->kind = MURK_YAML_SCALAR;
    list->text = text;
}

static murk_status read_spectrum(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, murk_spectrum *out)
{
    const int bands = walk->scene->bands;
    /* One value for each band. */
    if (node->kind == MURK_YAML_LIST) {
        if (node->n != (size_t)bands) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                                  "a list of %zu, must be one number or a list "
                                  "of %d, one a band",
                                  node->n, bands);
        }
        const murk_status status =
            read_items(walk, key, node, number_item, out->band);
        if (!status && (key->kind == MURK_KEY_SPECTRUM || bands == 1)) {
            join_equal(node);
        }
        return status;
    }
    /* One value for all bands, or a total that is spread over the bands. */
    double value = 0;
    if (!murk_yaml_number(node, &value)) {
        return murk_value_wrong(walk, key, node);
    }
    const murk_status status = read_number(walk, key, node, &value);
    *out = murk_spectrum_flat(
        key->kind == MURK_KEY_SHARED ? value / bands : value, bands);
    return status;
}

/* ---- lists of any length ---- */

static murk_status spectrum_item(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, size_t index, void *out)
{
    murk_key one = *key;
    one.kind = MURK_KEY_SPECTRUM;
    return read_spectrum(walk, &one, node, (murk_spectrum *)out + index);
}

static murk_status check_length(murk_key_reader *walk, const murk_key *key,
                                const murk_yaml *node)
{
    if (node->kind != MURK_YAML_LIST || node->n == 0) {
        return murk_value_wrong(walk, key, node);
    }
    return node->n <= MURK_SCENE_LIST_MAX
               ? MURK_OK
               : murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                                "a list of %zu, must be at most %d", node->n,
                                MURK_SCENE_LIST_MAX);
}

static murk_status read_number_list(murk_key_reader *walk, const murk_key *key,
                                    murk_yaml *node, murk_scene_numbers *out)
{
    const murk_status status = check_length(walk, key, node);
    if (status) {
        return status;
    }
    out->value = calloc(node->n, sizeof *out->value);
    if (!out->value) {
        return murk_walk_no_memory(walk);
    }
    out->n = node->n;
    return read_items(walk, key, node, number_item, out->value);
}

static murk_status read_spectrum_list(murk_key_reader *walk,
                                      const murk_key *key, murk_yaml *node,
                                      murk_scene_spectra *out)
{
    const murk_status status = check_length(walk, key, node);
    if (status) {
        return status;
    }
    out->value = calloc(node->n, sizeof *out->value);
    if (!out->value) {
        return murk_walk_no_memory(walk);
    }
    out->n = node->n;
    return read_items(walk, key, node, spectrum_item, out->value);
}

/* ---- texts ---- */

static murk_status read_text(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *member)
{
    const bool is_text = node->kind == MURK_YAML_SCALAR &&
                         node->text[0] != '\0' && !murk_yaml_is_null(node);
    if (!is_text || strlen(node->text) > murk_value_max_bytes(key)) {
        return murk_value_wrong(walk, key, node);
    }
    node->is_quoted = true; /* a text, even if it looks like a number */
    if (key->size == sizeof(murk_scene_name)) {
        memcpy(member, node->text, strlen(node->text) + 1);
        return MURK_OK;
    }
    char **out = member;
    *out = strdup(node->text);
    return *out ? MURK_OK : murk_walk_no_memory(walk);
}

char *murk_value_opened(const murk_yaml *node, const murk_yaml *root,
                        const char *scene_path)
{
    if (node->source == root->source) {
        return murk_path_beside(scene_path, node->text);
    }
    return strncmp(node->source, "--", 2) == 0
               ? strdup(node->text)
               : murk_path_beside(node->source, node->text);
}

static murk_status read_path(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, char **out)
{
    if (node->kind != MURK_YAML_SCALAR || node->text[0] == '\0' ||
        murk_yaml_is_null(node)) {
        return murk_value_wrong(walk, key, node);
    }
    node->is_quoted = true;
    murk_yaml **paths =
        realloc(walk->paths, (walk->n_paths + 1) * sizeof *paths);
    if (!paths) {
        return murk_walk_no_memory(walk);
    }
    walk->paths = paths;
    walk->paths[walk->n_paths++] = node;
    *out = murk_value_opened(node, walk->root, walk->scene->path);
    return *out ? MURK_OK : murk_walk_no_memory(walk);
}

murk_status murk_value_word(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, int *value)
{
    const char *text = node->kind == MURK_YAML_SCALAR ? node->text : "";
    for (const murk_word *word = key->words; word->text; ++word) {
        if (strcmp(word->text, text) != 0) {
            continue;
        }
        node->is_quoted = false; /* no word of a table needs quotes */
        if (value) {
            *value = word->value;
        }
        return MURK_OK;
    }
    return murk_value_wrong(walk, key, node);
}

/* ---- storing, and all kinds ---- */

void murk_value_store(void *item, size_t at, size_t size, int value)
{
    char *const member = (char *)item + at;
    if (size == 1) {
        *member = (char)value;
    } else if (size == sizeof value) {
        memcpy(member, &value, sizeof value);
    }
}

static void store_count(void *member, size_t size, uint64_t value)
{
    if (size == sizeof(uint32_t)) {
        *(uint32_t *)member = (uint32_t)value;
    } else if (size == sizeof value) {
        *(uint64_t *)member = value;
    }
}

murk_status murk_value_read(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item)
{
    void *const member = (char *)item + key->at;
    murk_status status = MURK_OK;
    double number = 0;
    uint64_t count = 0;
    int word = 0;
    bool fact = false;
    /* Read the value by kind and store it in the member. */
    switch (key->kind) {
    case MURK_KEY_NUMBER:
        status = read_number(walk, key, node, &number);
        if (!status && key->size) {
            *(double *)member = number * (key->factor != 0 ? key->factor : 1);
        }
        return status;
    case MURK_KEY_COUNT:
        status = read_count(walk, key, node, &count);
        if (!status) {
            store_count(member, key->size, count);
        }
        return status;
    case MURK_KEY_BOOL:
        if (!murk_yaml_bool(node, &fact)) {
            return murk_value_wrong(walk, key, node);
        }
        murk_value_store(item, key->at, key->size, fact);
        return MURK_OK;
    case MURK_KEY_WORD:
        status = murk_value_word(walk, key, node, &word);
        if (!status) {
            murk_value_store(item, key->at, key->size, word);
        }
        return status;
    case MURK_KEY_TEXT:
        return read_text(walk, key, node, member);
    case MURK_KEY_PATH:
        return read_path(walk, key, node, member);
    case MURK_KEY_REFERENCE:
        return murk_value_reference(walk, key, node, member);
    case MURK_KEY_REFERENCES:
        return murk_value_references(walk, key, node, member);
    case MURK_KEY_VECTOR:
        return read_vector(walk, key, node, member);
    case MURK_KEY_SIZES:
        if (node->kind != MURK_YAML_LIST ||
            node->n != key->size / sizeof(size_t)) {
            return murk_value_wrong(walk, key, node);
        }
        return read_items(walk, key, node, count_item, member);
    case MURK_KEY_NUMBER_LIST:
        return read_number_list(walk, key, node, member);
    case MURK_KEY_SPECTRUM_LIST:
        return read_spectrum_list(walk, key, node, member);
    case MURK_KEY_NUMBERS:
        return read_numbers(walk, key, node, member);
    case MURK_KEY_BANDS:
    case MURK_KEY_BAND_EDGES:
        return read_bands(walk, key, node, member);
    case MURK_KEY_SPECTRUM:
    case MURK_KEY_SHARED:
        return read_spectrum(walk, key, node, member);
    case MURK_KEY_OWN:
        return key->read(walk, key, node, item);
    /* Kinds that walk_map.c reads. */
    case MURK_KEY_MAP:
    case MURK_KEY_PER_BAND:
    case MURK_KEY_LIST:
    case MURK_KEY_NAMED:
        break;
    }
    return murk_value_wrong(walk, key, node);
}
