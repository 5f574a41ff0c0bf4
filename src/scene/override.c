/* Follows a path such as media.fog.albedo through a scene's tree and the key
 * table at the same time, creates maps on the way where the table allows,
 * and puts the value at the end. */
#include "scene/override.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "base/words.h"
#include "scene/key_path.h"
#include "scene/walk.h"

typedef struct option_context {
    const char *source; /* source of nodes created on the way */
    const char *where;  /* place for messages */
    /* [n_own] the values put before; NULL: all values that are not from the
     * file of the scene */
    murk_yaml *const *own;
    size_t n_own;
    const murk_yaml *root;
    murk_error *err;
} option_context;

static murk_status fail(const option_context *option, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static murk_status fail(const option_context *option, const char *format, ...)
{
    char text[256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return murk_fail(option->err, MURK_BAD_VALUE, option->where, "%s", text);
}

static bool is_open_map(const murk_key_position *at)
{
    return murk_key_path_is_map(at) && at->row->keys->is_open;
}

static murk_status unknown(const option_context *option, const murk_key *owner,
                           const char *part, const char *const *names, size_t n)
{
    char shown[MURK_SCENE_NAME_SIZE];
    murk_words_show(shown, sizeof shown, part);
    return fail(option, "no %s in %s%s", shown,
                owner->name ? owner->name : "the scene",
                murk_words_suggest(part, names, n).text);
}

static murk_status unknown_key(const option_context *option,
                               const murk_key *owner, const char *part)
{
    const char *names[64];
    size_t n = 0;
    for (const murk_key *key = owner->keys->key; key->name && n < 64; ++key) {
        names[n++] = key->name;
    }
    return unknown(option, owner, part, names, n);
}

/* True if the node is a value that the same command line, condition or row of a
 * study put there, or, for the latter two, contains such a value. */
static bool is_own(const option_context *option, const murk_yaml *node)
{
    if (!option->own) {
        return node->source != option->root->source;
    }
    for (size_t i = 0; i < option->n_own; ++i) {
        if (option->own[i] == node) {
            return true;
        }
    }
    for (size_t i = 0; i < node->n; ++i) {
        if (is_own(option, node->child[i])) {
            return true;
        }
    }
    return false;
}

/* Removes the keys that `key` excludes. Fails if one of them has been set by
 * the same command line, condition or row of a study. */
static murk_status remove_excluded(const option_context *option, murk_yaml *map,
                                   const murk_key *owner, const murk_key *key)
{
    for (const murk_key *other = owner->keys->key; key->group && other->name;
         ++other) {
        const murk_yaml *rival = murk_yaml_get(map, other->name);
        if (other->group != key->group || strcmp(other->name, key->name) == 0 ||
            !rival) {
            continue;
        }
        if (is_own(option, rival)) {
            return fail(option, "%s and %s are both %s, must be one of them",
                        other->name, key->name,
                        option->own ? "in the condition"
                                    : "on the command line");
        }
        murk_yaml_remove(map, other->name);
    }
    return MURK_OK;
}

/* Turns a single value, such as the word in `phase: isotropic`, into an empty
 * map if the table allows a map there; for a map of names only an empty
 * value. The name of a file that is short for a map becomes that map. */
static bool make_map(const murk_key_position *at)
{
    murk_yaml *node = at->node;
    const bool can =
        node->kind == MURK_YAML_SCALAR && at->row &&
        (murk_key_path_is_map(at) ||
         (at->row->kind == MURK_KEY_NAMED && murk_yaml_is_null(node)));
    if (can && at->row->takes_file && !at->in_item &&
        !murk_yaml_is_null(node)) {
        return murk_walk_make_file_map(node);
    }
    if (can) {
        murk_yaml_clear(node);
        node->kind = MURK_YAML_MAP;
        node->is_quoted = false;
    }
    return can;
}

static size_t bands_of(const murk_yaml *root)
{
    const bool is_scene = root->kind == MURK_YAML_MAP;
    const murk_yaml *lines = is_scene ? murk_yaml_get(root, "bands_nm") : NULL;
    const murk_yaml *edges =
        is_scene ? murk_yaml_get(root, "band_edges_nm") : NULL;
    return lines && lines->kind == MURK_YAML_LIST               ? lines->n
           : edges && edges->kind == MURK_YAML_LIST && edges->n ? edges->n - 1
                                                                : 1;
}

static bool is_index(const char *part)
{
    return part[0] && strspn(part, "0123456789") == strlen(part);
}

static murk_status step_list(const option_context *option,
                             const murk_key_position *at, const char *part,
                             murk_yaml **value, murk_yaml **child)
{
    murk_yaml *list = at->node;
    size_t index;
    char shown[MURK_SCENE_NAME_SIZE];
    /* The part must be the number or the name of an existing item. */
    murk_words_show(shown, sizeof shown, part);
    if (list->n == 0) {
        return fail(option, "item %s of an empty list", shown);
    }
    if (!murk_key_path_item(list, part, &index)) {
        const bool has_names =
            at->row && at->row->keys && murk_keys_find(at->row->keys, "name");
        return fail(option, "item %s of a list of %zu, must be 0..%zu%s", shown,
                    list->n, list->n - 1,
                    has_names && !is_index(part) ? " or the name of an item"
                                                 : "");
    }
    /* The last part of the path: replace the item. */
    if (value) {
        (*value)->key_line = 0;
        murk_yaml_destroy(list->child[index]);
        list->child[index] = *value;
        *value = NULL;
    }
    *child = list->child[index];
    return MURK_OK;
}

static murk_status step_map(const option_context *option,
                            const murk_key_position *at, const char *part,
                            murk_yaml **value, murk_yaml **child)
{
    const murk_key *owner = at->row;
    const murk_key *next = murk_key_path_member(at, part, NULL).row;
    murk_yaml *map = at->node;
    *child = murk_yaml_get(map, part);
    if (!next && !*child && !is_open_map(at)) {
        return unknown_key(option, owner, part);
    }
    /* A name that does not exist cannot be a part on the way, except a name
     * that is built in. */
    const bool is_named = owner->kind == MURK_KEY_NAMED && !at->in_item;
    const bool is_built_in =
        is_named && owner->keys->first && strcmp(owner->keys->first, part) == 0;
    if (is_named && !*child && !value && !is_built_in) {
        return unknown(option, owner, part, (const char *const *)map->key,
                       map->n);
    }
    /* A new key replaces those that it excludes. */
    if (next && murk_key_path_is_map(at)) {
        const murk_status status = remove_excluded(option, map, owner, next);
        if (status) {
            return status;
        }
    }
    /* Put the value, or create a map on the way. */
    if (value || !*child) {
        *child = value ? *value : murk_yaml_make(MURK_YAML_MAP, option->source);
        if (value) {
            *value = NULL;
        }
        if (!*child || !murk_yaml_put(map, part, *child)) {
            return murk_no_memory(option->err, option->where, "for it");
        }
    }
    return MURK_OK;
}

/* Descends by one part of the path; the last part puts *value there and
 * takes ownership. */
static murk_status step(const option_context *option, murk_key_position *at,
                        const char *part, murk_yaml **value)
{
    const size_t bands = bands_of(option->root);
    murk_yaml *child = NULL;
    murk_status status = MURK_OK;
    if (at->node->kind == MURK_YAML_LIST ||
        (is_index(part) && bands > 1 && murk_key_path_spread(at, bands))) {
        status = step_list(option, at, part, value, &child);
    } else if (at->node->kind == MURK_YAML_MAP || make_map(at)) {
        if (!at->row || !at->row->keys) {
            return fail(option, "a key that cannot be set by its path");
        }
        status = step_map(option, at, part, value, &child);
    } else {
        char shown[MURK_SCENE_NAME_SIZE];
        murk_words_show(shown, sizeof shown, part);
        return fail(option, "%s is below a single value", shown);
    }
    *at = murk_key_path_member(at, part, child);
    return status;
}

static murk_status descend(const option_context *option, murk_yaml *root,
                           char *path, murk_yaml **value)
{
    murk_key_position at = murk_key_path_root(root);
    for (;;) {
        const size_t length = murk_key_path_part(&at, path);
        const bool is_last = path[length] == '\0';
        path[length] = '\0';
        if (length == 0) {
            return fail(option, "an empty key, must be KEY=VALUE, such as "
                                "photons.emit=1e5");
        }
        const murk_status status =
            step(option, &at, path, is_last ? value : NULL);
        if (status || is_last) {
            return status;
        }
        path += length + 1;
    }
}

bool murk_override_overlap(const char *a, const char *b)
{
    const size_t n = strlen(a), m = strlen(b), min = n < m ? n : m;
    return strncmp(a, b, min) == 0 && (n == m || (n < m ? b : a)[min] == '.');
}

murk_status murk_override_make(murk_override *out, const char *key,
                               const char *value, murk_error *err)
{
    const size_t size = sizeof MURK_SET_MARK "=" + strlen(key) + strlen(value);
    char *option = malloc(size);
    if (!option) {
        return murk_no_memory(err, key, "for the key");
    }
    snprintf(option, size, MURK_SET_MARK "%s=%s", key, value);
    out->text = option + strlen(MURK_SET_MARK);
    out->option = option;
    return MURK_OK;
}

void murk_override_release(murk_override *made)
{
    free((char *)made->option); /* which contains the text */
    *made = (murk_override){0};
}

char *murk_override_source(const murk_override *override)
{
    const char *prefix = override->option ? "" : "--" MURK_SET_MARK;
    const char *text = override->option ? override->option : override->text;
    const size_t size = strlen(prefix) + strlen(text) + 1;
    char *source = malloc(size);
    if (source) {
        snprintf(source, size, "%s%s", prefix, text);
    }
    return source;
}

static murk_status put(const option_context *option, murk_yaml *root,
                       const char *path, size_t length, murk_yaml *value)
{
    char *own_path = strndup(path, length);
    if (!own_path) {
        murk_yaml_destroy(value);
        return murk_no_memory(option->err, option->where, "for it");
    }
    const murk_status status = descend(option, root, own_path, &value);
    free(own_path);
    murk_yaml_destroy(value);
    return status;
}

murk_status murk_override_put(murk_yaml *root, const char *path,
                              murk_yaml *value, const char *where,
                              murk_yaml *const *own, size_t n_own,
                              murk_error *err)
{
    const option_context option = {.source = value->source,
                                   .where = where,
                                   .own = own,
                                   .n_own = n_own,
                                   .root = root,
                                   .err = err};
    return put(&option, root, path, strlen(path), value);
}

murk_status murk_override_apply(murk_yaml *root, const murk_override *override,
                                const char *source, murk_error *err)
{
    char where[256];
    const murk_yaml node = {.source = source};
    murk_yaml_place(&node, where, sizeof where);
    const option_context option = {
        .source = source, .where = where, .root = root, .err = err};
    const char *equals = strchr(override->text, '=');
    if (!equals) {
        return fail(&option, "must be KEY=VALUE, such as photons.emit=1e5");
    }
    if (root->kind != MURK_YAML_MAP) {
        return MURK_OK; /* the check of the whole tree reports the error */
    }
    murk_yaml *value = NULL;
    murk_status status =
        murk_yaml_parse(&value, equals + 1, strlen(equals + 1), source, err);
    if (status) {
        return status;
    }
    return put(&option, root, override->text, (size_t)(equals - override->text),
               value);
}
