/* Parses the names of free parameters: keys of the scene, keys with a value for
 * each condition ("@each"), and factors of readings ("gain.NAME"); and bounds
 * "KEY=LOW:HIGH", which apply to all parameters of that key, or to one of them
 * ("KEY@CONDITION"). Also finds the conditions that the data use. */
#include "calibrate/free_names.h"

#include "base/log.h"
#include "base/number.h"
#include "base/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define EACH "@each"
#define GAIN "gain."

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, MURK_FREE_PLACE, "for free keys");
}

static murk_status fail(const murk_free_keys *keys, size_t k, murk_error *err,
                        const char *text)
{
    return murk_fail(err, MURK_BAD_VALUE, keys->key[k].source, "%s", text);
}

/* ---- conditions ---- */

/* Finds the conditions that readings use, the number of bands, and the checksum
 * of the scene file. */
murk_status murk_free_find_conditions(murk_free_keys *keys, murk_error *err)
{
    const murk_free_desc *desc = &keys->desc;
    const murk_readings *m = desc->measured;
    murk_scene_desc *scene = NULL;
    bool is_used[MURK_SCENE_CONDITIONS_MAX + 1] = {false}; /* [0]: none */
    /* Read the scene without warnings. */
    const bool was_silent = murk_warn_quiet(true);
    const murk_status status = murk_scene_desc_read(
        &scene, desc->scene_path, desc->overrides, desc->n_overrides, err);
    murk_warn_quiet(was_silent);
    if (status) {
        return status;
    }
    keys->bands = scene->bands;
    /* Mark the conditions of the readings. */
    for (size_t i = 0; i < m->readings; ++i) {
        const size_t c = m->reading[i].condition;
        is_used[c < scene->n_conditions ? c + 1 : 0] = true;
    }
    /* List them; the scene without a condition comes first. */
    const size_t n = scene->n_conditions + 1;
    keys->condition =
        murk_arena_array(&keys->arena, n, sizeof *keys->condition);
    keys->condition_name =
        murk_arena_array(&keys->arena, n, sizeof *keys->condition_name);
    const bool is_whole = !keys->arena.is_short;
    for (size_t i = 0; is_whole && i < n; ++i) {
        if (is_used[i]) {
            const size_t c = keys->conditions++;
            keys->condition[c] = i - 1; /* SIZE_MAX of none */
            if (i > 0) {
                memcpy(keys->condition_name[c], scene->conditions[i - 1].name,
                       sizeof keys->condition_name[c]);
            }
        }
    }
    memcpy(keys->sha256, scene->sha256, sizeof keys->sha256);
    murk_scene_desc_destroy(scene);
    return is_whole ? MURK_OK : no_memory(err);
}

/* ---- names ---- */

static const char *condition_text(const murk_free_keys *keys, size_t c)
{
    return keys->condition_name[c][0] ? keys->condition_name[c] : "scene";
}

/* Adds a parameter; fails if the factor, or the key in the same condition, is
 * free already, or if there are MURK_FREE_MAX parameters. */
static murk_status add(murk_free_keys *keys, const char *name, const char *path,
                       size_t condition, size_t gain, murk_error *err)
{
    /* The same key may not be free twice in a condition. */
    for (size_t k = 0; k < keys->n; ++k) {
        const murk_free_key *other = &keys->key[k];
        if (other->gain == gain && strcmp(other->path, path) == 0 &&
            (other->condition == condition || other->condition == SIZE_MAX ||
             condition == SIZE_MAX)) {
            return fail(keys, k, err, "asked for twice");
        }
    }
    /* Append. */
    if (keys->n == MURK_FREE_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, MURK_FREE_PLACE,
                         "more than %d parameters, the most there may be",
                         MURK_FREE_MAX);
    }
    const size_t size = sizeof MURK_FREE_PLACE " " + strlen(name);
    murk_arena *arena = &keys->arena;
    murk_free_key *key = &keys->key[keys->n];
    *key = (murk_free_key){
        .condition = condition,
        .gain = gain,
        .source = murk_arena_array(arena, size, 1),
        .put = murk_arena_array(arena, strlen(path) + 1, 1),
        .is_in = murk_arena_array(arena, keys->conditions, sizeof(bool)),
        .list = murk_arena_array(arena, keys->conditions, sizeof *key->list)};
    if (arena->is_short) {
        return no_memory(err);
    }
    ++keys->n;
    snprintf(key->name, sizeof key->name, "%s", name);
    snprintf(key->path, sizeof key->path, "%s", path);
    snprintf(key->source, size, MURK_FREE_PLACE " %s", name);
    memcpy(key->put, path, strlen(path));
    return MURK_OK;
}

/* Adds a factor of readings; fails, with a suggestion, if no reading has this
 * factor. */
static murk_status add_gain(murk_free_keys *keys, const char *asked,
                            murk_error *err)
{
    const murk_readings *m = keys->desc.measured;
    const char *name = asked + strlen(GAIN), *known[MURK_READING_GAINS_MAX];
    char where[120], shown[64];
    for (size_t g = 0; g < m->gains; ++g) {
        if (strcmp(m->gain[g], name) == 0) {
            return add(keys, asked, "", SIZE_MAX, g, err);
        }
        known[g] = m->gain[g];
    }
    murk_words_show(shown, sizeof shown, name);
    snprintf(where, sizeof where, MURK_FREE_PLACE " " GAIN "%s", shown);
    return murk_fail(err, MURK_BAD_VALUE, where,
                     "no reading of %.200s names this factor%s", m->path,
                     murk_words_suggest(name, known, m->gains).text);
}

/* Fails unless the key belongs to a part of the scene that a fit may change. */
static murk_status check_part(const char *path, const char *where,
                              murk_error *err)
{
    static const char *const parts[] = {"media", "regions", "lights", "site"};
    char first[40] = "", shown[64];
    const size_t length = strcspn(path, ".");
    for (size_t i = 0; i < 4; ++i) {
        if (length == strlen(parts[i]) &&
            strncmp(path, parts[i], length) == 0) {
            return MURK_OK;
        }
    }
    snprintf(first, sizeof first, "%.*s", (int)(length < 39 ? length : 39),
             path);
    const char *meant = murk_words_meant(first, parts, 4);
    murk_words_show(shown, sizeof shown, first);
    return meant
               ? murk_fail(err, MURK_BAD_VALUE, where,
                           "no %s in the scene, did you mean %s?", shown, meant)
               : murk_fail(err, MURK_BAD_VALUE, where,
                           "a key of %s, must be of media, regions, lights "
                           "or site",
                           shown[0] ? shown : "nothing");
}

/* Adds a parameter for a key, or, if the name ends in "@each", one parameter
 * for each condition that the readings use. */
static murk_status add_key(murk_free_keys *keys, const char *asked,
                           murk_error *err)
{
    char path[sizeof keys->key->path], name[sizeof keys->key->name];
    char where[200], shown[160];
    /* Split the name at "@". */
    const char *at = strrchr(asked, '@');
    const size_t length = at ? (size_t)(at - asked) : strlen(asked);
    murk_words_show(shown, sizeof shown, asked);
    snprintf(where, sizeof where, MURK_FREE_PLACE " %s", shown);
    if (length >= sizeof path) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a key of %zu bytes, must be at most %zu", length,
                         sizeof path - 1);
    }
    if (at && strcmp(at, EACH) != 0) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%.40s behind the key, must be " EACH
                         " (one value for each condition) or nothing",
                         at);
    }
    /* Check and add. */
    memcpy(path, asked, length);
    path[length] = '\0';
    murk_status status = check_part(path, where, err);
    if (!at && !status) {
        status = add(keys, path, path, SIZE_MAX, SIZE_MAX, err);
    }
    for (size_t c = 0; at && c < keys->conditions && !status; ++c) {
        snprintf(name, sizeof name, "%s@%s", path, condition_text(keys, c));
        status = add(keys, name, path, c, SIZE_MAX, err);
    }
    return status;
}

murk_status murk_free_add_all(murk_free_keys *keys, murk_error *err)
{
    const murk_free_desc *desc = &keys->desc;
    murk_status status = MURK_OK;
    keys->key =
        murk_arena_array(&keys->arena, MURK_FREE_MAX, sizeof *keys->key);
    if (!keys->key) {
        return no_memory(err);
    }
    for (size_t i = 0; i < desc->n_asked && !status; ++i) {
        const bool is_gain = strncmp(desc->asked[i], GAIN, strlen(GAIN)) == 0;
        status = is_gain ? add_gain(keys, desc->asked[i], err)
                         : add_key(keys, desc->asked[i], err);
    }
    return status;
}

/* ---- gains ---- */

/* The first reading that is fitted and has the factor of number `gain`; NULL if
 * there is none. */
static const murk_reading *fitted(const murk_readings *m, size_t gain)
{
    for (size_t i = 0; i < m->readings; ++i) {
        if (m->reading[i].gain == gain && !m->reading[i].is_held_out) {
            return &m->reading[i];
        }
    }
    return NULL;
}

murk_status murk_free_place_gain(murk_free_keys *keys, size_t k,
                                 murk_error *err)
{
    const murk_readings *m = keys->desc.measured;
    murk_free_key *key = &keys->key[k];
    key->kind = MURK_FREE_GAIN;
    key->start = 1;
    key->lower = 0;
    key->upper = INFINITY;
    /* Conditions in which a reading uses the factor. */
    for (size_t c = 0; c < keys->conditions; ++c) {
        for (size_t i = 0; i < m->readings; ++i) {
            key->is_in[c] |= m->reading[i].gain == key->gain &&
                             m->reading[i].condition == keys->condition[c];
        }
    }
    return fitted(m, key->gain)
               ? MURK_OK
               : fail(keys, k, err,
                      "all readings of this factor are held out, must be one "
                      "or more to be fitted");
}

/* The first reading of light with the factor of number `gain` that states no
 * absolute value (in percent or relative units); NULL if there is none. All
 * readings of a factor have one unit, but not necessarily one kind. */
static const murk_reading *relative_light(const murk_readings *m, size_t gain)
{
    for (size_t i = 0; i < m->readings; ++i) {
        const murk_reading *r = &m->reading[i];
        if (r->gain == gain && murk_reading_unit_needs_gain(r->unit, r->kind)) {
            return r;
        }
    }
    return NULL;
}

/* Fails if a factor of relative_light() is not free. */
murk_status murk_free_check_gains(const murk_free_keys *keys, murk_error *err)
{
    const murk_readings *m = keys->desc.measured;
    for (size_t g = 0; g < m->gains; ++g) {
        const murk_reading *reading = relative_light(m, g);
        bool is_free = false;
        for (size_t k = 0; k < keys->n; ++k) {
            is_free = is_free || keys->key[k].gain == g;
        }
        if (!is_free && reading) {
            char where[320];
            snprintf(where, sizeof where, "%.250s:%zu: gain", m->path,
                     reading->line);
            return murk_fail(
                err, MURK_BAD_VALUE, where,
                "light in %s by factor %s, which is not free: " GAIN
                "%s must be a free key",
                murk_reading_unit_name(reading->unit), m->gain[g], m->gain[g]);
        }
    }
    return MURK_OK;
}

/* ---- bounds ---- */

typedef struct bound {
    char key[240], low_text[40], high_text[40];
    char where[320]; /* "bounds KEY=LOW:HIGH" */
    double low, high;
} bound;

/* Parses one end; an empty text means `none`. */
static bool read_end(const char *text, double none, double *out)
{
    *out = none;
    return text[0] == '\0' || murk_number_parse(text, out);
}

/* Parses one bound. */
static murk_status read_bound(bound *out, const char *text, murk_error *err)
{
    char shown[200];
    const char *equals = strrchr(text, '=');
    const char *colon = equals ? strchr(equals, ':') : NULL;
    murk_words_show(shown, sizeof shown, text);
    snprintf(out->where, sizeof out->where, "bounds %s", shown);
    /* Split at "=" and ":". */
    const bool fits = colon && (size_t)(equals - text) < sizeof out->key &&
                      (size_t)(colon - equals) < sizeof out->low_text &&
                      strlen(colon + 1) < sizeof out->high_text;
    if (fits) {
        memcpy(out->key, text, (size_t)(equals - text));
        out->key[equals - text] = '\0';
        memcpy(out->low_text, equals + 1, (size_t)(colon - equals - 1));
        out->low_text[colon - equals - 1] = '\0';
        snprintf(out->high_text, sizeof out->high_text, "%s", colon + 1);
    }
    /* Both ends must be numbers or empty, in order. */
    if (!fits || !read_end(out->low_text, -INFINITY, &out->low) ||
        !read_end(out->high_text, INFINITY, &out->high)) {
        return murk_fail(err, MURK_BAD_VALUE, out->where,
                         "must be KEY=LOW:HIGH, such as "
                         "media.fog.visibility_m=20:500; either end may be "
                         "empty");
    }
    return out->low < out->high
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, out->where,
                           "%.9g to %.9g, the first must be less than the "
                           "second",
                           out->low, out->high);
}

/* True if the name of a bound means this parameter: its own name (such as
 * "KEY@dawn"), or the path of its key, alone ("KEY") or as "KEY@each"; the path
 * means the parameters of all conditions. */
static bool is_meant(const murk_free_key *key, const char *name)
{
    const size_t length = strlen(key->path);
    return strcmp(name, key->name) == 0 ||
           (length > 0 && strncmp(name, key->path, length) == 0 &&
            (name[length] == '\0' || strcmp(name + length, "@each") == 0));
}

/* Narrows the range of a key. The bound must lie in the range that the earlier
 * bounds have left. */
static murk_status narrow(murk_free_key *key, const bound *b, murk_error *err)
{
    if ((b->low > -INFINITY && b->low < key->lower) ||
        (b->high < INFINITY && b->high > key->upper)) {
        return murk_fail(err, MURK_BAD_VALUE, b->where,
                         "%.9g to %.9g, must be within %.9g to %.9g, what the "
                         "key may be",
                         b->low, b->high, key->lower, key->upper);
    }
    key->lower = fmax(key->lower, b->low);
    key->upper = fmin(key->upper, b->high);
    return MURK_OK;
}

/* Applies one bound to all parameters that the name of the bound means
 * (is_meant()). */
static murk_status apply(murk_free_keys *keys, const char *text,
                         murk_error *err)
{
    const char *known[MURK_FREE_MAX];
    bound b = {.key = ""};
    bool is_used = false;
    murk_status status = read_bound(&b, text, err);
    for (size_t k = 0; k < keys->n && !status; ++k) {
        known[k] = keys->key[k].name;
        if (is_meant(&keys->key[k], b.key)) {
            status = narrow(&keys->key[k], &b, err);
            is_used = true;
        }
    }
    if (status || is_used) {
        return status;
    }
    return murk_fail(err, MURK_BAD_VALUE, b.where, "%.200s is no free key%s",
                     b.key, murk_words_suggest(b.key, known, keys->n).text);
}

/* Checks the start value; the start of a factor of readings, which the scene
 * does not contain, is moved into the range. */
static murk_status check_start(murk_free_keys *keys, size_t k, murk_error *err)
{
    murk_free_key *key = &keys->key[k];
    if (key->gain != SIZE_MAX) { /* no scene says where it starts */
        key->start = fmin(fmax(key->start, key->lower), key->upper);
    }
    return key->start >= key->lower && key->start <= key->upper
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, key->source,
                           "starts at %.9g, must be within its bounds, %.9g to "
                           "%.9g; it starts at the value of %s in the scene",
                           key->start, key->lower, key->upper,
                           key->path[0] ? key->path : key->name);
}

murk_status murk_free_apply_bounds(murk_free_keys *keys, murk_error *err)
{
    const murk_free_desc *desc = &keys->desc;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < desc->n_bounds && !status; ++i) {
        status = apply(keys, desc->bounds[i], err);
    }
    for (size_t k = 0; k < keys->n && !status; ++k) {
        status = check_start(keys, k, err);
    }
    return status;
}
