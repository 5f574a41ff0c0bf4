/* Follows a dotted path through the parsed scene and, in parallel, through the
 * key tables (scene/keys.h), so that the row of the key is known at the end.
 * Errors name the part of the path that fails, with a suggestion. */
#include "calibrate/key_place.h"

#include "base/number.h"
#include "preset/check_words.h"
#include "scene/presets.h"
#include "scene/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Names that a suggestion may choose from: more than any map of a scene has. */
#define NAMES_MAX 400

/* A position in the scene. row belongs to the node. in_item: the node is an
 * item of the list of the row, or one of the names of the row, so the keys of
 * the node are those of the row. */
typedef struct spot {
    const murk_yaml *node;
    const murk_key *row;
    bool in_item;
} spot;

/* The state of the search, for messages. */
typedef struct incumbent {
    const char *path, *at; /* the next part of the path */
    const char *where;
    murk_error *err;
} incumbent;

static murk_status fail(const incumbent *f, const char *text)
{
    return murk_fail(f->err, MURK_BAD_VALUE, f->where, "%s", text);
}

/* The path so far, for messages. */
static void shown_so_far(const incumbent *f, char *out, size_t size)
{
    char part[200];
    size_t n = (size_t)(f->at - f->path);
    n = n > 0 ? n - 1 : 0;
    snprintf(part, sizeof part, "%.*s", (int)n, f->path);
    murk_words_show(out, size, n ? part : "the scene");
}

/* True if the keys of the node are listed in the key tables. */
static bool is_map_row(const spot *at)
{
    return !at->row || at->in_item || at->row->kind == MURK_KEY_MAP ||
           at->row->kind == MURK_KEY_PER_BAND ||
           at->row->kind == MURK_KEY_SPECTRUM;
}

static const murk_keys *keys_of(const spot *at)
{
    return at->row ? at->row->keys : &murk_scene_keys;
}

static bool is_medium(const spot *at)
{
    return at->in_item && at->row && strcmp(at->row->name, "media") == 0;
}

/* Fails if a word of presets is not used by the preset of the medium, with the
 * words that are; also if the medium has no preset. MURK_OK for other keys. */
static murk_status check_preset(const incumbent *f, const spot *at,
                                const char *part)
{
    const int word = is_medium(at) ? murk_word_find(part) : -1;
    const murk_yaml *name = word < 0 ? NULL : murk_yaml_get(at->node, "preset");
    murk_preset *preset = NULL;
    /* A word of presets needs a preset. */
    if (word >= 0 && !name) {
        return fail(f, "changes nothing, so it cannot be free: a word of "
                       "presets, and the medium has none");
    }
    if (!name || name->kind != MURK_YAML_SCALAR ||
        murk_presets_read(&preset, name->text, f->where, NULL)) {
        return MURK_OK;
    }
    murk_status status = MURK_OK;
    /* Ask the preset. */
    if (!murk_preset_word_of(preset, (murk_word_id)word).is_known) {
        const double none[MURK_WORD_NUMBERS_MAX] = {0};
        murk_error told = {0};
        char text[400];
        (void)murk_preset_check_word(preset, (murk_word_id)word, none, "",
                                     &told);
        snprintf(text, sizeof text,
                 "changes nothing, so it cannot be free: %.330s", told.text);
        status = fail(f, text);
    }
    murk_preset_destroy(preset);
    return status;
}

/* The error message for an unknown part of a path. */
static murk_status unknown(const incumbent *f, const spot *at, const char *part)
{
    const char *names[NAMES_MAX];
    char owner[120], shown[64], text[400];
    size_t n = 0;
    const murk_keys *keys = is_map_row(at) ? keys_of(at) : NULL;
    const murk_status status = check_preset(f, at, part);
    if (status) {
        return status;
    }
    /* A key that exists but has no value in the scene. */
    shown_so_far(f, owner, sizeof owner);
    murk_words_show(shown, sizeof shown, part);
    if (keys && murk_keys_find(keys, part)) {
        snprintf(text, sizeof text,
                 "%s has no %s to start from, must be in the scene, or given "
                 "by --set",
                 owner, shown);
        return fail(f, text);
    }
    /* A suggestion from the names of the map and of the key table. */
    for (size_t i = 0; i < at->node->n && n < NAMES_MAX; ++i) {
        names[n++] = at->node->key[i];
    }
    for (const murk_key *k = keys ? keys->key : NULL;
         k && k->name && n < NAMES_MAX; ++k) {
        names[n++] = k->name;
    }
    const char *meant = murk_words_meant(part, names, n);
    snprintf(text, sizeof text, "no %s in %s%s%.60s%s", shown, owner,
             meant ? ", did you mean " : "", meant ? meant : "",
             meant ? "?" : "");
    return fail(f, text);
}

/* Length of the next part; a name that contains dots is taken as a whole. */
static size_t part_length(const spot *at, const char *path)
{
    size_t length = strcspn(path, ".");
    const murk_yaml *map = at->node;
    for (size_t i = 0; map->kind == MURK_YAML_MAP && i < map->n; ++i) {
        const size_t n = strlen(map->key[i]);
        if (n > length && strncmp(path, map->key[i], n) == 0 &&
            (path[n] == '.' || path[n] == '\0')) {
            length = n;
        }
    }
    return length;
}

/* Steps into a map. */
static murk_status step_map(const incumbent *f, spot *at, const char *part)
{
    const murk_yaml *child = murk_yaml_get(at->node, part);
    if (!child) {
        return unknown(f, at, part);
    }
    at->node = child;
    if (is_map_row(at)) {
        const murk_keys *keys = keys_of(at);
        at->row = keys ? murk_keys_find(keys, part) : NULL;
        at->in_item = false;
    } else {
        at->in_item = true; /* one of its names */
    }
    return MURK_OK;
}

/* Steps into a list. */
static murk_status step_list(const incumbent *f, spot *at, const char *part)
{
    uint64_t index;
    char owner[120], shown[64], text[300];
    if (!murk_count_parse(part, &index) || index >= at->node->n) {
        shown_so_far(f, owner, sizeof owner);
        murk_words_show(shown, sizeof shown, part);
        snprintf(text, sizeof text,
                 "item %s of %s, a list of %zu, must be 0..%zu", shown, owner,
                 at->node->n, at->node->n ? at->node->n - 1 : 0);
        return fail(f, text);
    }
    at->node = at->node->child[index];
    at->in_item = true;
    return MURK_OK;
}

/* Steps into a child of the present node. */
static murk_status step(const incumbent *f, spot *at, const char *part)
{
    char owner[120], text[300];
    if (at->node->kind == MURK_YAML_MAP) {
        return step_map(f, at, part);
    }
    if (at->node->kind == MURK_YAML_LIST) {
        return step_list(f, at, part);
    }
    shown_so_far(f, owner, sizeof owner);
    snprintf(text, sizeof text, "%s is %.40s, one value%s", owner,
             at->node->text,
             at->row && at->row->kind == MURK_KEY_SPECTRUM
                 ? " for all bands: must be free as it is, or by one of them"
                 : "");
    return fail(f, text);
}

/* Fails unless the value is a single number that may vary continuously. */
static murk_status check_end(murk_key_place *out, const incumbent *f,
                             const spot *at)
{
    char text[300], shown[64];
    /* The value must be a scalar and a number. */
    if (at->node->kind != MURK_YAML_SCALAR) {
        const bool is_list = at->node->kind == MURK_YAML_LIST;
        if (is_list && at->node->n > 0 &&
            at->node->child[0]->kind == MURK_YAML_SCALAR) {
            snprintf(text, sizeof text,
                     "a list of %zu, must be one number: %.100s.0 is its first",
                     at->node->n, f->path);
        } else {
            snprintf(text, sizeof text, "%s, must be one number",
                     is_list ? "a list" : "a map");
        }
        return fail(f, text);
    }
    if (!murk_yaml_number(at->node, &out->value)) {
        murk_words_show(shown, sizeof shown, at->node->text);
        snprintf(text, sizeof text, "%s, must be a number", shown);
        return fail(f, text);
    }
    /* Choices and counts do not vary continuously. */
    const bool is_number =
        at->row &&
        (at->row->kind == MURK_KEY_NUMBER || at->row->kind == MURK_KEY_VECTOR ||
         at->row->kind == MURK_KEY_NUMBERS ||
         at->row->kind == MURK_KEY_NUMBER_LIST ||
         at->row->kind == MURK_KEY_SPECTRUM_LIST ||
         at->row->kind == MURK_KEY_SPECTRUM ||
         at->row->kind == MURK_KEY_SHARED);
    return is_number ? MURK_OK
                     : fail(f, "a choice or a count, must be a number that may "
                               "be any");
}

/* Records the list that the path goes through. */
static void note_list(murk_key_place *out, const spot *before, const spot *at,
                      const incumbent *f)
{
    const murk_yaml *list = before->node;
    if (list->kind != MURK_YAML_LIST || at->node->kind != MURK_YAML_SCALAR) {
        return;
    }
    out->list = list;
    while (list->child[out->index] != at->node) {
        ++out->index;
    }
    out->put = (size_t)(f->at - f->path) - 1;
    if (at->row && at->row->kind == MURK_KEY_NUMBERS) {
        out->item = &at->row->items[out->index];
    }
}

murk_status murk_key_place_find(murk_key_place *out, const murk_yaml *root,
                                const char *path, const char *where,
                                murk_error *err)
{
    incumbent f = {path, path, where, err};
    spot at = {root, NULL, false};
    murk_key_place place = {.put = strlen(path)};
    char *part = malloc(strlen(path) + 1);
    murk_status status =
        part ? MURK_OK : murk_fail(err, MURK_NO_MEMORY, where, "no memory");
    /* Follow the path part by part. */
    while (!status) {
        const size_t length = part_length(&at, f.at);
        const spot before = at;
        memcpy(part, f.at, length);
        part[length] = '\0';
        status = length ? step(&f, &at, part)
                        : fail(&f, "an empty part of a key, must be such as "
                                   "media.fog.visibility_m");
        if (status) {
            break;
        }
        note_list(&place, &before, &at, &f);
        place.medium = is_medium(&at) ? at.node : place.medium;
        if (f.at[length] == '\0') {
            break;
        }
        f.at += length + 1;
    }
    free(part);
    /* Check the end. */
    if (!status) {
        place.row = at.row;
        place.node = at.node;
        status = check_end(&place, &f, &at);
    }
    if (!status) {
        *out = place;
    }
    return status;
}

bool murk_key_place_spread(murk_yaml *root, const char *path, int bands)
{
    const char *last = strrchr(path, '.');
    uint64_t index;
    murk_key_place place;
    /* The path must be an item of a value for all bands. */
    char *of = last ? strndup(path, (size_t)(last - path)) : NULL;
    const bool is_it =
        of && murk_count_parse(last + 1, &index) && index < (uint64_t)bands &&
        murk_key_place_find(&place, root, of, "", NULL) == MURK_OK &&
        !place.list && place.row->kind == MURK_KEY_SPECTRUM;
    free(of);
    if (!is_it) {
        return false;
    }
    murk_yaml *node = (murk_yaml *)place.node; /* a node of root, which is not
                                                * const */
    /* Replace the value by a list of copies. */
    murk_yaml *one = murk_yaml_copy(node);
    bool is_whole = one != NULL;
    if (is_whole) {
        murk_yaml_clear(node);
        node->kind = MURK_YAML_LIST;
    }
    for (int b = 0; is_whole && b < bands; ++b) {
        murk_yaml *copy = murk_yaml_copy(one);
        is_whole = copy && murk_yaml_append(node, NULL, copy);
    }
    murk_yaml_destroy(one);
    return is_whole;
}
