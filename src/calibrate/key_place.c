/* Follows a dotted path through the parsed scene and, in parallel, through the
 * key tables (scene/keys.h), so that the row of the key is known at the end.
 * Messages name the part of the path that fails, and suggest a name for an
 * unknown one. */
#include "calibrate/key_place.h"

#include "base/number.h"
#include "base/words.h"
#include "preset/check_words.h"
#include "scene/key_path.h"
#include "scene/presets.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Names that a suggestion may choose from: more than any map of a scene has. */
#define NAMES_MAX 400

/* The state of the search, for messages. */
typedef struct walk {
    const char *path, *at; /* the next part of the path */
    size_t bands;
    const char *where;
    murk_error *err;
} walk;

__attribute__((format(printf, 2, 3))) static murk_status
fail(const walk *f, const char *format, ...)
{
    char text[sizeof f->err->text];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return murk_fail(f->err, MURK_BAD_VALUE, f->where, "%s", text);
}

/* The path so far, for messages. */
static void shown_so_far(const walk *f, char *out, size_t size)
{
    char part[200];
    size_t n = (size_t)(f->at - f->path);
    n = n > 0 ? n - 1 : 0;
    snprintf(part, sizeof part, "%.*s", (int)n, f->path);
    murk_words_show(out, size, n ? part : "the scene");
}

static bool is_medium(const murk_key_position *at)
{
    return at->in_item && at->row && strcmp(at->row->name, "media") == 0;
}

/* Fails if a word of presets is not used by the preset of the medium, with the
 * words that are; also if the medium has no preset. MURK_OK for other keys. */
static murk_status check_preset(const walk *f, const murk_key_position *at,
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
        murk_error why = {0};
        (void)murk_preset_check_word(preset, (murk_word_id)word, none, "",
                                     &why);
        status =
            fail(f, "changes nothing, so it cannot be free: %.330s", why.text);
    }
    murk_preset_destroy(preset);
    return status;
}

/* The error message for an unknown part of a path. */
static murk_status unknown(const walk *f, const murk_key_position *at,
                           const char *part)
{
    const char *names[NAMES_MAX];
    char owner[120], shown[64];
    size_t n = 0;
    const murk_keys *keys = murk_key_path_is_map(at) ? at->row->keys : NULL;
    const murk_status status = check_preset(f, at, part);
    if (status) {
        return status;
    }
    /* A key that exists but has no value in the scene. */
    shown_so_far(f, owner, sizeof owner);
    murk_words_show(shown, sizeof shown, part);
    if (keys && murk_keys_find(keys, part)) {
        return fail(f, "%s has no %s to start from, must be given in the scene",
                    owner, shown);
    }
    /* A suggestion from the names of the map and of the key table. */
    for (size_t i = 0; i < at->node->n && n < NAMES_MAX; ++i) {
        names[n++] = at->node->key[i];
    }
    for (const murk_key *k = keys ? keys->key : NULL;
         k && k->name && n < NAMES_MAX; ++k) {
        names[n++] = k->name;
    }
    return fail(f, "no %s in %s%s", shown, owner,
                murk_words_suggest(part, names, n).text);
}

/* Steps into a child of the present node. */
static murk_status step(const walk *f, murk_key_position *at, const char *part)
{
    uint64_t index = UINT64_MAX;
    char owner[120], shown[64];
    murk_yaml *child = NULL;
    const bool is_index = murk_count_parse(part, &index);
    if (is_index && index < f->bands) {
        (void)murk_key_path_spread(at, f->bands);
    }
    shown_so_far(f, owner, sizeof owner);
    /* Find the child. */
    if (at->node->kind == MURK_YAML_MAP) {
        child = murk_yaml_get(at->node, part);
        if (!child) {
            return unknown(f, at, part);
        }
    } else if (at->node->kind == MURK_YAML_LIST) {
        if (!is_index || index >= at->node->n) {
            murk_words_show(shown, sizeof shown, part);
            return fail(f, "item %s of %s, a list of %zu, must be 0..%zu",
                        shown, owner, at->node->n,
                        at->node->n ? at->node->n - 1 : 0);
        }
        child = at->node->child[index];
    } else {
        return fail(f, "%s is %.40s, one value%s", owner, at->node->text,
                    at->row && at->row->kind == MURK_KEY_SPECTRUM
                        ? " for all bands: must be free as it is, or by one "
                          "of them"
                        : "");
    }
    *at = murk_key_path_member(at, part, child);
    return MURK_OK;
}

/* Fails unless the value is a single number that may vary continuously. */
static murk_status check_end(murk_key_place *out, const walk *f,
                             const murk_key_position *at)
{
    char shown[64];
    /* The value must be a scalar and a number. */
    if (at->node->kind != MURK_YAML_SCALAR) {
        const bool is_list = at->node->kind == MURK_YAML_LIST;
        if (is_list && at->node->n > 0 &&
            at->node->child[0]->kind == MURK_YAML_SCALAR) {
            return fail(f,
                        "a list of %zu, must be one number: %.100s.0 is its "
                        "first",
                        at->node->n, f->path);
        }
        return fail(f, "%s, must be one number", is_list ? "a list" : "a map");
    }
    if (!murk_yaml_number(at->node, &out->value)) {
        murk_words_show(shown, sizeof shown, at->node->text);
        return fail(f, "%s, must be a number", shown);
    }
    /* Choices and counts do not vary continuously, and what a number selects
     * among files is read once, before the search. */
    const bool is_number =
        at->row && !at->row->selects_files && murk_key_is_continuous(at->row);
    return is_number ? MURK_OK
                     : fail(f, "a choice or a count, must be a number that may "
                               "be any");
}

/* Records the list that contains the value, if the last step went from a list
 * to a single value. */
static void note_list(murk_key_place *out, const murk_key_position *before,
                      const murk_key_position *at, const walk *f)
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

murk_status murk_key_place_find(murk_key_place *out, murk_yaml *root, int bands,
                                const char *path, const char *where,
                                murk_error *err)
{
    walk f = {path, path, (size_t)bands, where, err};
    murk_key_position at = murk_key_path_root(root);
    murk_key_place place = {.put = strlen(path)};
    char *part = malloc(strlen(path) + 1);
    murk_status status =
        part ? MURK_OK : murk_fail(err, MURK_NO_MEMORY, where, "no memory");
    /* Follow the path part by part. */
    while (!status) {
        const size_t length = murk_key_path_part(&at, f.at);
        const murk_key_position before = at;
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

/* ---- ranges ---- */

/* Limits of the key table from this size on only catch typing errors. */
#define SLIP_OF_THE_PEN 1e9
#define OFF_THE_END     1e-3 /* distance from a limit that may not be reached */

/* A key is a scale, of which relative changes matter, if its range starts at 0
 * or above and reaches at least to this value. Albedo, index of refraction,
 * temperature and wind are not scales. */
#define SCALE_FROM 1000

static void from_row(murk_key_range *out, const murk_key *row)
{
    const bool is_any = row->min == 0 && row->max == 0;
    out->lower = is_any || row->min <= -SLIP_OF_THE_PEN ? -INFINITY : row->min;
    out->upper = is_any || row->max >= SLIP_OF_THE_PEN ? INFINITY : row->max;
    out->is_log = !is_any && row->min >= 0 && row->max >= SCALE_FROM;
    if (row->above && !out->is_log) {
        out->lower += OFF_THE_END;
    }
    if (row->below) {
        out->upper -= OFF_THE_END;
    }
}

/* Narrows the range of a word of presets to the range that the preset of the
 * medium states for the word. */
static murk_status from_preset(murk_key_range *out, const murk_key_place *place,
                               const char *name, const char *where,
                               murk_error *err)
{
    /* Only words of a medium with a preset. */
    const int word = murk_word_find(name);
    const murk_yaml *preset =
        place->medium ? murk_yaml_get(place->medium, "preset") : NULL;
    murk_preset *read = NULL;
    if (word < 0 || !preset || preset->kind != MURK_YAML_SCALAR) {
        return MURK_OK;
    }
    /* Read the preset. */
    const murk_status status =
        murk_presets_read(&read, preset->text, where, err);
    if (status) {
        return status;
    }
    const murk_preset_word range =
        murk_preset_word_of(read, (murk_word_id)word);
    const size_t k = place->list ? place->index : 0;
    if (range.is_known && k < MURK_WORD_NUMBERS_MAX) {
        out->lower = fmax(out->lower, range.min[k]);
        out->upper = fmin(out->upper, range.max[k]);
    }
    murk_preset_destroy(read);
    return MURK_OK;
}

/* The last part of the path, without the index in a list, is the name of the
 * key. */
murk_status murk_key_range_of(murk_key_range *out, const murk_key_place *place,
                              const char *path, const char *where,
                              murk_error *err)
{
    char name[64] = "";
    size_t end = place->put, start = end;
    while (start > 0 && path[start - 1] != '.') {
        --start;
    }
    if (end - start < sizeof name) {
        memcpy(name, path + start, end - start);
    }
    from_row(out, place->item ? place->item : place->row);
    out->is_log = out->is_log && place->value > 0;
    return from_preset(out, place, name, where, err);
}
