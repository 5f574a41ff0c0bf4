/* Parses bounds "KEY=LOW:HIGH" and applies them to all parameters of that key.
 */
#include "calibrate/key_bounds.h"

#include "base/number.h"
#include "calibrate/free_parts.h"
#include "scene/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct bound {
    char key[240], low_text[40], high_text[40];
    char where[320]; /* "--bounds KEY=LOW:HIGH" */
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
    snprintf(out->where, sizeof out->where, "--bounds %s", shown);
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

/* True if the name of a bound means this parameter: KEY stands for "KEY",
 * "KEY@each" and "KEY@dawn". */
static bool is_meant(const murk_free_key *key, const char *name)
{
    const size_t length = strlen(key->path);
    return strcmp(name, key->name) == 0 ||
           (length > 0 && strncmp(name, key->path, length) == 0 &&
            (name[length] == '\0' || strcmp(name + length, "@each") == 0));
}

/* Narrows a range; the bound must lie in the range of the key. */
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

/* Applies one bound to all parameters that it means. */
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
    const char *meant = murk_words_meant(b.key, known, keys->n);
    return murk_fail(
        err, MURK_BAD_VALUE, b.where, "%.200s is no free key%s%s%s", b.key,
        meant ? ", did you mean " : "", meant ? meant : "", meant ? "?" : "");
}

/* Checks the start value; a factor of readings has no start in the scene, so it
 * is moved into the range. */
static murk_status check_start(murk_free_keys *keys, size_t k, murk_error *err)
{
    murk_free_key *key = &keys->key[k];
    if (key->gain != SIZE_MAX) { /* no scene says where it starts */
        key->start = fmin(fmax(key->start, key->lower), key->upper);
    }
    return key->start >= key->lower && key->start <= key->upper
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, keys->spot[k].source,
                           "starts at %.9g, must be within its bounds, %.9g to "
                           "%.9g; --set %s=VALUE starts elsewhere",
                           key->start, key->lower, key->upper,
                           key->path[0] ? key->path : key->name);
}

murk_status murk_key_bounds_apply(murk_free_keys *keys, murk_error *err)
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
