/* Sets up the parameters of a fit: finds each key in the resolved scene of each
 * condition, takes start value and range, and determines the effect of the key
 * by comparing the optics and the world at two values. */
#include "calibrate/free_keys.h"

#include "base/log.h"
#include "calibrate/free_names.h"
#include "calibrate/key_effect.h"
#include "calibrate/key_place.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Relative change of a key that is used to find the effect of the key: small
 * enough to give a valid scene, large enough to exceed rounding. */
#define PROBE 1e-3

/* Relative steps of differences; see murk_free_key_around(). */
#define STEP       1e-5
#define STEP_TABLE 2e-2

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, MURK_FREE_PLACE, "for free keys");
}

/* ---- places ---- */

/* Finds key k in condition c; the first condition that has the key determines
 * start and range. */
static murk_status place_in(murk_free_keys *keys, size_t k, size_t c,
                            murk_yaml *root, bool *is_first, murk_error *err)
{
    murk_free_key *key = &keys->key[k];
    murk_key_place place;
    murk_key_range range;
    /* Find the key; read the range. */
    murk_status status = murk_key_place_find(&place, root, keys->bands,
                                             key->path, key->source, err);
    if (!status && *is_first) {
        status = murk_key_range_of(&range, &place, key->path, key->source, err);
    }
    if (status) {
        return status;
    }
    /* Record the place; an item of a list is set by setting the whole list. */
    key->is_in[c] = true;
    if (place.list) {
        key->list[c] = murk_yaml_copy(place.list);
        key->index = place.index;
        key->put[place.put] = '\0';
        if (!key->list[c]) {
            return no_memory(err);
        }
    }
    /* Start and range. */
    if (*is_first) {
        key->start = place.value;
        key->lower = range.lower;
        key->upper = range.upper;
        key->is_log = range.is_log;
        *is_first = false;
    }
    return MURK_OK;
}

/* Prints a note for each condition that lacks a key meant for all
 * conditions. */
static void note_absence(const murk_free_keys *keys, size_t k)
{
    for (size_t c = 0; c < keys->conditions; ++c) {
        const bool is_meant = keys->key[k].condition == SIZE_MAX;
        if (is_meant && !keys->key[k].is_in[c]) {
            murk_note(keys->key[k].source,
                      "%s has no such key: its readings have no say in it",
                      keys->condition_name[c][0] ? keys->condition_name[c]
                                                 : "the scene as it stands");
        }
    }
}

/* Parses the resolved scene of each condition. Nodes of the trees name the
 * option in messages, not a line of the scene. */
static murk_status read_trees(murk_yaml **root, const murk_free_keys *keys,
                              murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t c = 0; c < keys->conditions && !status; ++c) {
        murk_scene_desc *scene = NULL;
        status = murk_free_scene(&scene, keys, c, NULL, err);
        if (!status) {
            status =
                murk_yaml_parse(&root[c], scene->resolved,
                                strlen(scene->resolved), MURK_FREE_PLACE, err);
        }
        murk_scene_desc_destroy(scene);
    }
    return status;
}

/* Finds a key in all conditions that it is meant for; fails if none of these
 * conditions has the key. */
static murk_status place_key(murk_free_keys *keys, size_t k,
                             murk_yaml *const *root, murk_error *err)
{
    murk_error first = {0};
    bool is_first = true;
    for (size_t c = 0; c < keys->conditions; ++c) {
        const size_t own = keys->key[k].condition;
        murk_error failure = {0};
        if (own != SIZE_MAX && own != c) {
            continue;
        }
        const murk_status status =
            place_in(keys, k, c, root[c], &is_first, &failure);
        if (status == MURK_NO_MEMORY) {
            return no_memory(err);
        }
        first = status && !first.code ? failure : first;
    }
    if (is_first) { /* nowhere */
        return murk_fail(err, first.code, first.where, "%s", first.text);
    }
    note_absence(keys, k);
    return MURK_OK;
}

/* Finds all keys and factors. */
static murk_status place_all(murk_free_keys *keys, murk_error *err)
{
    murk_yaml **root = calloc(keys->conditions + 1, sizeof *root);
    murk_status status = root ? read_trees(root, keys, err) : no_memory(err);
    for (size_t k = 0; k < keys->n && !status; ++k) {
        status = keys->key[k].gain != SIZE_MAX
                     ? murk_free_place_gain(keys, k, err)
                     : place_key(keys, k, root, err);
    }
    for (size_t c = 0; root && c < keys->conditions; ++c) {
        murk_yaml_destroy(root[c]);
    }
    free(root);
    return status;
}

/* ---- effects ---- */

/* Compares the optics and the world of condition c at the start values with
 * those at another value of key k. Fails if re-weighting would have to create
 * extinction, scattering or power. */
static murk_status probe(murk_key_effect *effect, murk_free_keys *keys,
                         size_t k, size_t c, double *value,
                         const murk_optics *base, murk_error *err)
{
    murk_optics *moved = NULL;
    /* The optics at the other value. */
    double low, high;
    murk_free_key_beside(&keys->key[k], PROBE, value[k], &low, &high);
    const double start = value[k];
    value[k] = high > start ? high : low;
    murk_status status = murk_free_optics(&moved, keys, c, value, err);
    value[k] = start;
    if (status) {
        return status;
    }
    /* Compare; re-weighting cannot start from nothing. */
    status = murk_key_effect_add(effect, base, moved, err);
    char nothing[96];
    if (!status && !effect->world &&
        murk_key_effect_from_nothing(nothing, sizeof nothing, base, moved)) {
        status = murk_fail(err, MURK_BAD_VALUE, keys->key[k].source,
                           "%s has no extinction, scattering or power at the "
                           "start, and nothing cannot be re-weighted: must "
                           "start above 0, by another value of %s",
                           nothing, keys->key[k].path);
    }
    murk_optics_destroy(moved);
    return status;
}

/* Sets the kind of a key from the comparisons of all conditions. */
static murk_status set_kind(murk_free_keys *keys, size_t k,
                            const murk_key_effect *effect, murk_error *err)
{
    murk_free_key *key = &keys->key[k];
    if (!effect->world && !effect->optics && !effect->power) {
        return murk_fail(err, MURK_BAD_VALUE, key->source,
                         "changes nothing in the light of the scene, must be a "
                         "key that does");
    }
    key->kind = effect->world || (effect->optics && effect->power)
                    ? MURK_FREE_WORLD
                : effect->optics ? MURK_FREE_MEDIUM
                                 : MURK_FREE_LIGHT;
    key->turns_phase = key->kind == MURK_FREE_MEDIUM && effect->phase;
    keys->key[k].step = effect->tables ? STEP_TABLE : STEP;
    return MURK_OK;
}

/* Stores the channel powers if no key of `lights` or `site` is free, so that
 * they stay the same: computing them (ephemeris, sky) takes longer than all
 * other optics. */
static murk_status keep_power(murk_free_keys *keys, size_t c,
                              const murk_optics *base, murk_error *err)
{
    bool is_free = false;
    for (size_t k = 0; k < keys->n; ++k) {
        const char *path = keys->key[k].path;
        is_free = is_free || strncmp(path, "lights.", 7) == 0 ||
                  strncmp(path, "site.", 5) == 0;
    }
    if (is_free) {
        return MURK_OK;
    }
    keys->power_w[c] =
        murk_arena_array(&keys->arena, base->channels, sizeof(double));
    if (!keys->power_w[c]) {
        return no_memory(err);
    }
    memcpy(keys->power_w[c], base->power_w, base->channels * sizeof(double));
    return MURK_OK;
}

/* Determines the kind of every key. */
static murk_status find_kinds(murk_free_keys *keys, murk_error *err)
{
    double *value = calloc(keys->n + 1, sizeof *value);
    murk_key_effect *effect = calloc(keys->n + 1, sizeof *effect);
    keys->power_w =
        murk_arena_array(&keys->arena, keys->conditions, sizeof *keys->power_w);
    murk_status status =
        value && effect && keys->power_w ? MURK_OK : no_memory(err);
    /* Start values. */
    for (size_t k = 0; k < keys->n && !status; ++k) {
        value[k] = keys->key[k].start;
    }
    /* Compare in each condition that has the key. */
    for (size_t c = 0; c < keys->conditions && !status; ++c) {
        murk_optics *base = NULL;
        status = murk_free_optics(&base, keys, c, value, err);
        status = status ? status : keep_power(keys, c, base, err);
        for (size_t k = 0; k < keys->n && !status; ++k) {
            if (keys->key[k].is_in[c] && keys->key[k].gain == SIZE_MAX) {
                status = probe(&effect[k], keys, k, c, value, base, err);
            }
        }
        murk_optics_destroy(base);
    }
    /* Set the kinds. */
    for (size_t k = 0; k < keys->n && !status; ++k) {
        if (keys->key[k].gain == SIZE_MAX) {
            status = set_kind(keys, k, &effect[k], err);
        }
    }
    free(value);
    free(effect);
    return status;
}

/* ---- all ---- */

/* Fails if there are no keys that are needed, or more keys than rows. */
static murk_status check_count(const murk_free_keys *keys, murk_error *err)
{
    const murk_readings *m = keys->desc.measured;
    if (keys->n == 0 && keys->desc.may_be_none) {
        return MURK_OK;
    }
    if (keys->n == 0) {
        return murk_fail(err, MURK_BAD_VALUE, MURK_FREE_PLACE,
                         "no keys, must be one or more");
    }
    return keys->n <= m->rows - m->held_out
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, m->path,
                           "%zu rows to be fitted (%zu held out) for %zu "
                           "parameters, must be as many or more",
                           m->rows - m->held_out, m->held_out, keys->n);
}

murk_status murk_free_keys_create(murk_free_keys **out,
                                  const murk_free_desc *desc, murk_error *err)
{
    murk_free_keys *keys = calloc(1, sizeof *keys);
    if (!keys) {
        return no_memory(err);
    }
    keys->desc = *desc;
    murk_status status = murk_free_find_conditions(keys, err);
    if (status || (status = murk_free_add_all(keys, err)) ||
        (status = place_all(keys, err)) ||
        (status = murk_free_check_gains(keys, err)) ||
        (status = murk_free_apply_bounds(keys, err)) ||
        (status = check_count(keys, err)) || (status = find_kinds(keys, err))) {
        murk_free_keys_destroy(keys);
        return status;
    }
    *out = keys;
    return MURK_OK;
}
