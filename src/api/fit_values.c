/* Reads the values of a finished fit from its fit.json: the keys that the fit
 * was asked for follow from the names of its parameters, and the values become
 * the starts of the same keys. */
#include "api/fit_values.h"

#include "base/log.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static murk_status parameters_of(const murk_yaml **out, const murk_yaml *root,
                                 const char *path, murk_error *err)
{
    const murk_yaml *list =
        root->kind == MURK_YAML_MAP ? murk_yaml_get(root, "parameters") : NULL;
    if (!list || list->kind != MURK_YAML_LIST) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "has no list of parameters, must be the fit.json of a "
                         "fit");
    }
    if (list->n < 1 || list->n > MURK_FREE_MAX) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "%zu parameters, must be 1..%d", list->n,
                         MURK_FREE_MAX);
    }
    /* Each parameter needs a key and a number. */
    for (size_t i = 0; i < list->n; ++i) {
        const murk_yaml *item = list->child[i];
        const bool is_map = item->kind == MURK_YAML_MAP;
        const murk_yaml *key = is_map ? murk_yaml_get(item, "key") : NULL;
        const murk_yaml *value = is_map ? murk_yaml_get(item, "value") : NULL;
        double number;
        if (!key || key->kind != MURK_YAML_SCALAR || !value ||
            !murk_yaml_number(value, &number)) {
            char where[320];
            murk_yaml_place(item, where, sizeof where);
            return murk_fail(err, MURK_BAD_FILE, where,
                             "a parameter must have a key and a value");
        }
    }
    *out = list;
    return MURK_OK;
}

/* Lists in f->asked, each once, the keys that the finished fit was asked for: a
 * parameter "media.fog.visibility_m@dawn" was asked for as
 * "media.fog.visibility_m@each". */
static murk_status ask_for(murk_fit_values *f, const murk_yaml *list,
                           murk_error *err)
{
    for (size_t i = 0; i < list->n; ++i) {
        const char *name = murk_yaml_get(list->child[i], "key")->text;
        const size_t length = strcspn(name, "@");
        const size_t size = length + sizeof "@each";
        char *asked = malloc(size);
        if (!asked) {
            return murk_no_memory(err, "", "for the fit");
        }
        snprintf(asked, size, "%.*s%s", (int)length, name,
                 name[length] ? "@each" : "");
        bool is_new = true;
        for (size_t k = 0; is_new && k < f->n; ++k) {
            is_new = strcmp(f->asked[k], asked) != 0;
        }
        if (is_new) {
            f->asked[f->n++] = asked;
        } else {
            free(asked);
        }
    }
    return MURK_OK;
}

murk_status murk_fit_values_set(const murk_fit_values *f, murk_free_keys *keys,
                                murk_error *err)
{
    const murk_yaml *list = f->list;
    for (size_t k = 0; k < keys->n; ++k) {
        murk_free_key *key = &keys->key[k];
        /* The parameter of that name. */
        const murk_yaml *found = NULL;
        for (size_t i = 0; i < list->n; ++i) {
            const murk_yaml *item = list->child[i];
            if (strcmp(murk_yaml_get(item, "key")->text, key->name) == 0) {
                found = murk_yaml_get(item, "value");
            }
        }
        if (!found) {
            return murk_fail(err, MURK_BAD_FILE, f->path, "has no value of %s",
                             key->name);
        }
        /* The value becomes the start of the key, and must be within the limits
         * of the key. */
        (void)murk_yaml_number(found, &key->start);
        if (!(key->start >= key->lower && key->start <= key->upper)) {
            return murk_fail(err, MURK_BAD_VALUE, f->path,
                             "%s: %g, must be %g..%g", key->name, key->start,
                             key->lower, key->upper);
        }
    }
    return MURK_OK;
}

murk_status murk_fit_values_read(murk_fit_values *f, const char *path,
                                 murk_error *err)
{
    f->path = path;
    murk_status status = murk_yaml_read(&f->root, path, err);
    if (!status) {
        status = parameters_of(&f->list, f->root, path, err);
    }
    if (!status) {
        status = ask_for(f, f->list, err);
    }
    bool is_accepted = true;
    const murk_yaml *accepted =
        status ? NULL : murk_yaml_get(f->root, "accepted");
    if (accepted && murk_yaml_bool(accepted, &is_accepted) && !is_accepted) {
        murk_warn(path, MURK_REFUSED_VALUES);
    }
    return status;
}

void murk_fit_values_release(murk_fit_values *f)
{
    for (size_t i = 0; i < f->n; ++i) {
        free(f->asked[i]);
    }
    murk_yaml_destroy(f->root);
    *f = (murk_fit_values){0};
}
