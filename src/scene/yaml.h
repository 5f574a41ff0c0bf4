/* YAML text as a tree in which every node knows its line and column.
 *
 * The one door to libyaml. Refused: more than 16 MB of text, nesting beyond
 * 64, more than 1e6 nodes, aliases (each use counted) that grow the tree past
 * that, duplicate keys, tags, more than one document, text that is not UTF-8. */
#ifndef MURK_SCENE_YAML_H
#define MURK_SCENE_YAML_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum murk_yaml_kind {
    MURK_YAML_SCALAR,
    MURK_YAML_LIST,
    MURK_YAML_MAP
} murk_yaml_kind;

typedef struct murk_yaml murk_yaml;
struct murk_yaml {
    murk_yaml_kind kind;
    int line, column;   /* 1-based */
    const char *source; /* file name, or the option's text, for messages */
    char *text;         /* scalars */
    bool is_quoted;     /* scalars: "12" is a text, 12 a number */
    size_t n;           /* lists and maps: children */
    char **key;         /* maps: [n] */
    murk_yaml **child;  /* [n] */
};

/* *out is the caller's: murk_yaml_destroy(). `source` is kept by the tree. */
murk_status murk_yaml_parse(murk_yaml **out, const char *text, size_t size,
                            const char *source, murk_error *err);
murk_status murk_yaml_read(murk_yaml **out, const char *path, murk_error *err);
void murk_yaml_destroy(murk_yaml *root); /* NULL is fine */

/* The child of a map, or NULL. */
murk_yaml *murk_yaml_get(const murk_yaml *map, const char *key);

/* Strict scalars: false when the node is not exactly one. Numbers: decimal or
 * exponent (1e6), finite, nothing behind them, not quoted. */
bool murk_yaml_number(const murk_yaml *node, double *out);
bool murk_yaml_count(const murk_yaml *node, uint64_t *out); /* 0, 3, 1e6 */
bool murk_yaml_bool(const murk_yaml *node, bool *out);      /* true, false */

#endif
