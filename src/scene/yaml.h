/* YAML text as a tree in which every node knows its line and column.
 *
 * The only file that uses libyaml is yaml_read.c. Refused: more than 16 MB of
 * text, nesting beyond 64 levels, more than 1e6 nodes or 32 MB of text after
 * aliases are expanded, more than 1000 anchors, duplicate keys, tags, merge
 * keys (<<), keys that are lists, maps or aliases or have an anchor, more than
 * one document, text that is not UTF-8, ASCII control characters other than tab
 * and line ends, and NUL characters that are written as escapes. */
#ifndef MURK_SCENE_YAML_H
#define MURK_SCENE_YAML_H

#include "base/place.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Limit against hostile files. */
#define MURK_YAML_MAX_BYTES 16000000

typedef enum murk_yaml_kind {
    MURK_YAML_SCALAR,
    MURK_YAML_LIST,
    MURK_YAML_MAP
} murk_yaml_kind;

typedef struct murk_yaml murk_yaml;
struct murk_yaml {
    murk_yaml_kind kind;
    int line, column;         /* 1-based; 0: made by the program, not read */
    int key_line, key_column; /* place of the key in a map; otherwise 0 */
    const char *source; /* file name, or the option's text, for messages */
    char *text;         /* scalars */
    bool is_quoted;     /* scalars: "12" is a text, 12 a number */
    size_t n;           /* number of children of a list or map */
    char **key;         /* maps: [n] */
    murk_yaml **child;  /* [n] */
};

/* Parses text. The caller owns *out and releases it with murk_yaml_destroy().
 * `source` is borrowed and must outlive the tree. A source that is an option
 * (murk_yaml_is_option()) has no line and column in messages. Empty text fails.
 * All failures are MURK_BAD_FILE or MURK_NO_MEMORY. */
murk_status murk_yaml_parse(murk_yaml **out, const char *text, size_t size,
                            const char *source, murk_error *err);
/* Parses a file; `path` is the source and must outlive the tree. */
murk_status murk_yaml_read(murk_yaml **out, const char *path, murk_error *err);
void murk_yaml_destroy(murk_yaml *root); /* NULL is fine */

/* The child of a map with a key; NULL if there is none or `map` is no map. */
murk_yaml *murk_yaml_get(const murk_yaml *map, const char *key);

/* Strict conversion of scalars: false if the node is not exactly such a
 * value. Numbers are decimal or with exponent (1e6), finite, without further
 * text, and not quoted. */
bool murk_yaml_number(const murk_yaml *node, double *out);
bool murk_yaml_count(const murk_yaml *node, uint64_t *out); /* 0, 3, 1e6 */
bool murk_yaml_bool(const murk_yaml *node, bool *out);      /* true, false */
bool murk_yaml_is_null(const murk_yaml *node); /* empty, ~ or null */

/* Changes to a tree. append() takes ownership of `key` (NULL in a list) and
 * `child`, put() of `child`, also on failure. Results are NULL or false when
 * out of memory. make() borrows `source`, and a copy borrows the sources of its
 * original; each source must outlive the nodes that have it. put() replaces the
 * value of an existing key; remove() of a missing key does nothing. */
murk_yaml *murk_yaml_make(murk_yaml_kind kind, const char *source);
murk_yaml *murk_yaml_copy(const murk_yaml *root); /* NULL: out of memory */
bool murk_yaml_append(murk_yaml *node, char *key, murk_yaml *child);
bool murk_yaml_put(murk_yaml *map, const char *key, murk_yaml *child);
void murk_yaml_remove(murk_yaml *map, const char *key);
void murk_yaml_clear(murk_yaml *node); /* removes all children and the text */
bool murk_yaml_set_text(murk_yaml *scalar, const char *text);

/* True if a source is no file but an option of the command line, which begins
 * with "--", or a call of the library, which begins with MURK_SET_MARK. Paths
 * in the value of an option are relative to the working folder. */
bool murk_yaml_is_option(const char *source);

/* The place of a node: "fog.yaml:12:5", the file alone for a node made by the
 * program, or the option. Long names are cut, and control characters are
 * escaped (base/utf8.h). */
void murk_yaml_place(const murk_yaml *node, char *out, size_t size);
void murk_yaml_show_place(const char *source, int line, int column, char *out,
                          size_t size);
/* The place of the key of a child of a map; for other nodes the place of the
 * node. */
void murk_yaml_key_place(const murk_yaml *child, char *out, size_t size);

#endif
