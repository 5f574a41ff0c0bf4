/* Operations on YAML trees: places for messages, copies, changes, and strict
 * conversion of scalars. */
#include "scene/yaml.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "base/words.h"

/* Space for escapes and for three dots. */
#define SHOWN_SIZE (MAX_SOURCE + 32)

/* Space for three dots. */
#define NAME_SIZE (MAX_SOURCE + 4)

#define MAX_SOURCE 120 /* bytes of a name that a message shows */

bool murk_yaml_is_option(const char *source)
{
    return strncmp(source, "--", 2) == 0 ||
           strncmp(source, MURK_SET_MARK, strlen(MURK_SET_MARK)) == 0;
}

void murk_yaml_show_place(const char *source, int line, int column, char *out,
                          size_t size)
{
    char name[NAME_SIZE], shown[SHOWN_SIZE];
    const size_t length = strlen(source);
    if (length <= MAX_SOURCE) {
        snprintf(name, sizeof name, "%s", source);
    } else if (murk_yaml_is_option(source)) {
        snprintf(name, sizeof name, "%.*s...", MAX_SOURCE - 3, source);
    } else { /* the end of a path tells more than the beginning */
        snprintf(name, sizeof name, "...%s", source + length - MAX_SOURCE + 3);
    }
    murk_words_show(shown, sizeof shown, name);
    if (line == 0 || murk_yaml_is_option(source)) {
        snprintf(out, size, "%s", shown);
    } else {
        snprintf(out, size, "%s:%d:%d", shown, line, column);
    }
}

void murk_yaml_place(const murk_yaml *node, char *out, size_t size)
{
    murk_yaml_show_place(node->source, node->line, node->column, out, size);
}

void murk_yaml_key_place(const murk_yaml *child, char *out, size_t size)
{
    const bool has_key = child->key_line > 0;
    murk_yaml_show_place(child->source, has_key ? child->key_line : child->line,
                         has_key ? child->key_column : child->column, out,
                         size);
}

void murk_yaml_clear(murk_yaml *node)
{
    for (size_t i = 0; i < node->n; ++i) {
        murk_yaml_destroy(node->child[i]);
        if (node->key) {
            free(node->key[i]);
        }
    }
    free(node->key);
    free(node->child);
    free(node->text);
    node->n = 0;
    node->key = NULL;
    node->child = NULL;
    node->text = NULL;
}

void murk_yaml_destroy(murk_yaml *root)
{
    if (root) {
        murk_yaml_clear(root);
        free(root);
    }
}

murk_yaml *murk_yaml_make(murk_yaml_kind kind, const char *source)
{
    murk_yaml *node = calloc(1, sizeof *node);
    if (node) {
        node->kind = kind;
        node->source = source;
        if (kind == MURK_YAML_SCALAR && !(node->text = strdup(""))) {
            free(node);
            node = NULL;
        }
    }
    return node;
}

/* Makes space for one more child: the capacity doubles at powers of two. */
static bool grow(murk_yaml *node)
{
    const size_t n = node->n;
    if (n != 0 && (n & (n - 1)) != 0) {
        return true;
    }
    const size_t capacity = n ? 2 * n : 1;
    murk_yaml **child = realloc(node->child, capacity * sizeof *child);
    if (!child) {
        return false;
    }
    node->child = child;
    if (node->kind == MURK_YAML_MAP) {
        char **key = realloc(node->key, capacity * sizeof *key);
        if (!key) {
            return false;
        }
        node->key = key;
    }
    return true;
}

/* Takes ownership of key (NULL in a list) and child, also on failure. */
bool murk_yaml_append(murk_yaml *node, char *key, murk_yaml *child)
{
    if (!grow(node)) {
        free(key);
        murk_yaml_destroy(child);
        return false;
    }
    if (node->kind == MURK_YAML_MAP) {
        node->key[node->n] = key;
    }
    node->child[node->n++] = child;
    return true;
}

murk_yaml *murk_yaml_copy(const murk_yaml *root)
{
    murk_yaml *out = murk_yaml_make(root->kind, root->source);
    if (!out) {
        return NULL;
    }
    out->line = root->line;
    out->column = root->column;
    out->key_line = root->key_line;
    out->key_column = root->key_column;
    out->is_quoted = root->is_quoted;
    bool is_whole = !root->text || murk_yaml_set_text(out, root->text);
    /* Copy the children, with their keys. */
    for (size_t i = 0; is_whole && i < root->n; ++i) {
        murk_yaml *child = murk_yaml_copy(root->child[i]);
        char *key = child && root->key ? strdup(root->key[i]) : NULL;
        is_whole = child && (key || !root->key);
        if (!is_whole) {
            murk_yaml_destroy(child);
        } else {
            is_whole = murk_yaml_append(out, key, child);
        }
    }
    if (!is_whole) {
        murk_yaml_destroy(out);
        out = NULL;
    }
    return out;
}

static size_t find_key(const murk_yaml *map, const char *key)
{
    size_t i = 0;
    while (i < map->n && strcmp(map->key[i], key) != 0) {
        ++i;
    }
    return i;
}

murk_yaml *murk_yaml_get(const murk_yaml *map, const char *key)
{
    if (map->kind != MURK_YAML_MAP) {
        return NULL;
    }
    const size_t i = find_key(map, key);
    return i < map->n ? map->child[i] : NULL;
}

bool murk_yaml_put(murk_yaml *map, const char *key, murk_yaml *child)
{
    const size_t i = find_key(map, key);
    if (i < map->n) {
        murk_yaml_destroy(map->child[i]);
        map->child[i] = child;
        return true;
    }
    char *name = strdup(key);
    if (!name) {
        murk_yaml_destroy(child);
        return false;
    }
    return murk_yaml_append(map, name, child);
}

void murk_yaml_remove(murk_yaml *map, const char *key)
{
    const size_t i = find_key(map, key);
    if (i == map->n) {
        return;
    }
    free(map->key[i]);
    murk_yaml_destroy(map->child[i]);
    for (size_t k = i + 1; k < map->n; ++k) {
        map->key[k - 1] = map->key[k];
        map->child[k - 1] = map->child[k];
    }
    --map->n;
}

bool murk_yaml_set_text(murk_yaml *scalar, const char *text)
{
    char *copy = strdup(text);
    if (!copy) {
        return false;
    }
    free(scalar->text);
    scalar->text = copy;
    return true;
}

static bool is_plain(const murk_yaml *node)
{
    return node->kind == MURK_YAML_SCALAR && !node->is_quoted;
}

bool murk_yaml_number(const murk_yaml *node, double *out)
{
    return is_plain(node) && murk_number_parse(node->text, out);
}

bool murk_yaml_count(const murk_yaml *node, uint64_t *out)
{
    return is_plain(node) && murk_count_parse(node->text, out);
}

bool murk_yaml_bool(const murk_yaml *node, bool *out)
{
    if (!is_plain(node)) {
        return false;
    }
    const bool is_true = strcmp(node->text, "true") == 0;
    if (!is_true && strcmp(node->text, "false") != 0) {
        return false;
    }
    *out = is_true;
    return true;
}

bool murk_yaml_is_null(const murk_yaml *node)
{
    return is_plain(node) &&
           (node->text[0] == '\0' || strcmp(node->text, "~") == 0 ||
            strcmp(node->text, "null") == 0 ||
            strcmp(node->text, "Null") == 0 || strcmp(node->text, "NULL") == 0);
}
