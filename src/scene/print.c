/* Prints YAML trees in one canonical form: a quoted text keeps quotes unless
 * it can only be read as itself. The value of a top-level key is printed in
 * flow style; a value that contains maps or lists of lists has one line in
 * flow style for each item. */
#include "scene/print.h"

#include "base/scalar.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_flow(FILE *out, const murk_yaml *node)
{
    if (node->kind == MURK_YAML_SCALAR) {
        if (node->is_quoted) {
            murk_scalar_print(out, node->text);
        } else {
            fputs(node->text, out);
        }
        return;
    }
    const bool is_map = node->kind == MURK_YAML_MAP;
    fputc(is_map ? '{' : '[', out);
    for (size_t i = 0; i < node->n; ++i) {
        fputs(i ? ", " : "", out);
        if (is_map) {
            murk_scalar_print(out, node->key[i]);
            fputs(": ", out);
        }
        print_flow(out, node->child[i]);
    }
    fputc(is_map ? '}' : ']', out);
}

static bool holds_containers(const murk_yaml *node)
{
    for (size_t i = 0; i < node->n; ++i) {
        const murk_yaml *child = node->child[i];
        if (child->kind == MURK_YAML_MAP ||
            (child->n > 0 && child->child[0]->kind != MURK_YAML_SCALAR)) {
            return true;
        }
    }
    return false;
}

static void print_lines(FILE *out, const murk_yaml *node)
{
    for (size_t i = 0; i < node->n; ++i) {
        if (node->kind == MURK_YAML_MAP) {
            fputs("\n  ", out);
            murk_scalar_print(out, node->key[i]);
            fputs(": ", out);
        } else {
            fputs("\n  - ", out);
        }
        print_flow(out, node->child[i]);
    }
}

void murk_print_map(FILE *out, const murk_yaml *map,
                    bool (*is_wanted)(const char *key))
{
    for (size_t i = 0; i < map->n; ++i) {
        if (is_wanted && !is_wanted(map->key[i])) {
            continue;
        }
        murk_scalar_print(out, map->key[i]);
        fputc(':', out);
        if (holds_containers(map->child[i])) {
            print_lines(out, map->child[i]);
        } else {
            fputc(' ', out);
            print_flow(out, map->child[i]);
        }
        fputc('\n', out);
    }
}

char *murk_print_finish(FILE *out, char **text)
{
    const bool failed = ferror(out) != 0;
    if (fclose(out) != 0 || failed) {
        free(*text);
        return NULL;
    }
    return *text;
}

char *murk_print_flow(const murk_yaml *node)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return NULL;
    }
    print_flow(out, node);
    return murk_print_finish(out, &text);
}

char *murk_print_file(const murk_yaml *map, bool (*is_wanted)(const char *key))
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return NULL;
    }
    murk_print_map(out, map, is_wanted);
    return murk_print_finish(out, &text);
}
