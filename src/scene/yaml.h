/* YAML text as a tree in which every node knows its line and column.
 *
 * The one door to libyaml. Refused: more than 16 MB of text, nesting beyond
 * 64, more than 1e6 nodes or 32 MB of text once aliases are written out, more
 * than 1000 anchors, duplicate keys, tags, merge keys (<<), keys that are not
 * plain text, more than one document, text that is not UTF-8, control
 * characters (NUL). */
#ifndef MURK_SCENE_YAML_H
#define MURK_SCENE_YAML_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_YAML_MAX_BYTES 16000000

typedef enum murk_yaml_kind {
    MURK_YAML_SCALAR,
    MURK_YAML_LIST,
    MURK_YAML_MAP
} murk_yaml_kind;

typedef struct murk_yaml murk_yaml;
struct murk_yaml {
    murk_yaml_kind kind;
    int line, column;         /* 1-based; 0: made, not read */
    int key_line, key_column; /* of its key, in a map; 0 elsewhere */
    const char *source; /* file name, or the option's text, for messages */
    char *text;         /* scalars */
    bool is_quoted;     /* scalars: "12" is a text, 12 a number */
    size_t n;           /* lists and maps: children */
    char **key;         /* maps: [n] */
    murk_yaml **child;  /* [n] */
};

/* *out is the caller's: murk_yaml_destroy(). `source` is borrowed and must
 * outlive the tree; one that begins with -- is an option of the command line:
 * messages then name it without line and column. Empty text fails. */
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
bool murk_yaml_is_null(const murk_yaml *node); /* empty, ~ or null */

/* Changing a tree. append() takes `key` (NULL in a list) and `child`, put()
 * `child`, also where they fail: false when out of memory. put() replaces what
 * stood under that key; remove() of a missing key is fine. */
murk_yaml *murk_yaml_make(murk_yaml_kind kind, const char *source);
murk_yaml *murk_yaml_copy(const murk_yaml *root); /* NULL: out of memory */
bool murk_yaml_append(murk_yaml *node, char *key, murk_yaml *child);
bool murk_yaml_put(murk_yaml *map, const char *key, murk_yaml *child);
void murk_yaml_remove(murk_yaml *map, const char *key);
void murk_yaml_clear(murk_yaml *node); /* no children, no text */
bool murk_yaml_set_text(murk_yaml *scalar, const char *text);

/* "fog.yaml:12:5", or the file alone for a made node, or the option; long
 * names are cut, control characters shown as '?'. */
void murk_yaml_place(const murk_yaml *node, char *out, size_t size);
void murk_yaml_show_place(const char *source, int line, int column, char *out,
                          size_t size);
/* The same for the key of a map's child. */
void murk_yaml_key_place(const murk_yaml *child, char *out, size_t size);

#endif
