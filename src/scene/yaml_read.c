/* Reads YAML text by the events of libyaml, one at a time, so that a limit
 * is noticed before much has been read: libyaml's document interface would
 * build the whole tree first, and takes 20 s for 200,000 open brackets. */
#include "scene/yaml.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <yaml.h>

#include "base/file.h"
#include "base/words.h"
#include "scene/yaml_check.h"

/* Limits against hostile text; scene/yaml.h states them. */
#define MAX_DEPTH   64
#define MAX_NODES   1000000
#define MAX_TEXT    (2 * MURK_YAML_MAX_BYTES)
#define MAX_ANCHORS 1000
#define PLACE_SIZE  256

typedef struct anchor {
    char *name;
    const murk_yaml *node;
} anchor;

typedef struct reader {
    yaml_parser_t parser;
    const char *source;
    size_t nodes, text_bytes;
    anchor anchors[MAX_ANCHORS];
    size_t n_anchors;
    murk_error *err;
    murk_status status;
} reader;

/* Fails at a mark of the text. Always returns NULL. */
static void *fail_at(reader *r, yaml_mark_t mark, const char *text)
{
    char place[PLACE_SIZE];
    murk_yaml_show_place(r->source, (int)mark.line + 1, (int)mark.column + 1,
                         place, sizeof place);
    r->status = murk_fail(r->err, MURK_BAD_FILE, place, "%s", text);
    return NULL;
}

static void *no_memory(reader *r)
{
    r->status = murk_no_memory(r->err, r->source, "to read it");
    return NULL;
}

static bool next_event(reader *r, yaml_event_t *event)
{
    if (yaml_parser_parse(&r->parser, event)) {
        return true;
    }
    if (r->parser.error == YAML_MEMORY_ERROR) {
        no_memory(r);
        return false;
    }
    char text[256];
    snprintf(text, sizeof text, "not YAML: %s",
             r->parser.problem ? r->parser.problem : "cannot be read");
    fail_at(r, r->parser.problem_mark, text);
    return false;
}

/* Counts a node with a text of `length` bytes; false beyond the limits. */
static bool count_node(reader *r, yaml_mark_t mark, size_t length)
{
    ++r->nodes;
    r->text_bytes += length;
    if (r->nodes > MAX_NODES) {
        fail_at(r, mark,
                "too large, must be at most 1e6 nodes with all aliases written "
                "out");
    } else if (r->text_bytes > MAX_TEXT) {
        fail_at(
            r, mark,
            "too large, must be at most 32 MB with all aliases written out");
    }
    return !r->status;
}

/* Makes a node; `text` is that of a scalar, NULL for a list or a map. */
static murk_yaml *make_node(reader *r, murk_yaml_kind kind, yaml_mark_t mark,
                            const char *text)
{
    if (!count_node(r, mark, text ? strlen(text) : 0)) {
        return NULL;
    }
    murk_yaml *node = murk_yaml_make(kind, r->source);
    if (!node || (text && !murk_yaml_set_text(node, text))) {
        murk_yaml_destroy(node);
        return no_memory(r);
    }
    node->line = (int)mark.line + 1;
    node->column = (int)mark.column + 1;
    return node;
}

static bool is_in_depth(reader *r, yaml_mark_t mark, int depth)
{
    if (depth > MAX_DEPTH) {
        fail_at(r, mark, "nested too deep, must be at most 64 levels");
    }
    return !r->status;
}

/* Counts the nodes and the text that a copy of the tree `from` adds, whose
 * root lies at `depth`. False if a limit is exceeded. */
static bool count_copy(reader *r, const murk_yaml *from, yaml_mark_t mark,
                       int depth)
{
    bool is_within = is_in_depth(r, mark, depth) &&
                     count_node(r, mark, from->text ? strlen(from->text) : 0);
    for (size_t i = 0; i < from->n && is_within; ++i) {
        is_within = count_copy(r, from->child[i], mark, depth + 1);
        r->text_bytes += from->key ? strlen(from->key[i]) : 0;
    }
    return is_within;
}

static murk_yaml *read_alias(reader *r, const yaml_event_t *event, int depth)
{
    const char *name = (const char *)event->data.alias.anchor;
    for (size_t i = r->n_anchors; i-- > 0;) {
        if (strcmp(r->anchors[i].name, name) == 0) {
            if (!r->anchors[i].node) {
                return fail_at(r, event->start_mark,
                               "an alias inside its own anchor");
            }
            if (!count_copy(r, r->anchors[i].node, event->start_mark, depth)) {
                return NULL;
            }
            murk_yaml *node = murk_yaml_copy(r->anchors[i].node);
            if (!node) {
                return no_memory(r);
            }
            node->line = (int)event->start_mark.line + 1;
            node->column = (int)event->start_mark.column + 1;
            return node;
        }
    }
    return fail_at(r, event->start_mark, "an alias without its anchor");
}

/* Adds an anchor and returns its number; SIZE_MAX without a name or on
 * failure. */
static size_t add_anchor(reader *r, const yaml_char_t *name, yaml_mark_t mark)
{
    if (!name) {
        return SIZE_MAX;
    }
    if (r->n_anchors == MAX_ANCHORS) {
        fail_at(r, mark, "more than 1000 anchors");
        return SIZE_MAX;
    }
    char *copy = strdup((const char *)name);
    if (!copy) {
        no_memory(r);
        return SIZE_MAX;
    }
    anchor *added = &r->anchors[r->n_anchors];
    added->name = copy;
    added->node = NULL;
    return r->n_anchors++;
}

static murk_yaml *read_node(reader *r, yaml_event_t *event, int depth);

static murk_yaml *read_next(reader *r, int depth)
{
    yaml_event_t event;
    if (!next_event(r, &event)) {
        return NULL;
    }
    murk_yaml *node = read_node(r, &event, depth);
    yaml_event_delete(&event);
    return node;
}

/* Reads the key of a map; NULL on failure. Tags, anchors and merge keys are
 * refused. */
static char *read_key(reader *r, const yaml_event_t *event)
{
    if (event->type != YAML_SCALAR_EVENT) {
        return fail_at(r, event->start_mark, "not a key, must be a plain text");
    }
    const char *text = (const char *)event->data.scalar.value;
    if (event->data.scalar.tag || event->data.scalar.anchor) {
        return fail_at(r, event->start_mark,
                       "a tag or anchor at a key, must be a plain text");
    }
    if (strlen(text) != event->data.scalar.length) {
        return fail_at(r, event->start_mark, "a NUL character, must be text");
    }
    if (strcmp(text, "<<") == 0 &&
        event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE) {
        return fail_at(r, event->start_mark,
                       "a merge key (<<) is not allowed, write its keys out");
    }
    /* Keys count as text, too. */
    r->text_bytes += event->data.scalar.length;
    char *key = strdup(text);
    if (!key) {
        return no_memory(r);
    }
    return key;
}

/* Reads the children of a list or a map up to the event that ends it. */
static bool read_children(reader *r, murk_yaml *node, int depth)
{
    const bool is_map = node->kind == MURK_YAML_MAP;
    for (;;) {
        yaml_event_t event;
        if (!next_event(r, &event)) {
            return false;
        }
        /* An event is an item, a key, or the end. */
        const bool ends = event.type == (is_map ? YAML_MAPPING_END_EVENT
                                                : YAML_SEQUENCE_END_EVENT);
        const yaml_mark_t mark = event.start_mark;
        char *key = is_map && !ends ? read_key(r, &event) : NULL;
        murk_yaml *child =
            is_map || ends ? NULL : read_node(r, &event, depth + 1);
        yaml_event_delete(&event);
        if (ends) {
            r->status = is_map ? murk_yaml_check_keys(node, r->err) : MURK_OK;
            return !r->status;
        }
        /* The value of a key. */
        if (key && (child = read_next(r, depth + 1))) {
            child->key_line = (int)mark.line + 1;
            child->key_column = (int)mark.column + 1;
        }
        if (!child) {
            free(key);
            return false;
        }
        if (!murk_yaml_append(node, key, child)) {
            no_memory(r);
            return false;
        }
    }
}

static murk_yaml *read_scalar(reader *r, const yaml_event_t *event)
{
    const char *text = (const char *)event->data.scalar.value;
    if (strlen(text) != event->data.scalar.length) {
        return fail_at(r, event->start_mark, "a NUL character, must be text");
    }
    murk_yaml *node = make_node(r, MURK_YAML_SCALAR, event->start_mark, text);
    if (node) {
        node->is_quoted = event->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
    }
    return node;
}

static murk_yaml *read_node(reader *r, yaml_event_t *event, int depth)
{
    const yaml_char_t *name = NULL, *tag = NULL;
    murk_yaml_kind kind = MURK_YAML_SCALAR;
    /* Kind, anchor and tag of the node. */
    switch (event->type) {
    case YAML_ALIAS_EVENT:
        return read_alias(r, event, depth);
    case YAML_SCALAR_EVENT:
        name = event->data.scalar.anchor;
        tag = event->data.scalar.tag;
        break;
    case YAML_SEQUENCE_START_EVENT:
        name = event->data.sequence_start.anchor;
        tag = event->data.sequence_start.tag;
        kind = MURK_YAML_LIST;
        break;
    case YAML_MAPPING_START_EVENT:
        name = event->data.mapping_start.anchor;
        tag = event->data.mapping_start.tag;
        kind = MURK_YAML_MAP;
        break;
    default:
        return fail_at(r, event->start_mark, "empty, must be a value");
    }
    /* Tags and deep nesting are refused. */
    if (tag) {
        char text[128], shown[48];
        murk_words_show(shown, sizeof shown, (const char *)tag);
        snprintf(text, sizeof text, "a tag (%s) is not allowed", shown);
        return fail_at(r, event->start_mark, text);
    }
    if (!is_in_depth(r, event->start_mark, depth)) {
        return NULL;
    }
    /* The anchor is known before the children, so that an alias inside of it
     * is recognised. */
    const size_t number = add_anchor(r, name, event->start_mark);
    if (r->status) {
        return NULL;
    }
    /* Read the node and all children. */
    murk_yaml *node = kind == MURK_YAML_SCALAR
                          ? read_scalar(r, event)
                          : make_node(r, kind, event->start_mark, NULL);
    if (node && kind != MURK_YAML_SCALAR && !read_children(r, node, depth)) {
        murk_yaml_destroy(node);
        node = NULL;
    }
    if (node && number != SIZE_MAX) {
        r->anchors[number].node = node;
    }
    return node;
}

static murk_yaml *read_document(reader *r)
{
    murk_yaml *root = NULL;
    bool has_ended = false;
    while (!has_ended) {
        yaml_event_t event;
        if (!next_event(r, &event)) {
            break;
        }
        /* Exactly one document is allowed. */
        const yaml_mark_t mark = event.start_mark;
        const yaml_event_type_t type = event.type;
        if (type == YAML_STREAM_END_EVENT) {
            has_ended = true;
        } else if (type == YAML_DOCUMENT_START_EVENT && root) {
            fail_at(r, mark, "a second document, must be only one");
        } else if (type == YAML_DOCUMENT_START_EVENT) {
            root = read_next(r, 1);
        }
        yaml_event_delete(&event);
        if (r->status) {
            break;
        }
    }
    if (!r->status && !root) {
        r->status =
            murk_fail(r->err, MURK_BAD_FILE, r->source, "empty, must be YAML");
    }
    if (r->status) {
        murk_yaml_destroy(root);
        root = NULL;
    }
    return root;
}

murk_status murk_yaml_parse(murk_yaml **out, const char *text, size_t size,
                            const char *source, murk_error *err)
{
    if (size > MURK_YAML_MAX_BYTES) {
        return murk_fail(err, MURK_BAD_FILE, source,
                         "%.4g MB, must be at most 16 MB", (double)size / 1e6);
    }
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) {
        text += 3; /* skip the byte order mark */
        size -= 3;
    }
    murk_status status = murk_yaml_check_text(text, size, source, err);
    if (status) {
        return status;
    }
    reader *r = calloc(1, sizeof *r);
    if (!r || !yaml_parser_initialize(&r->parser)) {
        free(r);
        return murk_no_memory(err, source, "to read it");
    }
    r->source = source;
    r->err = err;
    yaml_parser_set_encoding(&r->parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&r->parser, (const unsigned char *)text, size);
    murk_yaml *root = read_document(r);
    status = r->status;
    for (size_t i = 0; i < r->n_anchors; ++i) {
        free(r->anchors[i].name);
    }
    yaml_parser_delete(&r->parser);
    free(r);
    if (!status) {
        *out = root;
    }
    return status;
}

murk_status murk_yaml_read(murk_yaml **out, const char *path, murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    murk_status status =
        murk_file_read(&text, &size, path, MURK_YAML_MAX_BYTES, err);
    if (!status) {
        status = murk_yaml_parse(out, text, size, path, err);
    }
    free(text);
    return status;
}
