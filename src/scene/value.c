/* Reads values of a scene by their row of the key table: numbers, counts,
 * vectors, spectra, lists, texts, paths and names of materials and media. Each
 * value that is read is also rewritten in the tree in canonical form
 * (scene/print.h). */
#include "scene/value.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/memory_files.h"
#include "base/number.h"
#include "base/words.h"

/* Lists of numbers are read into size_t[] and murk_vec3 as if these were
 * uint64_t[] and double[3]. */
_Static_assert(sizeof(size_t) == sizeof(uint64_t), "sizes are counts");
_Static_assert(sizeof(murk_vec3) == 3 * sizeof(double), "a vector is a list");

murk_status murk_value_wrong(murk_key_reader *walk, const murk_key *key,
                             const murk_yaml *node)
{
    char found[MURK_FOUND_SIZE], allowed[MURK_ALLOWED_SIZE];
    murk_value_found(node, found);
    murk_value_allowed(key, allowed);
    return murk_walk_fail(walk, node, "%s, must be %s", found, allowed);
}

/* ---- one number ---- */

static murk_status check_range(murk_key_reader *walk, const murk_key *key,
                               const murk_yaml *node, double value)
{
    const bool is_any = key->min == 0 && key->max == 0;
    if (is_any || ((key->above ? value > key->min : value >= key->min) &&
                   (key->below ? value < key->max : value <= key->max))) {
        return MURK_OK;
    }
    char found[MURK_FOUND_SIZE], range[MURK_ALLOWED_SIZE];
    murk_value_found(node, found);
    murk_value_range(key, range, sizeof range);
    return murk_walk_fail(walk, node, "%s, must be %s", found, range);
}

static murk_status set_text(murk_key_reader *walk, murk_yaml *node,
                            const char *text)
{
    return murk_yaml_set_text(node, text) ? MURK_OK : murk_walk_no_memory(walk);
}

static murk_status read_number(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, void *member)
{
    double value;
    if (!murk_yaml_number(node, &value)) {
        return murk_value_wrong(walk, key, node);
    }
    const murk_status status = check_range(walk, key, node, value);
    if (status) {
        return status;
    }
    if (key->size) {
        *(double *)member = value * (key->factor != 0 ? key->factor : 1);
    }
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, value);
    return set_text(walk, node, text);
}

static murk_status read_count(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *member)
{
    uint64_t value = 0;
    double number;
    /* A number that is not whole is checked against the range, too: if the
     * number is outside, the message states the range. */
    const bool is_count = murk_yaml_count(node, &value);
    murk_status status = MURK_OK;
    if (is_count || murk_yaml_number(node, &number)) {
        status =
            check_range(walk, key, node, is_count ? (double)value : number);
    }
    if (!status && !is_count) {
        status = murk_value_wrong(walk, key, node);
    }
    if (status) {
        return status;
    }
    if (key->size == sizeof(uint32_t)) {
        *(uint32_t *)member = (uint32_t)value;
    } else if (key->size == sizeof value) {
        *(uint64_t *)member = value;
    }
    char text[MURK_NUMBER_SIZE];
    snprintf(text, sizeof text, "%llu", (unsigned long long)value);
    return set_text(walk, node, text);
}

static murk_status read_bool(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *member)
{
    return murk_yaml_bool(node, member) ? MURK_OK
                                        : murk_value_wrong(walk, key, node);
}

/* ---- names ---- */

/* Fails for an unknown name: suggests a similar name, or lists the names that
 * exist. */
static murk_status no_such_name(murk_key_reader *walk, const murk_key *key,
                                const murk_yaml *node, const murk_yaml *names)
{
    char found[MURK_FOUND_SIZE];
    murk_value_found(node, found);
    const size_t n = names ? names->n : 0;
    const char *meant =
        n ? murk_words_meant(node->text, (const char *const *)names->key, n)
          : NULL;
    if (meant) {
        char shown[MURK_SCENE_NAME_SIZE];
        murk_words_show(shown, sizeof shown, meant);
        return murk_walk_fail(walk, node, "%s is not in %s, did you mean %s?",
                              found, key->of, shown);
    }
    /* List the names that exist, as far as the message has space. */
    char list[MURK_ALLOWED_SIZE] = "";
    size_t length = 0;
    for (size_t i = 0; i < n && length + 80 < sizeof list; ++i) {
        char shown[MURK_SCENE_NAME_SIZE];
        murk_words_show(shown, sizeof shown, names->key[i]);
        length += (size_t)snprintf(list + length, sizeof list - length, "%s%s",
                                   i ? ", " : "", shown);
    }
    return murk_walk_fail(walk, node,
                          "%s is not in %s, must be a name given there: %s",
                          found, key->of, n ? list : "there are none");
}

static murk_status read_reference(murk_key_reader *walk, const murk_key *key,
                                  murk_yaml *node, void *member)
{
    if (node->kind != MURK_YAML_SCALAR || node->text[0] == '\0') {
        return murk_value_wrong(walk, key, node);
    }
    const murk_yaml *names = murk_yaml_get(walk->root, key->of);
    const size_t n = names ? names->n : 0;
    size_t i = 0;
    while (i < n && strcmp(names->key[i], node->text) != 0) {
        ++i;
    }
    if (i == n) {
        return no_such_name(walk, key, node, names);
    }
    node->is_quoted = true;
    if (key->size == sizeof(int)) {
        *(int *)member = (int)i;
    } else {
        *(size_t *)member = i;
    }
    return MURK_OK;
}

/* ---- lists of fixed length ---- */

/* Reads each value of a list into an array of `size` bytes per item. The items
 * are of one kind. Each item has a row of its own in key->items; without
 * key->items the row of the list serves all items. */
static murk_status read_items(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *list, murk_key_kind kind, size_t size,
                              void *items)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < list->n && !status; ++i) {
        murk_key one = key->items ? key->items[i] : *key;
        one.kind = kind;
        one.words = NULL;
        one.at = 0;
        one.size = size;
        const size_t back = murk_walk_enter_item(walk, i);
        status = murk_value_read(walk, &one, list->child[i],
                                 (char *)items + i * size);
        if (!status) {
            murk_walk_leave(walk, back);
        }
    }
    return status;
}

/* The number of values of a row of fixed length. */
static size_t length_of(const murk_key *key)
{
    if (key->kind == MURK_KEY_VECTOR) {
        return 3;
    }
    if (key->kind == MURK_KEY_SIZES) {
        return key->size / sizeof(size_t);
    }
    size_t n = 0;
    while (key->items[n].name) {
        ++n;
    }
    return n;
}

static murk_status read_array(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *member)
{
    const bool are_counts = key->kind == MURK_KEY_SIZES;
    return node->kind == MURK_YAML_LIST && node->n == length_of(key)
               ? read_items(walk, key, node,
                            are_counts ? MURK_KEY_COUNT : MURK_KEY_NUMBER,
                            sizeof(double), member)
               : murk_value_wrong(walk, key, node);
}

static murk_status read_bands(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *member)
{
    double *const out = member;
    const bool are_edges = key->kind == MURK_KEY_BAND_EDGES;
    if (node->kind != MURK_YAML_LIST || node->n < (are_edges ? 2 : 1) ||
        node->n > MURK_BANDS_MAX + (are_edges ? 1 : 0)) {
        return murk_value_wrong(walk, key, node);
    }
    /* Wavelengths must rise. */
    const murk_status status =
        read_items(walk, key, node, MURK_KEY_NUMBER, sizeof *out, out);
    if (status) {
        return status;
    }
    for (size_t i = 1; i < node->n; ++i) {
        if (!(out[i] > out[i - 1])) {
            return murk_walk_fail(walk, node->child[i],
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
                                 murk_yaml *node, void *member)
{
    murk_spectrum *out = member;
    const int bands = walk->scene->bands;
    murk_status status = MURK_OK;
    /* One value for all bands, or a total that is spread over the bands. */
    if (node->kind != MURK_YAML_LIST) {
        double value = 0;
        status = read_number(walk, key, node, &value);
        *out = murk_spectrum_flat(
            key->kind == MURK_KEY_SHARED ? value / bands : value, bands);
        return status;
    }
    /* One value for each band. */
    if (node->n != (size_t)bands) {
        return murk_walk_fail(
            walk, node,
            "a list of %zu, must be one number or a list of %d, one a band",
            node->n, bands);
    }
    status =
        read_items(walk, key, node, MURK_KEY_NUMBER, sizeof(double), out->band);
    if (!status && (key->kind == MURK_KEY_SPECTRUM || bands == 1)) {
        join_equal(node);
    }
    return status;
}

/* ---- lists of any length ---- */

/* Reads a list into a member of the form of murk_scene_numbers: the number of
 * items and an array of them. By the kind of the row the items are double,
 * size_t (indices of names), char * or murk_spectrum. */
static murk_status read_list(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *member)
{
    const murk_key_kind kind =
        key->kind == MURK_KEY_REFERENCES      ? MURK_KEY_REFERENCE
        : key->kind == MURK_KEY_TEXT_LIST     ? MURK_KEY_TEXT
        : key->kind == MURK_KEY_SPECTRUM_LIST ? MURK_KEY_SPECTRUM
                                              : MURK_KEY_NUMBER;
    const size_t size = kind == MURK_KEY_REFERENCE  ? sizeof(size_t)
                        : kind == MURK_KEY_SPECTRUM ? sizeof(murk_spectrum)
                                                    : sizeof(double);
    if (node->kind != MURK_YAML_LIST || node->n == 0) {
        return murk_value_wrong(walk, key, node);
    }
    if (node->n > MURK_SCENE_LIST_MAX) {
        return murk_walk_fail(walk, node, "a list of %zu, must be at most %d",
                              node->n, MURK_SCENE_LIST_MAX);
    }
    /* The struct that contains the member owns the array, even if reading
     * fails. */
    void *items = calloc(node->n, size);
    if (!items) {
        return murk_walk_no_memory(walk);
    }
    memcpy(member, &node->n, sizeof node->n);
    memcpy((char *)member + offsetof(murk_scene_numbers, value), &items,
           sizeof items);
    return read_items(walk, key, node, kind, size, items);
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
    char *copy = strdup(node->text);
    *(char **)member = copy;
    return copy ? MURK_OK : murk_walk_no_memory(walk);
}

char *murk_value_opened(const murk_yaml *node)
{
    return murk_yaml_is_option(node->source) || murk_memory_is(node->text)
               ? strdup(node->text)
               : murk_path_beside(node->source, node->text);
}

static murk_status read_path(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *member)
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
    char *path = murk_value_opened(node);
    *(char **)member = path;
    return path ? MURK_OK : murk_walk_no_memory(walk);
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

/* ---- all kinds ---- */

void murk_value_store(void *item, size_t at, size_t size, int value)
{
    char *const member = (char *)item + at;
    if (size == 1) {
        *member = (char)value;
    } else if (size == sizeof value) {
        memcpy(member, &value, sizeof value);
    }
}

murk_status murk_value_read(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *item)
{
    typedef murk_status reader(murk_key_reader *, const murk_key *, murk_yaml *,
                               void *member);
    static reader *const readers[] = {
        [MURK_KEY_NUMBER] = read_number,
        [MURK_KEY_COUNT] = read_count,
        [MURK_KEY_BOOL] = read_bool,
        [MURK_KEY_TEXT] = read_text,
        [MURK_KEY_PATH] = read_path,
        [MURK_KEY_REFERENCE] = read_reference,
        [MURK_KEY_REFERENCES] = read_list,
        [MURK_KEY_VECTOR] = read_array,
        [MURK_KEY_SIZES] = read_array,
        [MURK_KEY_NUMBERS] = read_array,
        [MURK_KEY_BANDS] = read_bands,
        [MURK_KEY_BAND_EDGES] = read_bands,
        [MURK_KEY_NUMBER_LIST] = read_list,
        [MURK_KEY_TEXT_LIST] = read_list,
        [MURK_KEY_SPECTRUM_LIST] = read_list,
        [MURK_KEY_SPECTRUM] = read_spectrum,
        [MURK_KEY_SHARED] = read_spectrum,
    };
    void *const member = (char *)item + key->at;
    if (key->kind == MURK_KEY_OWN) {
        return key->read(walk, key, node, member);
    }
    if (key->kind == MURK_KEY_WORD) { /* walk_map.c has read the words */
        return murk_value_wrong(walk, key, node);
    }
    assert(key->kind < sizeof readers / sizeof *readers && readers[key->kind]);
    return readers[key->kind](walk, key, node, member);
}
